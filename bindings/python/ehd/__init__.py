# SPDX-License-Identifier: GPL-3.0-or-later
"""Elastohydrodynamic line contacts and the roller bearings that run on them, each number with its error.

>>> import ehd
>>> r = ehd.solve(M=20, L=10)
>>> r.film
Record(minimum, central, couette, offset)
"""

from typing import TYPE_CHECKING

from . import plot
from ._bearing import Bearing, Law, bearing
from ._contact import Contact, Films, films, solve
from ._judge import judge
from ._library import version
from ._record import Record
from ._result import Result
from .errors import InputError, NotConvergedError

__all__ = [
    "Bearing", "Contact", "Films", "InputError", "Law", "NotConvergedError", "Record", "Result",
    "bearing", "films", "judge", "plot", "solve", "version",
]

if TYPE_CHECKING:
    __version__: str
else:
    def __getattr__(name: str) -> str:
        if name == "__version__":  # "0.2.0"; asked for at its first use, because that loads the library
            return version().split()[0]
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
