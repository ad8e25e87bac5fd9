# SPDX-License-Identifier: GPL-3.0-or-later
"""One line contact (`solve`), and the films of many (`films`)."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._case import PLAIN_OIL, CaseName, CaseText, Value, case_from, case_from_keywords, lines, number, utf8, whole, word
from ._library import STATUS, call
from ._result import Array, Result, numbers, read_only, require_converged, run
from .errors import InputError

_FILM_ARGUMENTS = ("M", "L", "tolerance", "threads", "raise_on_failure")  # of `films`, beside the keys of the oil
# The columns of `ehd solve --profile`.
_FIELDS = ("X", "P", "H", "rho", "eta", "x_m", "p_Pa", "h_m", "H_error", "P_unresolved",
           "P_error")


class Contact(Result):
    """A solved contact: the object that `ehd solve --json` writes, and the fields over X from inlet to exit.

    The fields are read-only float64 arrays of one length: ``X`` = x/b, ``P`` = p/p_H and ``H`` = h R/b^2 with the half
    width b and the pressure p_H of the dry contact; ``rho`` and ``eta``, relative to ambient pressure, where there is a
    lubricant; ``x_m``, ``p_Pa``, ``h_m`` where SI is known; ``H_error``, the relative error of the film,
    and ``P_error``, that of the pressure in the L2 norm, both NaN beside a spike of unknown height. ``P_unresolved`` is
    there where the largest pressure is not known. It is 1 at nodes where a spike of unknown height is cut at 1.5; rho
    and eta are NaN there. A diverged solve has no fields.
    """

    __slots__ = ("_fields",)

    def __init__(self, data: dict[str, Any], fields: dict[str, Array]) -> None:
        super().__init__(data)
        object.__setattr__(self, "_fields", {name: read_only(values) for name, values in fields.items()})

    def __getattr__(self, name: str) -> Any:
        if not name.startswith("_") and name in self._fields:
            return self._fields[name]
        return super().__getattr__(name)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._fields]

    def __reduce__(self) -> Any:
        return Contact, (self._data, self._fields)


def solve(case: Optional[CaseName] = None, *, solver: str = "fast", tolerance: float = 1e-3,
          raise_on_failure: bool = False, **statement: Value) -> Contact:
    """Solve one elastohydrodynamic line contact.

    Parameters
    ----------
    case
        Path of a case file, id of a benchmark case, or the text of a case. Else the contact is stated by keywords.
    solver
        ``"fast"``, ``"reference"`` (the certified one), or another name that `ehd solve --help` lists.
    tolerance
        Relative error allowed in the minimum and the central film.
    raise_on_failure
        Raise `NotConvergedError` where the status is not ``"converged"``.
    **statement
        Keys of a case file, in one of three ways:

        - ``M``, ``L``: Moes' groups [-], with the sum of the surface speeds;
        - ``load_N_per_m`` [N/m], ``reduced_radius_m`` [m], ``reduced_modulus_Pa`` [Pa] (E', with
          2/E' = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2), ``speed_sum_m_per_s`` [m/s] (u_1 + u_2), ``viscosity_Pa_s``
          [Pa s]; without speed, viscosity and keys of the lubricant the contact is dry;
        - ``lambda_``, ``alpha_p_H`` [-]: the groups in Hertz units;

        with ``inlet`` (``"flooded"``, or X = x/b where the oil begins; default ``"flooded"``) and the keys of
        ``[lubricant]``: ``viscosity`` (``"isoviscous"``, ``"barus"``, ``"roelands"``), ``density``
        (``"incompressible"``, ``"dowson-higginson"``), ``alpha_per_Pa`` [1/Pa], ``z`` [-], ``p0_Pa`` [Pa], ... With M
        and L they may be left out: Barus, incompressible. ``id`` and ``title`` name the result.

    Returns
    -------
    Contact
        Read by attribute, with the names of the JSON; and the fields ``X``, ``P``, ``H``.

    Raises
    ------
    InputError
        One line that says what is wrong and what is allowed.
    NotConvergedError
        With ``raise_on_failure``; its ``result`` is the contact.

    Examples
    --------
    >>> import ehd
    >>> r = ehd.solve(M=20, L=10, tolerance=1e-5)
    >>> r.status, round(r.film.minimum.hertz, 5)
    ('converged', 0.07808)
    >>> r.film.minimum.error <= 1e-5
    True
    >>> r.P.max() > 1 and r.X.shape == r.H.shape
    True

    In SI:

    >>> r = ehd.solve(load_N_per_m=1e5, reduced_radius_m=0.01, reduced_modulus_Pa=2.2e11, speed_sum_m_per_s=3.0,
    ...               viscosity_Pa_s=0.02, viscosity="roelands", density="dowson-higginson", alpha_per_Pa=2e-8)
    >>> f"{r.film.minimum.m:.2e} m at {r.groups.hertz_pressure_Pa:.2e} Pa"
    '2.18e-07 m at 5.92e+08 Pa'
    >>> ehd.solve(M=-1, L=10)
    Traceback (most recent call last):
    ehd.errors.InputError: M = -1: is negative; allowed is 0.001 to 1e6
    """
    if case is not None and statement:
        raise InputError(f"a case and keywords that state a contact exclude each other: {', '.join(statement)}")
    if case is None and not statement:
        raise InputError("the contact is missing; allowed is a case, or keywords such as M and L")
    text = case_from_keywords(statement) if case is None else case_from(case)
    handle, ended = run("ehd_solve", text, word("solver", solver), number("tolerance", tolerance))
    fields = {name: handle.field(name) for name in _FIELDS}
    contact = Contact(handle.json(), {name: values for name, values in fields.items() if values.size})
    if raise_on_failure:
        require_converged(ended, contact)
    return contact


@dataclasses.dataclass(frozen=True, eq=False)  # arrays have no one answer to ==
class Films:
    """The films of many contacts: arrays of one shape, read-only.

    ``dataclasses.asdict`` makes a dictionary; pandas.DataFrame takes it where the arrays have one dimension.
    """

    M: Array  #: Moes' load group [-]
    L: Array  #: Moes' lubricant group [-]
    minimum: Array  #: smallest film H = h R/b^2 [-]; NaN where there is none
    minimum_error: Array  #: its estimated relative error [-]
    central: Array  #: film at X = 0 [-]
    central_error: Array  #: its estimated relative error [-]
    status: npt.NDArray[np.str_]  #: how each solve ended: "converged", ...

    def __post_init__(self) -> None:
        for field in dataclasses.fields(self):
            read_only(getattr(self, field.name))

    def __reduce__(self) -> Any:  # a copy in another process is read-only too
        return Films, tuple(getattr(self, field.name) for field in dataclasses.fields(self))


def films(M: npt.ArrayLike, L: npt.ArrayLike, *, tolerance: float = 1e-3, threads: int = 0,
          raise_on_failure: bool = False, **lubricant: Value) -> Films:
    """The films of many fully flooded contacts with one lubricant, in threads.

    Parameters
    ----------
    M, L
        Moes' groups [-], with the sum of the surface speeds; arrays are broadcast.
    tolerance
        Relative error allowed in both films.
    threads
        How many; 0 takes one a core. The numbers do not depend on it.
    raise_on_failure
        Raise `NotConvergedError` where a status is not ``"converged"``.
    **lubricant
        Keys of ``[lubricant]``, as for `solve`; default: Barus, incompressible.

    Returns
    -------
    Films
        Arrays of the shape of M and L, broadcast.

    Examples
    --------
    >>> import ehd, numpy as np
    >>> t = ehd.films(M=np.geomspace(5, 500, 5), L=[[5], [10]], tolerance=1e-4, threads=2)
    >>> t.minimum.shape, bool((t.status == "converged").all())
    ((2, 5), True)
    >>> t.minimum[1].round(3)
    array([0.364, 0.101, 0.028, 0.008, 0.002])
    """
    groups = numbers("M", M), numbers("L", L)
    try:
        shape = np.broadcast_shapes(*(group.shape for group in groups))
    except ValueError:
        raise InputError(f"M, L: have the shapes {groups[0].shape} and {groups[1].shape}; allowed are shapes that can "
                         "be broadcast") from None
    given = [np.broadcast_to(group, shape).ravel() for group in groups]
    found = [np.full(given[0].size, np.nan) for _ in range(4)]
    status = np.zeros(given[0].size, dtype=np.intc)
    oil = utf8(lines({**PLAIN_OIL, **lubricant}), "the lubricant")
    addresses = [array.ctypes.data for array in (*given, *found, status)]
    try:
        ended = call("ehd_films", status.size, *addresses[:2], oil, number("tolerance", tolerance),
                     whole("threads", threads), *addresses[2:])
    except InputError as error:
        raise CaseText(oil, None, _FILM_ARGUMENTS).explain(error) from None
    words = np.array(STATUS)[status]
    result = Films(*(array.reshape(shape) for array in (*given, *found, words)))
    if raise_on_failure:
        require_converged(ended, result)
    return result
