#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds every wrong program of mutants.toml and runs its rung of `ehd verify --quick` with it.

A mutant is caught where a claim on its own rung does not stand; the other rungs are not run. Works on
a copy of the tracked files in OUT/source, so that an interrupted run leaves nothing wrong behind. Exit code 0: every
mutant is caught on its rung; 1: one is not; 2: wrong usage, a text that is not found exactly once, or a suite that
fails without any mutant.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time
import tomllib

TOP = pathlib.Path(__file__).resolve().parents[2]


def fail(message):
    print(f"run.py: {message}", file=sys.stderr)
    sys.exit(2)


def read_mutants():
    """The mutants; ends the program where the old text of one is not found exactly once in its file."""
    with open(pathlib.Path(__file__).with_name("mutants.toml"), "rb") as file:
        mutants = tomllib.load(file)["mutant"]
    ids = [mutant["id"] for mutant in mutants]
    if len(set(ids)) != len(ids):
        fail("two mutants have one id")
    wrong = []
    for mutant in mutants:
        path = TOP / mutant["file"]
        times = path.read_text().count(mutant["find"]) if path.is_file() else None
        if times is None:
            wrong.append(f"{mutant['id']}: there is no file {mutant['file']}")
        elif times != 1:
            wrong.append(f"{mutant['id']}: its text stands {times} times in {mutant['file']}, not once")
        if mutant["find"] == mutant["replace"]:
            wrong.append(f"{mutant['id']} changes nothing")
    if wrong:
        fail("\nrun.py: ".join(wrong))
    return mutants


def part_of(mutants, text):
    """Mutants K, K + N, ... of the list, for the text K/N."""
    number, _, of = text.partition("/")
    if not (number.isdecimal() and of.isdecimal() and 1 <= int(number) <= int(of) <= len(mutants)):
        fail(f"--part {text}: allowed is K/N with 1 <= K <= N <= {len(mutants)}, as 3/10")
    return mutants[int(number) - 1 :: int(of)]


def copy_tree(source):
    list_files = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(list_files, cwd=TOP, check=True,
                            capture_output=True, text=True).stdout
    wanted = {name for name in listed.split("\0") if name and (TOP / name).is_file()}
    for name in sorted(wanted):
        to = source / name
        if to.exists() and to.read_bytes() == (TOP / name).read_bytes():
            continue  # keeps its time, so that a second run builds little
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(TOP / name, to)
    for old in [p for p in source.rglob("*") if p.is_file()]:
        if str(old.relative_to(source)) not in wanted:
            old.unlink()


def build(source, folder, jobs):
    return subprocess.run(["cmake", "--build", folder, "--parallel", str(jobs), "--target", "ehd_program"], cwd=source,
                          capture_output=True, text=True)


def judge(folder, output, limit, rung=None):
    """(how it ended, the claims that do not stand) of one rung, or of the suite"""
    results = output / "results.json"
    results.unlink(missing_ok=True)
    try:
        only = [] if rung is None else ["--rung", str(rung)]
        run = subprocess.run([folder / "ehd", "verify", "--quick", *only, "--output", output], capture_output=True,
                             text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return f"not at its end after {limit} s", []
    if not results.exists():
        lines = run.stderr.strip().splitlines()
        return f"exit code {run.returncode}, no results: {lines[-1] if lines else 'no message'}", []
    claims = json.loads(results.read_text())["claims"]
    broken = [claim["id"] for claim in claims if claim["verdict"] != "pass" and "accepted" not in claim]
    return f"exit code {run.returncode}", broken


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=pathlib.Path, default=TOP / "out" / "mutants", help="folder (out/mutants)")
    parser.add_argument("--only", action="append", default=[], metavar="PART", help="mutants with PART in their id")
    parser.add_argument("--part", metavar="K/N", help="the K-th of N parts: mutants K, K + N, ...")
    parser.add_argument("--check", action="store_true",
                        help="only test that each mutant's text stands once in its file")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--time-limit", type=float, default=300, metavar="S", help="of one run of the suite (300)")
    arguments = parser.parse_args()

    mutants = read_mutants()
    if arguments.check:
        print(f"{len(mutants)} mutants: the old text of each stands once in its file")
        return
    if arguments.only:
        ids = [mutant["id"] for mutant in mutants]
        mutants = [m for m in mutants if any(part in m["id"] for part in arguments.only)]
        if not mutants:
            fail(f"no mutant has {' or '.join(arguments.only)} in its id; there are {', '.join(ids)}")
    if arguments.part:
        mutants = part_of(mutants, arguments.part)
    # Mutants of one file run one after the other, headers last: a restored file is then built only once.
    mutants.sort(key=lambda mutant: (mutant["file"].endswith(".hpp"), mutant["file"]))

    source, folder, output = (arguments.output / name for name in ("source", "build", "results"))
    for path in (source, output):
        path.mkdir(parents=True, exist_ok=True)
    copy_tree(source)
    generator = ["-G", "Ninja"] if shutil.which("ninja") and not (folder / "CMakeCache.txt").exists() else []
    configured = subprocess.run(["cmake", "-S", source, "-B", folder, "-DBUILD_TESTING=OFF", *generator],
                                capture_output=True, text=True)
    if configured.returncode != 0:
        fail("cmake failed:\n" + configured.stderr)
    built = build(source, folder, arguments.jobs)
    if built.returncode != 0:
        fail("the project does not build:\n" + built.stdout[-2000:])
    ended, broken = judge(folder, output, arguments.time_limit)
    if ended != "exit code 0" or broken:
        fail(f"the suite does not stand without a mutant: {ended}, {', '.join(broken)}")

    rows, wrong = [], 0
    width = max(len(mutant["id"]) for mutant in mutants)
    print(f"{'mutant':{width}}  rung  caught  claims of the rung that do not stand")
    for mutant in mutants:
        file = source / mutant["file"]
        right = file.read_text()
        begin = time.monotonic()
        try:
            file.write_text(right.replace(mutant["find"], mutant["replace"]))
            built = build(source, folder, arguments.jobs)
            if built.returncode != 0:
                ended, broken = "does not compile", []
            else:
                ended, broken = judge(folder, output, arguments.time_limit, mutant["rung"])
        finally:
            file.write_text(right)  # with a new time, so that it is built again
        wrong += not broken
        seen = f"{len(broken)}, {broken[0]}" if broken else ended
        print(f"{mutant['id']:{width}}  {mutant['rung']:4}  {'yes' if broken else 'NO':6}  {seen}", flush=True)
        rows.append({"id": mutant["id"], "what": mutant["what"], "file": mutant["file"], "rung": mutant["rung"],
                     "caught": bool(broken), "ended": ended, "broken": broken,
                     "wall_s": round(time.monotonic() - begin, 1)})
        (arguments.output / "mutants.json").write_text(json.dumps({"schema": 1, "mutants": rows}, indent=2) + "\n")
    print(f"{len(mutants) - wrong} of {len(mutants)} mutants are caught on their rung")
    if wrong:
        print(f"run.py: {wrong} of {len(mutants)} mutants are not caught on their rung", file=sys.stderr)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
