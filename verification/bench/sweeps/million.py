#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How a sweep grows: time, memory and files of 1e4, 1e5 and 1e6 rows, and processes that are killed throughout.

    million.py EHD [--rows N] [--page FILE]      N: the largest sweep, 1000000; needs 11 KB of disk a row

Each row is a dry bearing of four rollers: the row costs little, so that reading, storing and merging show. Three sizes,
N/100, N/10 and N, run in one process. Then N rows run in shards whose processes are killed (kill -9) again and again,
and are merged. Exit code 0: every bound holds; 1: one does not; 2: wrong usage."""

import argparse
import filecmp
import math
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SHARDS = 2
KILLS = 10  # of each shard
# 64 bytes a row are kept: two hashes, a place in the journal, two row numbers. As much again for what the allocator and
# the buffers of larger files add.
MOST_BYTES_A_ROW = 128
# Linear is 1. Processor times of one program differ by some 15 % on a shared machine: log10(1.15/0.85) = 0.13.
MOST_EXPONENT = 1.15

SWEEP = """case = "na4908"
laws = ["hertz"]
combine = "product"
[keys]
"bearing.rollers" = [4]
"operation.radial_load_N" = {{ from = 1e3, to = 5e4, points = {loads}, spacing = "linear" }}
"bearing.clearance_m" = {{ from = 0.0, to = 2e-5, points = {clearances}, spacing = "linear" }}
"""


class Ended:
    """One run of the program: its exit code, processor time and largest memory."""

    def __init__(self, *command):
        begin = time.monotonic()
        process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.said = process.stderr.read().decode(errors="replace").strip()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = self.code = os.waitstatus_to_exitcode(status)
        self.wall_s = time.monotonic() - begin
        self.cpu_s = usage.ru_utime + usage.ru_stime
        self.peak_bytes = usage.ru_maxrss * 1024


def sweep_file(folder, rows):
    loads = math.isqrt(rows)
    while rows % loads:
        loads -= 1
    file = folder / f"rows-{rows}.toml"
    file.write_text(SWEEP.format(loads=loads, clearances=rows // loads))
    return file


def in_one_process(ehd, folder, rows):
    output = folder / f"whole-{rows}"
    ended = Ended(ehd, "sweep", sweep_file(folder, rows), "--output", output, "--threads", "1")
    if ended.code != 0:
        sys.exit(f"{rows} rows: exit code {ended.code}: {ended.said}")
    again = Ended(ehd, "sweep", sweep_file(folder, rows), "--output", output, "--threads", "1")
    shutil.rmtree(output / "rows")  # the journal, as large as rows.json
    print(f"{rows} rows: {ended.cpu_s:.1f} s, {ended.peak_bytes / 1e6:.0f} MB; again {again.cpu_s:.1f} s, "
          f"{again.peak_bytes / 1e6:.0f} MB", file=sys.stderr, flush=True)
    return {"rows": rows, "first": ended, "again": again, "output": output}


def killed_shard(ehd, file, output, number, chance):
    """Runs a shard to its end; kills it KILLS times, each time after it has stored something new."""
    command = [ehd, "sweep", file, "--output", output, "--shard", f"{number}/{SHARDS}", "--threads", "1"]
    journal = output / "shards" / f"{number}-of-{SHARDS}" / "journal"
    kills = 0
    while True:
        before = journal.stat().st_size if journal.exists() else 0
        process = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        while kills < KILLS and process.poll() is None:
            if journal.exists() and journal.stat().st_size > before:
                time.sleep(chance.uniform(0, 1))
                process.send_signal(signal.SIGKILL)
                break
            time.sleep(0.01)
        if process.wait() >= 0:
            return process.returncode, kills
        kills += 1


def in_killed_processes(ehd, folder, rows):
    output = folder / "shards"
    chance = random.Random(15)
    file = sweep_file(folder, rows)
    shards = [killed_shard(ehd, file, output, number, chance) for number in range(1, SHARDS + 1)]
    for number, (code, _) in enumerate(shards, 1):
        if code != 0:
            sys.exit(f"shard {number}: exit code {code}")
    merge = Ended(ehd, "sweep", file, "--output", output, "--merge", "--threads", "1")
    if merge.code != 0:
        sys.exit(f"merge: exit code {merge.code}: {merge.said}")
    return {"output": output, "merge": merge, "kills": sum(kills for _, kills in shards)}


def exponent(sizes, which):
    """b of processor time ~ rows^b over the last tenfold."""
    return math.log10(sizes[-1][which].cpu_s / sizes[-2][which].cpu_s)


def table_of(sizes):
    lines = ["| rows | first run: processor [s] | memory [MB] "
             "| known rows again: processor [s] | memory [MB] | rows.json [MB] |",
             "|---|---|---|---|---|---|"]
    for one in sizes:
        mega = [round(one[which].peak_bytes / 1e6) for which in ("first", "again")]
        lines.append(f"| {one['rows']} | {one['first'].cpu_s:.1f} | {mega[0]} | {one['again'].cpu_s:.1f} | {mega[1]} | "
                     f"{(one['output'] / 'rows.json').stat().st_size / 1e6:.0f} |")
    return "\n".join(lines)


def judged(sizes, killed):
    """(what, measured, bound, does it hold) of each claim."""
    rows = sizes[-1]["rows"]
    added = [(sizes[-1][w].peak_bytes - sizes[0][w].peak_bytes) / (rows - sizes[0]["rows"]) for w in ("first", "again")]
    with open(killed["output"] / "rows.csv", "rb") as csv:
        lines = sum(1 for _ in csv) - 1
    same = all(filecmp.cmp(killed["output"] / name, sizes[-1]["output"] / name, shallow=False)
               for name in ("rows.csv", "rows.json"))
    merge_bytes = (killed["merge"].peak_bytes - sizes[0]["again"].peak_bytes) / rows
    return [
        ("memory for each row, first run [bytes]", f"{added[0]:.0f}", MOST_BYTES_A_ROW, added[0] <= MOST_BYTES_A_ROW),
        ("memory for each row, known rows [bytes]", f"{added[1]:.0f}", MOST_BYTES_A_ROW, added[1] <= MOST_BYTES_A_ROW),
        ("memory for each row, merge [bytes]", f"{merge_bytes:.0f}", MOST_BYTES_A_ROW, merge_bytes <= MOST_BYTES_A_ROW),
        ("b in time ~ rows^b, first run", f"{exponent(sizes, 'first'):.3f}", MOST_EXPONENT,
         exponent(sizes, "first") <= MOST_EXPONENT),
        ("b in time ~ rows^b, known rows", f"{exponent(sizes, 'again'):.3f}", MOST_EXPONENT,
         exponent(sizes, "again") <= MOST_EXPONENT),
        (f"rows after {killed['kills']} kills and a merge", lines, rows, lines == rows),
        ("tables equal to those of one process, bit for bit", "yes" if same else "no", "yes", same),
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("ehd", type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=1000000)
    parser.add_argument("--page", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.rows < 10000:
        parser.error("--rows: allowed is 10000 or more")
    ehd = arguments.ehd.resolve()
    with tempfile.TemporaryDirectory(prefix="ehd-sweep-") as scratch:
        folder = pathlib.Path(scratch)
        sizes = [in_one_process(ehd, folder, arguments.rows // part) for part in (100, 10, 1)]
        killed = in_killed_processes(ehd, folder, arguments.rows)
        claims = judged(sizes, killed)
        text = table_of(sizes) + "\n\n| what | measured | bound | holds |\n|---|---|---|---|\n"
        text += "".join(f"| {what} | {measured} | {bound} | {'yes' if holds else 'NO'} |\n"
                        for what, measured, bound, holds in claims)
        text += (f"\nMerge of {SHARDS} shards: {killed['merge'].cpu_s:.1f} s of processor time, "
                 f"{killed['merge'].peak_bytes / 1e6:.0f} MB.\n")
    print(text, end="")
    if arguments.page:
        arguments.page.write_text("# A sweep of a million rows\n\n"
                                  "<!-- Made by `make sweep-million`: do not edit. -->\n\n"
                                  "    make sweep-million\n\n"
                                  "Dry bearings of four rollers, one thread. Known rows again: the same command "
                                  "once more; nothing is computed,\nthe tables are written from the journal.\n\n"
                                  + text)
    return 0 if all(holds for *_, holds in claims) else 1


if __name__ == "__main__":
    sys.exit(main())
