# SPDX-License-Identifier: GPL-3.0-or-later
"""libehd.so.0: where it is found, what its functions take, and how a call is made (ehd/ehd.h documents them)."""

from __future__ import annotations

import contextlib
import ctypes
import functools
import os
import pathlib
import signal
import threading
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_void_p
from typing import Any, Iterator, NamedTuple

from .errors import InputError

NAME = "libehd.so.0"
CONVERGED, BAD_INPUT = 0, 2  # return values
# The words of "status", by the numbers of ehd_films.
STATUS = ("converged", "tolerance-not-met", "under-resolved", "limit-reached", "diverged")

_Callback = ctypes.CFUNCTYPE(c_int, c_double, c_void_p)
# Arrays are handed over by their address.
_SIGNATURES: dict[str, tuple[Any, list[Any]]] = {
    "ehd_version": (c_char_p, []),
    "ehd_last_error": (c_char_p, []),
    "ehd_solve": (c_int, [c_char_p, c_char_p, c_double, POINTER(c_void_p)]),
    "ehd_bearing": (c_int, [c_char_p, c_char_p, POINTER(c_void_p)]),
    "ehd_field": (c_size_t, [c_void_p, c_char_p, c_void_p, c_size_t]),
    "ehd_json": (c_char_p, [c_void_p]),
    "ehd_free": (None, [c_void_p]),
    "ehd_films": (c_int, [c_size_t, c_void_p, c_void_p, c_char_p, c_double, c_int] + [c_void_p] * 5),
    "ehd_law": (c_int, [c_void_p, c_char_p, c_size_t, c_void_p, c_void_p, c_void_p]),
    "ehd_set_progress": (None, [_Callback, c_void_p]),
}

_package = pathlib.Path(__file__).resolve().parent


def prefix() -> pathlib.Path:
    """PREFIX of PREFIX/lib/python3/dist-packages/ehd; of bindings/python/ehd the source tree."""
    return _package.parents[2 if _package.parents[1].name == "bindings" else 3]


def _candidates() -> Iterator[str]:
    named = os.environ.get("EHD_LIBRARY")
    if named:
        yield named
        return
    for folder in (_package, prefix() / "lib", prefix() / "build"):
        if (folder / NAME).exists():
            yield str(folder / NAME)
    yield NAME  # the loader's own folders


@functools.lru_cache(maxsize=None)
def library() -> ctypes.CDLL:
    """The library, loaded at its first use.

    Found by the environment variable EHD_LIBRARY (a file, and then no other is tried); beside this package, in the
    prefix where both are installed, or in the folder ``build`` of the source tree; or by the system's loader.
    """
    failures = []
    for name in _candidates():
        try:
            loaded = ctypes.CDLL(name)
            break
        except OSError as error:
            failures.append(str(error))
    else:
        raise ImportError(
            f"{NAME} cannot be loaded: {'; '.join(failures)}. In the source tree make library builds it; EHD_LIBRARY "
            "may name the file")
    for function, (returns, takes) in _SIGNATURES.items():
        getattr(loaded, function).restype = returns
        getattr(loaded, function).argtypes = takes
    return loaded


def version() -> str:
    """Version of the library, with its commit and the libraries it is built on.

    Returns
    -------
    str
        One line.

    Examples
    --------
    >>> import ehd
    >>> ehd.version()  # doctest: +ELLIPSIS
    '... (..., FFTW 3..., Eigen 3...)'
    """
    return str(library().ehd_version().decode())


@contextlib.contextmanager
def _ended_by_interrupt() -> Iterator[None]:
    """Ctrl-C cancels the call inside; what Ctrl-C usually does, KeyboardInterrupt, is done after the call.

    Signals arrive in the main thread alone. The progress callback runs in the thread of the call, and there Python
    gets the time to see a signal.
    """
    in_main = threading.current_thread() is threading.main_thread()
    usual = signal.getsignal(signal.SIGINT) if in_main else None
    if not callable(usual):
        yield
        return
    pressed: list[tuple[int, Any]] = []
    callback = _Callback(lambda done, user: len(pressed))
    signal.signal(signal.SIGINT, lambda number, frame: pressed.append((number, frame)))
    library().ehd_set_progress(callback, None)
    try:
        yield
    finally:
        library().ehd_set_progress(_Callback(0), None)
        signal.signal(signal.SIGINT, usual)
    if pressed:
        usual(*pressed[0])


class Ended(NamedTuple):
    """How a call ended."""

    code: int
    line: str  # why, where it is not CONVERGED


def call(name: str, *arguments: Any) -> Ended:
    """Calls a function that returns an exit code. Other Python threads run meanwhile. Raises InputError."""
    function = getattr(library(), name)
    with _ended_by_interrupt():
        code = int(function(*arguments))
        line = library().ehd_last_error().decode(errors="replace")
    if code == BAD_INPUT:
        raise InputError(line)
    return Ended(code, line)
