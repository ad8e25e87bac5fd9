# SPDX-License-Identifier: GPL-3.0-or-later
"""The system refuses threads and processes (ulimit -u)."""

import os
import resource
import subprocess

TITLE = "refused threads and processes"
SWEEP = 'case = "na4908"\nlaws = ["hertz"]\ncombine = "product"\n' \
        '[keys]\n"operation.radial_load_N" = [1e3, 2e3, 3e3, 4e3]\n'
TIME_S = 50
NOBODY = 65534
# Command, exit codes, text that must be there, texts that must not.
COMMANDS = {
    "sweep": (["sweep", "s.toml", "--output", "out", "--threads", "4"], (0,), "on 1 thread", ()),
    "verify": (["verify", "--quick", "--rung", "2"], (0,), "", ()),
    "bench": (["bench", "--part", "scaling", "--quick"], (1,), "not one size was measured", ()),
    "bench, whole processes": (["bench", "--part", "cost", "--quick"], (1,), "no process", ("internal error",)),
    "stress": (["stress", "--part", "h", "--quick"], (1,), "inconclusive", ("fail",)),
    "compare --external": (["compare", "own-moes-5-5", "--solver", "fast", "--tolerance", "1e-1", "--external",
                            "mine=true {case} {out}"], (1,), "could not be started: no process",
                           ("internal error", "time limit", "idle call")),
    "solve --plot": (["solve", "--M", "20", "--L", "10", "--plot", "a.png"], (2,), "allowed", ("internal error",)),
}


def refused(arguments, codes, says, never):
    def attack(room):
        room.write("s.toml", SWEEP)
        room.program.other_user()  # raises Skipped where there is none

        def limit():
            if os.geteuid() == 0:  # root has no limit
                os.setgid(NOBODY)
                os.setuid(NOBODY)
            resource.setrlimit(resource.RLIMIT_NPROC, (0, 0))
        try:
            ended = subprocess.run([room.program.path, *arguments], cwd=room.path, capture_output=True,
                                   preexec_fn=limit, timeout=TIME_S, check=False)
        except subprocess.TimeoutExpired:
            return "did not end in time"
        text = (ended.stdout + ended.stderr).decode(errors="replace")
        if ended.returncode not in codes:
            return f"exit code {ended.returncode}: {text[-300:]!r}"
        if says not in text:
            return f"does not say {says!r}: {text[-300:]!r}"
        return next((f"says {word!r}: {text[-300:]!r}" for word in never if word in text), None)
    return attack


def inputs():
    for name, what in COMMANDS.items():
        yield name, refused(*what)
