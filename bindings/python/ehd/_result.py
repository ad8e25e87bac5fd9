# SPDX-License-Identifier: GPL-3.0-or-later
"""What ehd_solve and ehd_bearing leave: from the library's result to a Python object."""

from __future__ import annotations

import ctypes
import json
from typing import Any

import numpy as np
import numpy.typing as npt

from ._case import CaseText, no_numbers
from ._library import CONVERGED, Ended, call, library
from ._record import Record
from .errors import InputError, NotConvergedError

Array = npt.NDArray[np.float64]


class Handle:
    """A result of the library, or the place for one; freed with this object. Several threads may read it at once."""

    def __init__(self) -> None:
        self._free = library().ehd_free  # there to the end, also while Python shuts down
        self.address = ctypes.c_void_p()

    def __del__(self) -> None:
        if hasattr(self, "address"):  # not where the library could not be loaded
            self._free(self.address)

    def json(self) -> dict[str, Any]:
        data: dict[str, Any] = json.loads(library().ehd_json(self.address))
        return data

    def field(self, name: str) -> Array:
        """A field over the nodes; empty where there is none of that name."""
        count = library().ehd_field(self.address, name.encode(), None, 0)
        values = np.empty(count)
        library().ehd_field(self.address, name.encode(), values.ctypes.data, count)
        return values


def run(function: str, case: CaseText, *arguments: Any) -> tuple[Handle, Ended]:
    """Calls ehd_solve or ehd_bearing. Raises InputError; NotConvergedError where there is not even a result."""
    handle = Handle()
    try:
        ended = call(function, case.text, *arguments, ctypes.byref(handle.address))
    except InputError as error:
        raise case.explain(error) from None
    if not handle.address:
        raise NotConvergedError(ended.line)
    return handle, ended


def require_converged(ended: Ended, result: Any) -> None:
    if ended.code != CONVERGED:
        raise NotConvergedError(ended.line, result)


def numbers(name: str, values: npt.ArrayLike) -> Array:
    """A new array of numbers, one row after the other in memory, as the library reads them. Raises InputError."""
    try:
        misfits = no_numbers(values)
        if misfits:
            raise TypeError(f"it has {misfits}")
        array = np.array(values, dtype=np.float64, order="C")
    except (TypeError, ValueError, OverflowError) as error:
        reason = " ".join(str(error).split())
        raise InputError(f"{name}: is no array of numbers ({reason}); allowed is a number, or numbers") from None
    if array.size == 0:
        raise InputError(f"{name}: is empty; allowed is a number, or numbers")
    return array


def read_only(values: Any) -> Any:
    values.setflags(write=False)
    return values


class Result(Record):
    """What ``ehd.solve`` and ``ehd.bearing`` return: the object that the program writes as JSON.

    ``status`` is ``"converged"``, ``"tolerance-not-met"`` (the best solution, with honest errors),
    ``"under-resolved"``, ``"limit-reached"`` or ``"diverged"``.
    """

    __slots__ = ()
