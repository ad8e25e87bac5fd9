#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a call in process costs above the C++ solve that it makes, in instructions (Ir) counted by callgrind.

  in_process.py BUILD     BUILD has libehd.so, built without this machine's vector instructions, which valgrind may not
                          know (make in-process does that)

A way to call the library is run once and several times; the difference has neither the start of the process nor FFTW's
plans. Exit code 0: what a call costs is below LIMIT, for the text of a contact, with or without its fields, for Moes'
groups and for the films of 16 contacts; 1: it is not; 2: wrong usage. The other rows have no limit: they read more
text, or make the JSON. Below a row above LIMIT stand the parts of its overhead.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

LIMIT = 0.05  # of the solve
CALLS = 10
HERE = pathlib.Path(__file__).resolve().parent
TOP = HERE.parents[2]
OF_A_PROGRAM = HERE / "contact.toml"  # as a program writes it: that of docs/library.md, without comments
OF_A_PERSON, OF_THE_BENCHMARK = TOP / "examples" / "cylinder-on-plate.toml", TOP / "cases" / "own-moes-20-10.toml"
# What is asked, of which case, in words, and whether LIMIT holds for it.
ROWS = [("solve", OF_A_PROGRAM, "case text: the call", True),
        ("number", OF_A_PROGRAM, "case text: and one number", True),
        ("fields", OF_A_PROGRAM, "case text: and X, P, H", True),
        ("json", OF_A_PROGRAM, "case text: and the JSON", False),
        ("moes", OF_A_PROGRAM, "M and L: and one number", True),
        ("films", OF_A_PROGRAM, "the films of 16 contacts", True),
        ("number", OF_A_PERSON, "a file with comments: one number", False),
        ("number", OF_THE_BENCHMARK, "a benchmark case: one number", False)]
SOLVE = r"ehd::fast::Mapped::solve\("
LEAST_PART = 0.001  # of the solve; smaller parts are not printed
# What a row above LIMIT consists of, the solve left out. An indented part belongs to the one above it.
PARTS = [("reading the case", r"ehd::read_case_in_memory\("),
         ("  toml++", r"ehd::parse_toml\("),
         ("    its comments", r"parser::consume_comment\("),
         ("  nodes of the TOML by their path", r"ehd::TreeBuilder::add\(toml"),
         ("  expectations", r"ehd::read_expectations\("),
         ("making the JSON", r"ehd::to_json\S*\(ehd::ContactRun"),
         ("  the error of the pressure", r"ehd::pressure_error\("),
         ("  the error of the film", r"ehd::field_error\("),
         ("writing the JSON as text", r"ehd::json_text\("),
         ("freeing the result", r"^ehd_free")]
FUNCTION = re.compile(r"^\s*([\d,]+)\s*(?:\([^)]*\))?\s+\S*?:(.*)$")


def counted(program, way, calls, case, folder):
    """Instructions of the whole process, those inside the solver, and those of PARTS."""
    out = folder / "callgrind"
    subprocess.run(["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={out}", program, way, str(calls),
                    case], check=True)
    listed = subprocess.run(["callgrind_annotate", "--inclusive=yes", "--threshold=100", "--auto=no", out], check=True,
                            capture_output=True, text=True).stdout.splitlines()
    number = lambda text: int(text.replace(",", ""))  # noqa: E731
    total = next(number(line.split()[0]) for line in listed if line.endswith("PROGRAM TOTALS"))
    functions = [(number(found[1]), found[2]) for line in listed if (found := FUNCTION.match(line))]

    def inside(name):
        return max((count for count, function in functions if re.search(name, function)), default=0)

    if not inside(SOLVE):
        sys.exit("in_process.py: callgrind names no solve; required is a library with its symbols")
    return [total, inside(SOLVE), *(inside(name) for _, name in PARTS)]


def main(build):
    worst = 0
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        program = folder / "in_process"
        subprocess.run(["cc", "-std=c99", "-O2", HERE / "in_process.c", f"-I{TOP / 'bindings' / 'c'}", f"-L{build}",
                        "-lehd", f"-Wl,-rpath,{build}", "-o", program], check=True)
        print(f"{'':32}  instructions of a call  of the solve in it  overhead")
        for way, case, words, limited in ROWS:
            once, often = (counted(program, way, calls, case, folder) for calls in (1, 1 + CALLS))
            call, solve, *parts = ((later - first) / CALLS for first, later in zip(once, often, strict=True))
            worst = max(worst, call / solve - 1) if limited else worst
            print(f"{words:32}  {call:22.0f}  {solve:18.0f}  {100 * (call / solve - 1):6.2f} %", flush=True)
            if call < (1 + LIMIT) * solve:
                continue
            for (part, _), count in zip(PARTS, parts, strict=True):
                if count >= LEAST_PART * solve:
                    print(f"  {part:38}  {count:14.0f}  {100 * count / solve:27.2f} %")
    if worst >= LIMIT:
        sys.exit(f"in_process.py: {100 * worst:.2f} % is not below {100 * LIMIT:.0f} %")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        sys.exit(2)
    main(pathlib.Path(sys.argv[1]).resolve())
