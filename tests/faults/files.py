# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of wrong kinds wherever the program reads or writes one."""

import os
import shutil

from room import wrong_with

TITLE = "files: pipes, devices, folders, loops, no permission, ..."

SWEEP = """case = "na4908"
laws = ["hertz"]
combine = "zip"
[keys]
"operation.radial_load_N" = [1e3, 2e3]
"""
LONG_NAME = "n" * 300
HUGE_BYTES = 3 << 30  # a sparse file


def fifo(path):
    os.mkfifo(path)


def zero(path):
    path.symlink_to("/dev/zero")


def folder(path):
    path.mkdir()


def loop(path):
    path.symlink_to(path.name)


def unreadable(path):
    path.write_bytes(b"{}\n")
    path.chmod(0)


def binary(path):
    path.write_bytes(bytes(range(256)) * 4)


def empty(path):
    path.write_bytes(b"")


def huge(path):
    path.write_bytes(b"")
    os.truncate(path, HUGE_BYTES)


def missing(path):
    del path


NO_FILE = [fifo, zero, folder, loop, unreadable]
NO_TEXT = [*NO_FILE, binary, empty, huge]

# What reads the file: the name of the file, the arguments, and the kinds that are refused there. A journal with
# damaged lines is no fault: its rows are computed again; nor is an empty file for --wisdom, nor one that is missing.
READERS = {
    "solve CASE": ("c.toml", ["solve", "c.toml"], [*NO_TEXT, missing]),
    "bearing CASE": ("c.toml", ["bearing", "c.toml"], [*NO_TEXT, missing]),
    "plan CASE": ("c.toml", ["plan", "c.toml"], [*NO_TEXT, missing]),
    "compare CASE": ("c.toml", ["compare", "c.toml"], [*NO_TEXT, missing]),
    "verify --case": ("c.toml", ["verify", "--case", "c.toml"], [*NO_TEXT, missing]),
    "sweep FILE": ("c.toml", ["sweep", "c.toml"], [*NO_TEXT, missing]),
    "sweep: case": ("c.toml", ["sweep", "of-c.toml"], [*NO_TEXT, missing]),
    "report: results": ("d/results.json", ["report", "d"], [*NO_TEXT, missing]),
    "report: bench": ("d/bench.json", ["report", "d"], NO_TEXT),
    "report: stress": ("d/stress.json", ["report", "d"], NO_TEXT),
    "solve --wisdom": ("w", ["solve", "--M", "20", "--L", "10", "--wisdom", "w"], [*NO_FILE, binary, huge]),
    "sweep: journal": ("o/rows/journal", ["sweep", "s.toml", "--output", "o"], NO_FILE),
    "sweep: shard": ("o/shards/1-of-1/journal", ["sweep", "s.toml", "--output", "o", "--shard", "1/1"], NO_FILE),
    "sweep: merge": ("o/shards/1-of-1/journal", ["sweep", "s.toml", "--output", "o", "--merge"],
                     [*NO_TEXT, missing]),
    "atlas: table": ("o/atlas.csv", ["atlas", "--only", "roelands-m20-l10-", "--output", "o"], NO_TEXT),
    "response CASE": ("c.toml", ["response", "c.toml"], [*NO_TEXT, missing]),
    "export CASE": ("c.toml", ["export", "law", "c.toml", "--raceway", "inner"], [*NO_TEXT, missing]),
    "judge": ("mine.csv", ["judge", "mine.csv"], [*NO_TEXT, missing]),
    "judge: JSON": ("mine.json", ["judge", "mine.json"], [*NO_TEXT, missing]),
    "atlas: motion": ("o/kappa.csv", ["atlas", "--motion", "--only", "roelands-m1-l5-", "--output", "o"], NO_TEXT),
    "maps": ("k/atlas/atlas.csv", ["maps"], [*NO_TEXT, missing]),
    "cases": ("k/c.toml", ["cases"], NO_TEXT),
    "cases: references": ("k/references.bib", ["cases"], NO_FILE),  # no file at all: no entries
}

# What an external solver leaves where its submission should be, as a command, and what is said of it.
SUBMISSIONS = {
    "a pipe": ("mkfifo {out}", "is not a regular file"),
    "a device": ("ln -s /dev/zero {out}", "is not a regular file"),
    "a folder": ("mkdir {out}", "is a directory"),
    "a loop of links": ("ln -s {out} {out}", "left no submission"),
    "a huge file": ("truncate -s 3G {out}", "is larger than"),
    "bytes that are no text": ("printf '\\000\\001' > {out}", "is binary"),
    "an empty file": (": > {out}", "is no JSON"),
    "nothing": ("true", "left no submission"),
    "a number that is out of range": ("echo '{\"a\": 1e400}' > {out}", "is out of range"),
}

# Outputs that cannot be written: the arguments before the name of the file.
SOLVE = ["solve", "--M", "20", "--L", "10"]
OUTPUTS = {
    "--json": [*SOLVE, "--json"],
    "--profile": [*SOLVE, "--profile"],
    "--plot": [*SOLVE, "--plot"],
    "--wisdom": [*SOLVE, "--wisdom"],
    "bearing --json": ["bearing", "na4908", "--law", "hertz", "--json"],
    "verify --output": ["verify", "--rung", "3", "--output"],
    "sweep --output": ["sweep", "s.toml", "--output"],
}


# The program's own files in a folder that it fills.
IN_FOLDER = {
    "sweep": (["sweep", "s.toml", "--output", "o"], ["rows.csv", "rows.json", "cost.json"]),
    "verify": (["verify", "--rung", "3", "--output", "o"], ["results.json"]),
    "bench": (["bench", "--part", "scaling", "--output", "o"], ["bench.json", "scaling.csv"]),
    "stress": (["stress", "--quick", "--part", "e", "--output", "o"], ["stress.json"]),
    "report": (["report", "o"], ["report.html"]),
}


