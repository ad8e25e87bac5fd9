#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Attacks the program `ehd` with bad input, a class of faults at a time, and prints a table.

    tests/faults/run.py build/ehd                    every class
    tests/faults/run.py build/ehd options files      these classes
    tests/faults/run.py build/ehd --page FILE        every class, and the table, without times, as a page

A class is a module CLASS.py in this folder: its TITLE, and inputs(), which yields (name, attack). attack(room) gets a
fresh folder (room.py) and returns what is wrong, or None. It raises Skipped where this machine cannot make the fault.
Exit code: 0 every input ended as it should; 1 one did not; 2 wrong usage."""

import argparse
import importlib
import os
import pathlib
import sys
import time
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
from room import Program, Room, Skipped  # noqa: E402

NO_CLASS = {"run", "room"}
HOW = ("passed", "skipped", "failed")
PAGE = """# The program under attack

<!-- Made by `make faults`: do not edit. -->

    make faults

Every input has to end as [tests/faults](../../tests/faults/README.md) says: a refusal is one line that names what is
allowed, no signal but the one that was sent ends the program, and no file is left half written. Skipped is what this
machine cannot try.

"""


def classes():
    return sorted(file.stem for file in HERE.glob("*.py") if file.stem not in NO_CLASS)


def attacked(program, name, attack):
    """(name, "passed" | "skipped" | "failed", why)"""
    try:
        with Room(program) as room:
            wrong = attack(room)
    except Skipped as skipped:
        return name, "skipped", str(skipped)
    return (name, "failed", wrong) if wrong else (name, "passed", "")


def page_of(rows, notes):
    """rows: (class, title, inputs, passed, skipped, failed)."""
    total = ["all", "", *(sum(row[k] for row in rows) for k in range(2, 6))]
    lines = ["| class | what | inputs | passed | skipped | failed |", "|---|---|---|---|---|---|"]
    lines += ["| " + " | ".join(map(str, row)) + " |" for row in [*rows, total]]
    reasons = ["", *(f"- {note}" for note in notes)] if notes else []
    return PAGE + "\n".join(lines + reasons) + "\n"


def not_on_page(names):
    """What the kept page lacks: a class that is new."""
    kept = HERE.parents[1] / "docs" / "results" / "faults.md"
    text = kept.read_text() if kept.exists() else ""
    return [f"{name}: has no row in {kept.name}: make faults" for name in names if f"\n| {name} | " not in text]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("classes", nargs="*", metavar="CLASS", help="out of " + ", ".join(classes()))
    parser.add_argument("--page", type=pathlib.Path, metavar="FILE", help="write the table to this page")
    arguments = parser.parse_args()
    if arguments.page and arguments.classes:
        parser.error("--page has every class; allowed is --page without CLASS")
    for name in arguments.classes:
        if name not in classes():
            parser.error(f"{name} is no class; allowed is {', '.join(classes())}")
    program = Program(arguments.program)
    row = "{:<12} {:<58} {:>6} {:>6} {:>7} {:>6} {:>6}"
    print(row.format("class", "what", "inputs", "passed", "skipped", "failed", "time"))
    notes, rows, failed = [], [], 0
    for name in arguments.classes or classes():
        module = importlib.import_module(name)
        begin = time.monotonic()
        with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
            ended = list(pool.map(lambda one: attacked(program, *one), list(module.inputs())))
        counts = [sum(1 for _, how, _ in ended if how == which) for which in HOW]
        rows.append((name, module.TITLE, len(ended), *counts))
        print(row.format(name, module.TITLE, len(ended), *counts, f"{time.monotonic() - begin:.1f} s"), flush=True)
        failed += counts[2] + (not ended)
        if not ended:
            notes.append(f"{name}: has no inputs")
        notes += [f"{name}: {one}: {how}: {why}" for one, how, why in ended if how != "passed"]
    lacking = [] if arguments.page else not_on_page([row[0] for row in rows])
    for note in notes + lacking:
        print(note)
    if arguments.page:
        arguments.page.write_text(page_of(rows, notes))
    return 1 if failed or lacking else 0


if __name__ == "__main__":
    sys.exit(main())
