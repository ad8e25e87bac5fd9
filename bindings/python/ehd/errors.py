# SPDX-License-Identifier: GPL-3.0-or-later
"""What the package raises."""

from __future__ import annotations

from typing import Any


class InputError(ValueError):
    """The input is wrong: one line that says what, where, and what is allowed, as the program prints it."""


class NotConvergedError(RuntimeError):
    """A solve did not converge, and the caller asked for an exception (``raise_on_failure=True``).

    Attributes
    ----------
    result
        What the function would have returned: its ``status`` says how the solve ended. None if memory ran out.
    """

    def __init__(self, line: str, result: Any = None) -> None:
        super().__init__(line, result)
        self.result = result

    def __str__(self) -> str:
        return str(self.args[0])
