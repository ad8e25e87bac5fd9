# SPDX-License-Identifier: GPL-3.0-or-later
"""A roller bearing: how the load is shared, and the contact force laws behind it."""

from __future__ import annotations

import warnings
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._case import CaseName, CaseText, case_from, did_you_mean, shown, word
from ._library import CONVERGED, call
from ._result import Array, Handle, Result, numbers, read_only, require_converged, run
from .errors import InputError, NotConvergedError


def _require_raceway(raceway: object) -> None:
    if not isinstance(raceway, str) or raceway not in ("inner", "outer"):
        meant = did_you_mean(raceway, ("inner", "outer")) if isinstance(raceway, str) else ""
        raise InputError(f"raceway = {shown(raceway)}: is unknown; {meant}allowed is inner, outer")


class Law:
    """The contact force law of one raceway, as the bearing was balanced with. Arrays of any shape are accepted.

    Examples
    --------
    >>> import ehd
    >>> law = ehd.bearing("na4908", law="hertz").law("inner")
    >>> law.force([1e-6, 2e-6]).round()
    array([2676., 5781.])
    >>> f"{law.stiffness(2e-6):.2e} N/m"
    '3.21e+09 N/m'
    """

    def __init__(self, handle: Handle, raceway: str) -> None:
        self._handle, self._raceway = handle, raceway

    def force(self, approach_m: npt.ArrayLike) -> Array:
        """Contact force; 0 where the contact is unloaded.

        Warns where a force lies outside the range that the law is meant for.

        Parameters
        ----------
        approach_m
            Approaches of the two bodies [m].

        Returns
        -------
        numpy.ndarray
            Force [N] at each approach.
        """
        return self._at(approach_m)[0]

    def stiffness(self, approach_m: npt.ArrayLike) -> Array:
        """Slope of the force over the approach; warns like `force`.

        Parameters
        ----------
        approach_m
            Approaches of the two bodies [m].

        Returns
        -------
        numpy.ndarray
            Stiffness [N/m] at each approach.
        """
        return self._at(approach_m)[1]

    def _at(self, approach_m: npt.ArrayLike) -> tuple[Array, Array]:
        given = numbers("approach_m", approach_m)
        force, stiffness = np.full(given.shape, np.nan), np.full(given.shape, np.nan)
        ended = call("ehd_law", self._handle.address, self._raceway.encode(), given.size, given.ctypes.data,
                     force.ctypes.data, stiffness.ctypes.data)
        if ended.code != CONVERGED:
            if np.isnan(force).all():  # the library left them alone: there is no law
                raise NotConvergedError(ended.line)
            warnings.warn(ended.line, RuntimeWarning, stacklevel=3)
        return force, stiffness


class Bearing(Result):
    """A balanced bearing: the object that `ehd bearing --json` writes, without its error budget.

    ``rollers`` is a read-only structured array, one row a roller: ``azimuth_deg``, and for ``inner`` and ``outer``
    ``force_N``, ``displacement_m`` and, where they are known, ``film_minimum_m``, ``hertz_pressure_Pa``,
    ``lambda_ratio``; NaN where a roller has none. ``bearing["rollers"]`` is the list of the JSON, ``bearing["law"]``
    the name of the law. With the law "ehd", ``bearing["errors"]`` has the numerical errors: ``displacement_m`` and
    ``displacement_lateral_m`` [m], ``largest_force_N`` and ``any_force_N`` [N], ``smallest_film_relative``.
    """

    __slots__ = ("_case", "_handle")

    def __init__(self, data: dict[str, Any], case: CaseText, handle: Optional[Handle] = None) -> None:
        super().__init__(data)
        object.__setattr__(self, "_case", case)
        object.__setattr__(self, "_handle", handle)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), "law"]

    def __reduce__(self) -> Any:
        return Bearing, (self._data, self._case)

    @property
    def rollers(self) -> Any:
        """One row a roller."""
        return _table(self._data.get("rollers", []))

    def law(self, raceway: str) -> Law:
        """The contact force law of a raceway.

        Parameters
        ----------
        raceway
            ``"inner"`` or ``"outer"``.

        Returns
        -------
        Law
            Force and stiffness over the approach.

        Notes
        -----
        A bearing that came from another process is balanced again at the first call, with the same numbers.
        """
        _require_raceway(raceway)
        handle: Optional[Handle] = self._handle
        if handle is None:
            handle, _ = run("ehd_bearing", self._case, self["law"].encode())
            object.__setattr__(self, "_handle", handle)
        return Law(handle, raceway)


def _table(rollers: list[dict[str, Any]]) -> Any:
    """The rollers of the JSON as a record array, a column for every number that some roller has."""
    def columns(rows: list[dict[str, Any]]) -> list[str]:
        return list(dict.fromkeys(name for row in rows for name in row))

    kinds: list[Any] = []
    for name in columns(rollers):
        parts = [row[name] for row in rollers if isinstance(row.get(name), dict)]
        kinds.append((name, [(part, np.float64) for part in columns(parts)] if parts else np.float64))
    table = np.full(len(rollers), np.nan, dtype=kinds)
    for row, roller in zip(table, rollers):
        for name, value in roller.items():
            if isinstance(value, dict):
                for part, number in value.items():
                    row[name][part] = number
            else:
                row[name] = value
    return read_only(table.view(np.recarray))


def bearing(case: CaseName, law: str = "ehd", *, raise_on_failure: bool = False) -> Bearing:
    """Balance one roller bearing with one contact force law.

    Parameters
    ----------
    case
        Path of a bearing case, id of a benchmark case, or the text of a case.
    law
        ``"hertz"`` or ``"iso"`` (dry), ``"ehd-linear"`` (a straight line fitted to contacts with films), ``"ehd"`` (the
        film as solved), or another name that `ehd bearing --help` lists.
    raise_on_failure
        Raise `NotConvergedError` where the status is not ``"converged"``.

    Returns
    -------
    Bearing
        Read by attribute, with the names of the JSON.

    Raises
    ------
    InputError
        One line that says what is wrong and what is allowed.

    Examples
    --------
    >>> import ehd
    >>> dry = ehd.bearing("na4908", law="hertz")
    >>> f"{dry.displacement_m:.3e} m, {dry.loaded_rollers} rollers carry"
    '6.138e-06 m, 11 rollers carry'
    >>> f"{dry.rollers.inner.force_N[0]:.0f} N"
    '9289 N'
    >>> f"{dry.law('inner').force(2e-6):.0f} N"
    '5781 N'
    """
    text = case_from(case)
    handle, ended = run("ehd_bearing", text, word("law", law))
    balanced = Bearing(handle.json(), text, handle)
    if raise_on_failure:
        require_converged(ended, balanced)
    return balanced
