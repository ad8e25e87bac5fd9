#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Audits the numbers that `ehd` writes, then the audit itself.

    python3 tests/outputs/audit.py build/ehd [MODULE...]

Each number of each JSON is derived again, by formulas written down here, from the inputs, from other outputs and from
other runs. Then every number is made wrong in turn (doubled, its sign turned, a count one more), and the audit has to
object. exemptions.toml lists what nothing holds. Exit code: 0 all is held; 1 the program or an audit is wrong.
"""

import importlib
import pathlib
import sys
import tempfile
import time

sys.dont_write_bytecode = True  # the tree stays clean

from judge import changes_of, numbers_in, objects  # noqa: E402
from program import Program, read_case  # noqa: E402

MODULES = ("contact", "oil", "convert", "bearing", "motion", "law", "films", "maps", "atlas", "compare", "statements",
           "sweep", "verify", "figures", "bench", "response", "cases")


class Exemptions:
    """What need not be held, and whether that is true."""

    def __init__(self):
        entries = read_case(pathlib.Path(__file__).with_name("exemptions.toml"))["exempt"]
        self.all = [(entry["kind"], path, entry["changes"]) for entry in entries for path in entry["paths"]]
        self.unused = {(entry["kind"], path)
                       for entry in entries if not entry.get("noisy") for path in entry["paths"]}

    def allow(self, kind, path, change):
        """True if a change that the audit did not object to is exempt."""
        met = {(of, pattern) for of, pattern, changes in self.all
               if of == kind and change in changes and fits(path, pattern.split("/"))}
        self.unused -= met
        return bool(met)


def fits(path, pattern):
    return len(path) == len(pattern) and all(want in ("*", key) for key, want in zip(path, pattern, strict=True))


def wrong_numbers(kind, document, audit, exemptions):
    """Makes each number wrong in turn. Returns how many were, and a line for each that was judged wrongly."""
    count, faults = 0, []
    for holder, key, path in list(numbers_in(document)):
        right = holder[key]
        for change, wrong in changes_of(right):
            holder[key] = wrong
            held = objects(audit)
            holder[key] = right
            count += 1
            if not held and not exemptions.allow(kind, path, change):
                faults.append(f"{'/'.join(path)} {change}: nothing objects")
    return count, faults


def main():
    program_path, *modules = sys.argv[1:]
    exemptions, failures, tried = Exemptions(), [], 0
    met_kinds, began = set(), time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        program = Program(pathlib.Path(program_path).resolve(), folder)
        for module in modules or MODULES:
            for name, kind, document, audit in importlib.import_module(module).documents(program):
                met_kinds.add(kind)
                if objections := audit():
                    failures += [f"{name}: {line}" for line in objections]
                    continue  # whatever is wrong beside it, this audit objects
                count, faults = wrong_numbers(kind, document, audit, exemptions)
                tried += count
                failures += [f"{name}: {line}" for line in faults]
            print(f"{module}: {tried} wrong numbers so far, {time.monotonic() - began:.1f} s")
    if not failures:  # a document that an audit objected to was not made wrong
        failures = [f"exemptions.toml: {kind} {path}: not needed, the audits hold it"
                    for kind, path in sorted(exemptions.unused) if kind in met_kinds]
    for line in failures:
        print(line)
    print(f"{tried} wrong numbers, {len(failures)} failures")
    return 1 if failures or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
