#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the checks that steps.toml lists.

    steps.py run          every must, then the others while time is left (.ci/run)
    steps.py all          every step, without a limit; every one counts as a must (make check-all)
    steps.py list         names and commands
    --only PART           steps with PART in their name (repeatable)

Red (exit code 1): a step fails, skips a test, or has packages that cannot be installed; a must is cut by the time or
not begun; with `all`, any step is. The last lines name every such step, and every step that did not run. Green: 0.
Wrong usage: 2."""

import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from dataclasses import dataclass, field

HERE = pathlib.Path(__file__).resolve().parent
LEVELS = ("must", "more", "all")
KEYS = {"name", "level", "packages", "command", "check_all"}
# How ctest and tests/faults/run.py say that a test did not run.
SKIPPED = re.compile(r"^.*(?:\*\*\*(?:Skipped|Not Run)|: skipped: ).*$", re.MULTILINE)
GRACE_S = 10  # between the request to end and the end by force


@dataclass
class Step:
    name: str
    level: str
    command: str
    packages: list = field(default_factory=list)
    check_all: str = ""


@dataclass
class Outcome:
    step: Step
    wrong: list = field(default_factory=list)  # reasons why the step is red
    not_run: str = ""  # "not begun" or "cut after 12 s"
    wall_s: float = 0
    cpu_s: float = 0


def read_steps(file):
    steps = []
    for entry in tomllib.loads(file.read_text())["step"]:
        if set(entry) - KEYS or entry.get("level") not in LEVELS:
            sys.exit(f"{file}: {entry}: has another key or level; allowed are {sorted(KEYS)}, level {LEVELS}")
        steps.append(Step(**entry))
    if len({step.name for step in steps}) != len(steps):
        sys.exit(f"{file}: two steps have one name")
    return steps


def end(process):
    """Ends the process with all that it started."""
    for signal_number, seconds in ((signal.SIGTERM, GRACE_S), (signal.SIGKILL, GRACE_S)):
        try:
            os.killpg(process.pid, signal_number)
            process.wait(seconds)
        except (ProcessLookupError, subprocess.TimeoutExpired):
            continue


def run_until(command, stop, environment):
    """(exit code, output, was it cut) of a command for sh, ended at `stop` (monotonic seconds). Output is shown as it
    comes, from a file: a process that stays behind cannot hold the run up."""
    with tempfile.NamedTemporaryFile() as log, open(log.name, encoding="utf-8", errors="replace") as shown:
        process = subprocess.Popen(["sh", "-c", command], stdout=log, stderr=subprocess.STDOUT, env=environment,
                                   stdin=subprocess.DEVNULL, start_new_session=True)
        output, cut = [], False
        while True:
            ended = process.poll() is not None
            output.append(shown.read())
            print(output[-1], end="", flush=True)
            if ended:
                return process.returncode, "".join(output), cut
            if time.monotonic() > stop:
                cut = True
                end(process)
            time.sleep(0.1)


def run_step(step, command, setup, stop, environment):
    print(f"== {step.name}\n   {command}", flush=True)
    outcome, begin, before = Outcome(step), time.monotonic(), os.times()
    if step.packages and subprocess.run([*setup, *step.packages], check=False).returncode != 0:
        outcome.wrong.append("cannot be installed: one of " + ", ".join(step.packages))
    code, output, cut = run_until(command, stop, environment)
    outcome.wall_s = time.monotonic() - begin
    after = os.times()
    outcome.cpu_s = after.children_user + after.children_system - before.children_user - before.children_system
    if cut:
        outcome.not_run = f"cut after {outcome.wall_s:.0f} s"
    elif code != 0:
        outcome.wrong.append(f"failed (exit code {code})")
    outcome.wrong += [f"skipped a test: {line.strip()}" for line in SKIPPED.findall(output)]
    return outcome


def run_steps(steps, everything, setup, begin_for_s, stop_after_s):
    """Outcomes of the steps, in order. With `everything`, each counts as a must and nothing is cut."""
    begin, outcomes = time.monotonic(), []
    environment = {"BUILD": "build-ci", "CMAKE_FLAGS": "-DEHD_WERROR=ON", **os.environ}
    for step in steps:
        must = everything or step.level == "must"
        red = any(outcome.wrong for outcome in outcomes)
        passed_s = time.monotonic() - begin
        if not everything and (passed_s > stop_after_s or (not must and (red or passed_s > begin_for_s))):
            outcome = Outcome(step, not_run="not begun")
        else:
            command = step.check_all if everything and step.check_all else step.command
            stop = float("inf") if everything else begin + stop_after_s
            outcome = run_step(step, command, setup, stop, environment)
        if must and outcome.not_run:
            outcome.wrong.append(outcome.not_run)
        outcomes.append(outcome)
    return outcomes


def speed_of_machine():
    """c, the yardstick of all times, from the program that the first step has built."""
    try:
        said = subprocess.run([f"{os.environ.get('BUILD', 'build-ci')}/ehd", "bench", "--part", "convolution"],
                              capture_output=True, text=True, check=True).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        said = "c is not known: there is no program that measures it"
    return f"{said}; {os.cpu_count()} cores"


HEAD = "| step | level | wall [s] | processor [s] | end |"


def times_row(one):
    how = "; ".join(one.wrong) or one.not_run or "passed"
    return f"| {one.step.name} | {one.step.level} | {one.wall_s:.0f} | {one.cpu_s:.0f} | {how} |"


def times_table(outcomes):
    total = f"| all | | {sum(o.wall_s for o in outcomes):.0f} | {sum(o.cpu_s for o in outcomes):.0f} | |"
    return "\n".join([HEAD, "|---|---|---|---|---|", *map(times_row, outcomes), total])


def report(outcomes, left_out):
    """Prints what came out; True where everything that counts has passed."""
    print("\n" + times_table(outcomes) + "\n" + speed_of_machine())
    for one in outcomes:
        for reason in one.wrong:
            print(f"RED: {one.step.name}: {reason}")
    missing = [f"{one.step.name} ({one.not_run})" for one in outcomes if one.not_run]
    missing += [f"{step.name} ({'make check-all' if step.level == 'all' else 'not chosen'})" for step in left_out]
    print("did NOT run: " + ("; ".join(missing) if missing else "nothing, every step ran"))
    red = any(one.wrong for one in outcomes)
    print("red" if red else "green", flush=True)
    return not red


def write_page(page, outcomes, steps):
    """A row a step of the list, with the commit that it ran on. The row of an earlier run stays until its step runs
    again."""
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=HERE, capture_output=True, text=True,
                            check=False).stdout.strip() or "unknown"
    lines = page.read_text().splitlines() if page.exists() else []
    rows = {line.split(" | ")[0].removeprefix("| "): line for line in lines if line.startswith("| ")}
    rows |= {one.step.name: f"{times_row(one)} {commit} |" for one in outcomes}
    never = "| {0.name} | {0.level} | | | has not run | |"
    table = [f"{HEAD} commit |", "|---|---|---|---|---|---|", *(rows.get(s.name, never.format(s)) for s in steps)]
    page.write_text("# Times of every check\n\n<!-- Made by `make check-all`: do not edit. -->\n\n"
                    f"    make check-all\n\nThe last run: {speed_of_machine()}.\n\n" + "\n".join(table) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", choices=["run", "all", "list"])
    parser.add_argument("--only", action="append", default=[], metavar="PART")
    # For the tests of this file.
    parser.add_argument("--steps", type=pathlib.Path, default=HERE / "steps.toml", help=argparse.SUPPRESS)
    parser.add_argument("--setup", default=f"sh {HERE.parent}/cmake/setup.sh", help=argparse.SUPPRESS)
    parser.add_argument("--page", type=pathlib.Path, metavar="FILE", help="write the times to this page (all)")
    # A run that passes 90 minutes is lost.
    parser.add_argument("--begin-for", type=float, default=3600, metavar="S", help="begin steps beside musts (3600)")
    parser.add_argument("--stop-after", type=float, default=4500, metavar="S", help="cut what still runs (4500)")
    arguments = parser.parse_args()
    everything = arguments.which == "all"
    steps = read_steps(arguments.steps)
    chosen = [s for s in steps if not arguments.only or any(part in s.name for part in arguments.only)]
    if not chosen:
        parser.error(f"no step has {' or '.join(arguments.only)} in its name")
    if arguments.which == "list":
        for step in chosen:
            print(f"{step.level:4}  {step.name}: {step.command}")
        return 0
    wanted = [s for s in chosen if everything or s.level != "all"]
    outcomes = run_steps(wanted, everything, arguments.setup.split(), arguments.begin_for, arguments.stop_after)
    good = report(outcomes, [s for s in steps if s not in wanted])
    if everything and arguments.page:
        write_page(arguments.page, outcomes, steps)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