def reading(name, arguments, kind):
    def attack(room):
        room.write("s.toml", SWEEP)
        room.write("of-c.toml", SWEEP.replace("na4908", "./c.toml"))
        for made in ("d", "k"):
            (room.path / made).mkdir()
        if name.startswith("d/") and name != "d/results.json":
            room.write("d/results.json", '{"schema": 2}')
        if name.startswith("k/") and name != "k/references.bib":
            room.write("k/references.bib", "")
        if name == "k/references.bib":
            shutil.copy(os.path.join(os.path.dirname(__file__), "../../cases/dry-steel.toml"), room.path / "k")
        path = room.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.parent.chmod(0o777)
        kind(path)
        how = {"environment": {"EHD_CASES": "k"}} if name.startswith("k/") else {}
        if kind is unreadable:
            how["user"] = room.program.other_user()
        return room.refused(*arguments, **how)
    return attack


def submission(command, says):
    """The row of the solver is empty, the reason is one line, and the other rows stand."""
    def attack(room):
        left = "mine=true {case} {tolerance} {out}; " + command
        ended = room.run("compare", "own-moes-5-5", "--solver", "fast", "--tolerance", "1e-1", "--external", left)
        wrong = wrong_with(ended, codes=(1,))
        wrong += [f"does not say {says!r}"] if says not in ended.err else []
        wrong += ["has no row of fast"] if "\n  fast" not in ended.out else []
        return f"{left}: {'; '.join(wrong)}: {ended.err.strip()[:300]!r}" if wrong else None
    return attack


def temporary_folder(name):
    """What `compare --external` makes for the other solver, where there is no such folder."""
    def attack(room):
        room.write("a-file", "")
        return room.refused("compare", "own-moes-5-5", "--solver", "fast", "--tolerance", "1e-1", "--external",
                            "mine=true {case} {out}", environment={"TMPDIR": name}, says=["TMPDIR"])
    return attack


def in_long_name(arguments):
    def attack(room):
        room.write("s.toml", SWEEP)
        return room.refused(*arguments, LONG_NAME)
    return attack


def in_closed_folder(arguments):
    def attack(room):
        room.write("s.toml", SWEEP)
        (room.path / "closed").mkdir()
        (room.path / "closed").chmod(0o555)
        return room.refused(*arguments, "closed/new", user=room.program.other_user())
    return attack


def in_hidden_folder(arguments):
    def attack(room):
        room.write("s.toml", SWEEP)
        (room.path / "hidden").mkdir()
        (room.path / "hidden").chmod(0)
        return room.refused(*arguments, "hidden/new", user=room.program.other_user())
    return attack


def in_loop(arguments):
    def attack(room):
        room.write("s.toml", SWEEP)
        loop(room.path / "loop")
        return room.refused(*arguments, "loop")
    return attack


def own_pipe(arguments, name):
    """Opening a pipe waits for a reader. Whoever wants one names it: --json FILE."""
    def attack(room):
        room.write("s.toml", SWEEP)
        if arguments[0] == "report":
            room.write("o/results.json", '{"schema": 2}')
        (room.path / "o").mkdir(exist_ok=True)
        fifo(room.path / "o" / name)
        before = room.files()
        wrong = room.refused(*arguments, says=["is a pipe"], leaves=("o/rows", "o/rows/journal"))
        return wrong or (None if set(before) <= set(room.files()) else "removes the pipe")
    return attack


def in_file(arguments):
    """The output is, or is below, a file of another kind, whose content no message may show."""
    def attack(room):
        room.write("s.toml", SWEEP)
        room.write("foreign", "a secret line\n")
        wrong = room.refused(*arguments, "foreign/below")
        ended = room.run(*arguments, "foreign/below")
        return wrong or ("prints the file" if "secret" in ended.err else None)
    return attack


def foreign(command):
    """A file that is no TOML: the message names the line and does not repeat it."""
    def attack(room):
        room.write("foreign", "a secret line\n")
        wrong = room.refused(command, "foreign", says=["foreign:1: "])
        return wrong or ("prints the file" if "secret" in room.run(command, "foreign").err else None)
    return attack


def inputs():
    for reader, (name, arguments, kinds) in READERS.items():
        for kind in kinds:
            yield f"{reader} is {kind.__name__}", reading(name, arguments, kind)
    for what, left in SUBMISSIONS.items():
        yield f"compare --external leaves {what}", submission(*left)
    for name in ("nowhere", "a-file", LONG_NAME):
        yield f"compare --external: TMPDIR is {name[:20]}", temporary_folder(name)
    for command in ("solve", "bearing", "plan", "compare", "sweep", "report"):
        yield f"{command}: a name of {len(LONG_NAME)} characters", in_long_name([command])
    for command in ("solve", "bearing", "plan", "compare", "sweep"):
        yield f"{command}: a file that is no TOML", foreign(command)
    for command, (arguments, names) in IN_FOLDER.items():
        for name in names:
            yield f"{command}: its own {name} is a pipe", own_pipe(arguments, name)
    for output, arguments in OUTPUTS.items():
        yield f"{output}: a name of {len(LONG_NAME)} characters", in_long_name(arguments)
        yield f"{output} in a folder without permission to write", in_closed_folder(arguments)
        yield f"{output} in a folder without permission to enter", in_hidden_folder(arguments)
        yield f"{output} is a loop of links", in_loop(arguments)
        yield f"{output} below a file", in_file(arguments)
