# SPDX-License-Identifier: GPL-3.0-or-later
"""A fresh folder in which the program is run, and what every refusal has to look like."""

import atexit
import functools
import os
import pathlib
import shutil
import subprocess
import tempfile
from dataclasses import dataclass

LONGEST_S = 10  # for a refusal; most take 0.02 s
LONGEST_LINE = 4096  # of a message
MEMORY_BYTES = 1 << 30  # so that a file without end fails here and does not stop the machine


class Skipped(Exception):
    """This machine cannot make the fault; the text says why."""


@dataclass
class Ended:
    code: int  # negative: ended by that signal
    out: str
    err: str
    late: bool = False  # ended by the time limit


class Program:
    def __init__(self, path):
        self.path = str(pathlib.Path(path).resolve())
        self.limit = ["prlimit", f"--as={MEMORY_BYTES}"]
        # AddressSanitizer reserves terabytes of addresses and cannot run under the limit.
        if not shutil.which("prlimit") or self._fails([*self.limit, self.path, "--version"]):
            self.limit = []
        if self._fails([self.path, "--version"]):
            raise SystemExit(f"{path}: is not the program; allowed is the built ehd")

    @staticmethod
    def _fails(command, **how):
        return subprocess.run(command, capture_output=True, check=False, **how).returncode != 0

    def other_user(self):
        """The user for a file that may not be read: root may read everything. {} where this user is not root."""
        if os.geteuid() != 0:
            return {}
        other = {"user": "nobody", "extra_groups": []}
        try:
            if self._fails([self.path, "--version"], **other):
                raise Skipped("the user nobody cannot run the program")
        except (OSError, subprocess.SubprocessError, ValueError, LookupError) as error:
            raise Skipped(f"no other user than root: {error}") from error
        return other


@functools.cache
def preloaded(source):
    """The path of a library for LD_PRELOAD, made of a source file of this folder."""
    folder = tempfile.mkdtemp(prefix="ehd-preloaded-")
    atexit.register(shutil.rmtree, folder)
    library = pathlib.Path(folder, "preloaded.so")
    compiler = "cc" if source.endswith(".c") else "c++"
    subprocess.run([compiler, "-shared", "-fPIC", "-o", library, pathlib.Path(__file__).with_name(source), "-ldl"],
                   check=True)
    return str(library)


class Room:
    """A folder that goes at the end. The program runs in it."""

    def __init__(self, program):
        self.program = program

    def __enter__(self):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="ehd-faults-"))
        self.path.chmod(0o777)
        return self

    def __exit__(self, *error):
        for folder, _, _ in os.walk(self.path):
            os.chmod(folder, 0o777)
        shutil.rmtree(self.path)

    def write(self, name, content):
        """The path of a new file, relative to the room."""
        file = self.path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return name

    def files(self):
        return sorted(str(file.relative_to(self.path)) for file in self.path.rglob("*"))

    def run(self, *arguments, stdin=b"", user=None, seconds=LONGEST_S, environment=None):
        """`ehd ARGUMENTS`. user: what Program.other_user returned; environment: variables beside the usual ones."""
        command = [*self.program.limit, self.program.path, *map(str, arguments)]
        try:
            ended = subprocess.run(command, input=stdin, capture_output=True, cwd=self.path, timeout=seconds,
                                   check=False, env={**os.environ, **(environment or {})}, **(user or {}))
        except subprocess.TimeoutExpired as late:
            return Ended(0, (late.stdout or b"").decode(errors="replace"),
                         (late.stderr or b"").decode(errors="replace"), late=True)
        return Ended(ended.returncode, ended.stdout.decode(errors="replace"), ended.stderr.decode(errors="replace"))

    def refused(self, *arguments, codes=(2,), says=(), leaves=(), **how):
        """What is wrong with the refusal of `ehd ARGUMENTS`, or None. It has to be one line on standard error with
        every text of `says` and with what is allowed, an exit code of `codes`, nothing on standard output, and no new
        file but `leaves`."""
        before = self.files()
        ended = self.run(*arguments, **how)
        wrong = wrong_with(ended, codes)
        if ended.code == 2 and not any(word in ended.err for word in ("allowed", "required")):
            wrong.append("does not say what is allowed")
        wrong += [f"does not say {text!r}" for text in says if text not in ended.err]
        left = [file for file in self.files() if file not in before and file not in leaves]
        if left:
            wrong.append("leaves " + ", ".join(left[:3]))
        shown = " ".join(map(str, arguments))
        return f"ehd {shown[:200]}: {'; '.join(wrong)}: {ended.err.strip()[:300]!r}" if wrong else None


def faults_of_one_file(lines):
    """The faults of a file are named all at once, a line each, with what is allowed."""
    whole = all(" allowed " in line or " required " in line for line in lines)
    return lines and whole and len({line.split(":")[0] for line in lines}) == 1


def wrong_with(ended, codes):
    """The faults of an end that should be one line and an exit code of `codes`."""
    wrong = []
    if ended.late:
        return ["did not end in time"]
    if ended.code < 0:
        wrong.append(f"ended by signal {-ended.code}")
    elif ended.code not in codes:
        wrong.append(f"exit code {ended.code}")
    if ended.err.count("\n") != 1 and not faults_of_one_file(ended.err.splitlines()):
        wrong.append(f"{ended.err.count(chr(10))} lines on standard error")
    if any(len(line) > LONGEST_LINE for line in ended.err.splitlines()):
        wrong.append("says it in more than a person reads")
    if "internal error" in ended.err:
        wrong.append("says internal error")
    if ended.out and ended.code == 2:
        wrong.append("writes to standard output")
    return wrong
