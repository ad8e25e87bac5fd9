#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Types the first block of docs/start.md for real, in an empty folder: clones this repository, builds, computes.

  minutes.py         prints how long each command took
  minutes.py FILE    writes that as a page (make start-minutes)

No test compares times: they depend on the machine and on what else it does. So the page also has processor times, the
number of cores, and c, the time of one padded convolution (docs/bench.md). Exit code: 1 where a command fails, 2 for
wrong usage."""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

import walk

START = walk.ROOT / "docs" / "start.md"
TITLE = "# From a clone to the first own result, in minutes\n\n<!-- Made by `make start-minutes`: do not edit. -->\n\n"
WORDS = """    make start-minutes

The commands of [docs/start.md](../start.md), typed in an empty folder of a machine that has the packages. The processor
time is that of all cores: half of it is the time on two idle cores.

"""
# A newcomer has compiled nothing yet and has set none of these.
NOT_SET = ("BUILD", "CMAKE_FLAGS", "JOBS", "MAKEFLAGS", "CXX", "CXXFLAGS", "EHD_CASES")
ENVIRONMENT = {name: value for name, value in os.environ.items() if name not in NOT_SET} | {"CCACHE_DISABLE": "1"}


def processor_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(command, folder):
    """What the command prints. One that fails ends the script."""
    ended = subprocess.run(["sh", "-c", command], cwd=folder, env=ENVIRONMENT, stdout=subprocess.PIPE, text=True)
    if ended.returncode != 0:
        sys.exit(f"{command}: exit code {ended.returncode}")
    return ended.stdout


def measured(folder):
    """Rows of a table: each command with its minutes by the clock and of processor time. And what is said of c."""
    rows = []
    for command, _ in walk.turns(walk.BLOCK.search(START.read_text())["body"]):
        begin, used = time.monotonic(), processor_s()
        if command.startswith("cd "):
            folder /= command.split()[1]
        else:
            run(command.replace(" URL ", f" {walk.ROOT} "), folder)
        rows.append((command, (time.monotonic() - begin) / 60, (processor_s() - used) / 60))
    return rows, run("build/ehd bench --part convolution", folder).strip()


def main(arguments):
    if len(arguments) > 1 or any(word.startswith("-") for word in arguments):
        print(__doc__, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as name:
        rows, speed = measured(pathlib.Path(name))
    lines = ["| command | minutes | of processor time |", "|---|---|---|"]
    for command, clock, processor in rows:
        words = command.replace("|", "\\|")
        lines.append(f"| `{words}` | {clock:.2f} | {processor:.2f} |")
    lines.append(f"| all {len(rows)} | {sum(row[1] for row in rows):.1f} | {sum(row[2] for row in rows):.1f} |")
    text = "\n".join(lines) + f"\n\n{speed}; {os.cpu_count()} cores.\n"
    print(text, end="")
    if arguments:
        pathlib.Path(arguments[0]).write_text(TITLE + WORDS + text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
