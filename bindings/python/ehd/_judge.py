# SPDX-License-Identifier: GPL-3.0-or-later
"""Other people's solvers against the certified digits: the program `ehd judge`."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
from typing import Any, Union

from ._case import file_name, shown
from ._library import BAD_INPUT, prefix
from ._record import Record
from .errors import InputError


def _program() -> str:
    """EHD_PROGRAM; else the program of the installation or of the source tree; else the first one in PATH."""
    named = os.environ.get("EHD_PROGRAM")
    if named:
        return named
    for folder in ("bin", "build"):
        if os.access(prefix() / folder / "ehd", os.X_OK):
            return str(prefix() / folder / "ehd")
    found = shutil.which("ehd")
    if found is None:
        raise FileNotFoundError("the program ehd is not found; EHD_PROGRAM may name the file")
    return found


def _file(submission: Any) -> str:
    allowed = "the path of a submission"
    name = file_name("submission", submission, allowed)
    if not name or "\0" in name:
        raise InputError(f"submission = {shown(submission)}: is no path; allowed is {allowed}")
    return str(pathlib.Path(name))


def judge(*submissions: Union[str, "os.PathLike[str]"]) -> Any:
    """Score submissions against the certified digits.

    Parameters
    ----------
    *submissions
        Files of the schema ``ehd-submission-1`` (JSON or CSV; docs/judge.md).

    Returns
    -------
    Record
        The object that `ehd judge FILE... --json -` writes, read by attribute. A failed gate is not an error.

    Raises
    ------
    InputError
        The program's line about a file that it refuses.

    Examples
    --------
    >>> import ehd
    >>> judged = ehd.judge("cases/submissions/ehd-fast-1e-6.json")
    >>> judged.gates_hold, judged.honesty.missed
    (True, 0)
    """
    command = [_program(), "judge", "--json", "-", "--", *map(_file, submissions)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode == BAD_INPUT:
        raise InputError(done.stderr.strip())
    if done.returncode not in (0, 1) or not done.stdout:
        raise RuntimeError(f"ehd judge ended with {done.returncode}: {done.stderr.strip()}")
    data = json.loads(done.stdout)
    return tuple(Record(one) for one in data) if isinstance(data, list) else Record(data)
