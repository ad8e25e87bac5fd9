# SPDX-License-Identifier: GPL-3.0-or-later
"""One allocation of the program finds no memory, each in turn. A limit on memory (memory.py) meets only a few."""

from room import Skipped, preloaded

TITLE = "one allocation without memory, each in turn"
SWEEP = 'case = "own-moes-20-10"\ncombine = "product"\n[keys]\n"moes.M" = [10.0, 20.0]\n'
PARTS = 5  # of a command's allocations; each is an input
# A command, and which of its allocations fail: every so-manieth.
COMMANDS = {
    "solve": (["solve", "--M", "20", "--L", "10", "--json", "a.json", "--profile", "a.csv"], 5),
    "solve, dense": (["solve", "--M", "20", "--L", "10", "--solver", "reference", "--tolerance", "1e-6"], 400),
    "response": (["response", "own-moes-5-5", "--omega", "1", "--json", "a.json", "--csv", "a.csv"], 100),
    "bearing": (["bearing", "na4908", "--dynamic", "--json", "a.json", "--csv", "a.csv", "--plot", "a.svg"], 3000),
    "sweep": (["sweep", "s.toml", "--output", "out", "--threads", "1"], 300),
    "convert": (["convert", "M=20", "L=10", "--json", "a.json"], 60),
    "new": (["new", "bearing", "a.toml"], 60),
}


def run(room, arguments, **variables):
    for name in room.files():
        if (room.path / name).is_file():
            (room.path / name).unlink()
    room.write("s.toml", SWEEP)
    return room.run(*arguments, environment={"LD_PRELOAD": preloaded("allocations.cpp"), **variables})


def allocations_of(room, arguments):
    """How many there are; None where the command fails by itself."""
    count = room.path / "count"
    ended = run(room, arguments, EHD_ALLOCATIONS=str(count))
    if not count.exists():
        raise Skipped("the program does not run under LD_PRELOAD (a sanitizer does not)")
    return int(count.read_text()) if ended.code == 0 else None


def wrong_with(room, ended):
    if ended.late:
        return "did not end in time"
    if ended.code not in (0, 1, 2):
        return f"ended by signal {-ended.code}" if ended.code < 0 else f"exit code {ended.code}"
    if "internal error" in ended.err:
        return "says internal error"
    left = [name for name in room.files() if ".partial-" in name]
    return f"leaves {left}" if left else None


def part_of(arguments, every, part):
    def attack(room):
        count = allocations_of(room, arguments)
        if count is None:
            return "does not even run with memory"
        for number in range(1 + part * every, count + 1, PARTS * every):
            ended = run(room, arguments, EHD_FAILS=str(number))
            if wrong := wrong_with(room, ended):
                return f"allocation {number} of {count}: {wrong}: {ended.err[:200]!r}"
        return None
    return attack


def inputs():
    for name, (arguments, every) in COMMANDS.items():
        for part in range(PARTS):
            yield f"{name}, part {part + 1} of {PARTS}", part_of(arguments, every, part)
