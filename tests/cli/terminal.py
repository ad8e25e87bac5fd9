#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What only a terminal sees: colour, and a line with the time left.   terminal.py EHD     exit code 0: all hold"""
import os
import pty
import re
import subprocess
import sys


def on_terminal(ehd, *arguments, **environment):
    """What the command writes on a terminal of its own."""
    master, slave = pty.openpty()
    kept = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
    process = subprocess.Popen([ehd, *arguments], stdin=subprocess.DEVNULL, stdout=slave, stderr=slave,
                               env={**kept, "TERM": "xterm", **environment})
    os.close(slave)
    written = b""
    try:
        while read := os.read(master, 65536):
            written += read
    except OSError:  # so ends a terminal whose last program has gone
        pass
    os.close(master)
    if process.wait() != 0:
        sys.exit(f"terminal.py: ehd {arguments}: exit code {process.returncode}\n{written.decode()}")
    return written.decode()


def require(holds, what, written):
    if not holds:
        sys.exit(f"terminal.py: {what}:\n{written!r}")


def main(ehd):
    solve = ("solve", "--M", "20", "--L", "10")
    styled = on_terminal(ehd, *solve)
    require("\033[32mconverged" in styled, "a terminal shows no colour", styled)
    for environment in ({"NO_COLOR": "1"}, {"TERM": "dumb"}):
        plain = on_terminal(ehd, *solve, **environment)
        require("converged" in plain and "\033" not in plain, f"there is colour with {environment}", plain)
    written = on_terminal(ehd, "compare", "own-moes-20-10", "--solver", "reference", "--solver", "reference.uniform",
                          "--tolerance", "1e-2", "--tolerance", "1e-3")  # some seconds
    time_left = r"\r\d/\d, [\d.]+ (s|min|h), about [\d.]+ (s|min|h) left: "
    require(re.search(time_left, written), "the time left is not shown", written)
    require(re.search(r"\r +\r+own-moes-20-10: ", written), "the line stays before the table", written)
    # A long title is cut, not the solver's name.
    seconds = [float(s) for s in re.findall(
        r"\rsolving own-moes-1000-20 with reference: [^\r]*, ([\d.]+) s *\r", on_terminal(
            ehd, "solve", "own-moes-1000-20", "--solver", "reference", "--tolerance", "1e-8"))]
    require(len(seconds) > 1 and seconds == sorted(seconds), "a solve of some seconds does not show them", seconds)
    waves = [word for k in range(1, 6) for word in ("--omega", str(k))]
    written = on_terminal(ehd, "response", "own-moes-20-10", *waves)
    require(re.search(r"\rresponse of own-moes-20-10 with fast: ", written), "response shows no solver", written)
    require(re.search(r"\r0/5, [^\r]*\r.*\r4/5, [\d.]+ (s|min), about [\d.]+ s left: own-moes-20-10 with fast: ",
                      written, re.DOTALL), "response does not count its frequencies", written)
    written = on_terminal(ehd, "export", "law", "na4908", "--raceway", "inner", "--output", os.devnull)
    require(all(f"\rna4908: {what} 2 ..." in written for what in ("contact", "response")),
            "export law does not count its contacts", written)
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
    written = on_terminal(ehd, "judge", os.path.join(source, "cases", "submissions", "ehd-fast-1e-3.json"))
    require(re.search(r"\r1/\d+, [\d.]+ (s|min)(, about [\d.]+ s left)?: ", written), "judge does not count", written)
    written = on_terminal(ehd, "verify", "--rung", "11", "--quick")
    require(re.search(r"\rverify \d+/\d+, [\d.]+ (s|min)", written), "verify does not show its time", written)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
