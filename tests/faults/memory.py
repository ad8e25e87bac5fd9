# SPDX-License-Identifier: GPL-3.0-or-later
"""Limits on the address space (ulimit -v), a ladder of them for every command."""

import functools
import resource
import subprocess

from room import Ended, Skipped, wrong_with

TITLE = "little memory: a ladder of ulimit -v over the commands"
KB = 1024
LOADER_FAILED = 127  # the dynamic loader could not map a library; the program has not begun
TIME_S = 180  # the slowest of these takes 17 s, and four times that beside other work

SWEEP = 'case = "own-moes-20-10"\ncombine = "product"\n[keys]\n"moes.M" = [10.0, 20.0, 30.0]\n'
MINE = "case,version,quantity,value,scaling,stated_error\nown-moes-20-10,1,film.minimum,0.0742,hertz,1e-3\n"
BIG = ["solve", "--M", "20", "--L", "10", "--solver", "fast.uniform", "--nodes"]
# Command, then the steps of the ladder in kB above the smallest limit at which --version runs.
LADDERS = {
    "cases": (["cases"], (0, 500, 1000, 2000)),
    "plan": (["plan", "na4908"], (0, 500, 1000, 2000)),
    "solve": (["solve", "--M", "20", "--L", "10", "--json", "a.json"], (0, 500, 1000, 1500, 2000, 3000, 5000)),
    "solve, FFT of 1e5": ([*BIG, "50000"], tuple(range(0, 30000, 2000))),
    "solve, FFT of 1e6": ([*BIG, "500000"], (*range(24000, 40000, 800), 80000)),
    "solve, dense": (["solve", "--M", "20", "--L", "10", "--solver", "reference"], (0, 1000, 3000, 10000)),
    "bearing": (["bearing", "na4908", "--law", "ehd-linear"], (0, 500, 1000, 2000, 4000)),
    "sweep": (["sweep", "s.toml", "--output", "out", "--threads", "2"], (0, 1000, 2000, 4000, 8000, 80000)),
    "verify": (["verify", "--quick", "--rung", "1", "--output", "out"], (0, 2000, 8000)),
    "verify, exact solutions": (["verify", "--quick", "--rung", "5", "--output", "out"], (19200, 26400)),
    "compare": (["compare", "own-moes-20-10", "--tolerance", "1e-2"], (0, 1000, 4000, 10000)),
    "statements": (["statements", "--json", "a.json"], (0, 1000)),
    "atlas --motion": (["atlas", "--motion", "--only", "roelands-m20-l10", "--output", "out"], (0, 2000)),
    "atlas": (["atlas", "--only", "roelands-m20-l10-", "--output", "out"], (0, 2000, 8000)),
    "bench": (["bench", "--part", "convolution", "--output", "out"], (0, 500, 2000)),
    "stress": (["stress", "--quick", "--part", "h", "--output", "out"], (0, 2000)),
    "stress in processes": (["stress", "--quick", "--part", "d"], (4000, 10000, 14000)),
    "maps": (["maps", "--output", "out"], (0, 1000, 4000)),
    "report": (["report", "."], (0, 1000)),
    "response": (["response", "own-moes-20-10", "--omega", "1", "--json", "a.json"], (0, 500, 1000, 2000, 4000)),
    "response, dense": (["response", "own-moes-20-10", "--solver", "reference"], (0, 1000, 4000, 16000)),
    "bearing --dynamic": (["bearing", "na4908", "--law", "ehd", "--dynamic", "--json", "a.json"],
                          (0, 1000, 2000, 4000, 8000)),
    "export law": (["export", "law", "na4908", "--raceway", "inner", "--output", "law.csv"], (0, 1000, 4000)),
    "export films": (["export", "films", "own-moes-20-10", "--M", "15:25", "--L", "8:10", "--tolerance", "1e-2",
                      "--output", "films.c"], (0, 1000, 4000)),
    "judge": (["judge", "mine.csv", "--output", "out"], (0, 500, 2000)),
    "convert": (["convert", "M=20", "L=10"], (0, 500, 1000)),
    "new": (["new", "bearing", "a.toml"], (0, 500, 1000)),
    "sweep --merge": (["sweep", "s.toml", "--output", "done", "--merge"], (0, 500, 2000, 8000)),
    "compare --external": (["compare", "own-moes-20-10", "--solver", "fast", "--tolerance", "1e-2", "--external",
                            "mine=true {case} {out}"], (0, 1000, 4000)),
}


def run_with(program, kilobytes, *arguments, folder=None):
    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (kilobytes * KB, kilobytes * KB))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        ended = subprocess.run([program.path, *arguments], capture_output=True, cwd=folder, preexec_fn=limit,
                               timeout=TIME_S, check=False)
    except subprocess.TimeoutExpired:
        return Ended(0, "", "", late=True)
    return Ended(ended.returncode, ended.stdout.decode(errors="replace"), ended.stderr.decode(errors="replace"))


@functools.cache
def smallest(program):
    """The smallest limit [kB] at which the program begins."""
    few, enough = 1000, 4000000
    if run_with(program, enough, "--version").code != 0:
        raise Skipped("the program needs more addresses than 4 GB (a sanitizer does)")
    while enough - few > 100:
        middle = (few + enough) // 2
        if run_with(program, middle, "--version").code == 0:
            enough = middle
        else:
            few = middle
    return enough


@functools.cache
def help_of(program, command):
    return subprocess.run([program.path, command, "--help"], capture_output=True, check=False).stdout.decode()


def foreign_advice(program, ended, command):
    """Options that a message names and the command does not have."""
    words = {word.strip(";,.:") for word in ended.err.split() if word.startswith("--")}
    return sorted(word for word in words if word not in help_of(program, command))


def ladder(arguments, step):
    def attack(room):
        room.write("s.toml", SWEEP)
        room.write("mine.csv", MINE)
        if "--merge" in arguments:
            room.run("sweep", "s.toml", "--output", "done", "--shard", "1/1")
        limit = smallest(room.program) + step
        ended = run_with(room.program, limit, *arguments, folder=room.path)
        if ended.late:
            return f"ulimit -v {limit}: did not end in {TIME_S} s"
        if ended.code in (0, LOADER_FAILED):
            return None
        wrong = wrong_with(ended, (1, 2)) if ended.err.count("\n") <= 1 else []
        foreign = foreign_advice(room.program, ended, arguments[0])
        if foreign:
            wrong.append(f"advises {foreign}, which the command does not have")
        if ended.code < 0:
            wrong = [f"ended by signal {-ended.code}"]
        if "\n  fail" in ended.out:  # as ehd verify and ehd stress begin such lines
            wrong.append("calls it a fail")
        if "internal error" in ended.err:
            wrong.append("says internal error")
        left = [file for file in room.files() if ".partial-" in file]
        if left:
            wrong.append(f"leaves {left}")
        return f"ulimit -v {limit}: {'; '.join(wrong)}: {ended.err[:200]!r}" if wrong else None
    return attack


def inputs():
    for name, (arguments, steps) in LADDERS.items():
        for step in steps:
            yield f"{name}, {step} kB more than it needs to begin", ladder(arguments, step)
