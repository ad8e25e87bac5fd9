#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pages of docs/results, and what the written pages show of the program, from its own output.

  make.py EHD          the quick pages (a minute): make results
  make.py --check EHD  compares instead of writing; a difference fails: make results-check
  make.py --full EHD   the slow pages (see `make help`), which nobody compares: make results-full
  --only NAME          of these, the pages whose file has NAME in its path

Times, and numbers that rounding decides, are left out of the quick pages: another machine has to make the same text.
Exit code: 0 the pages are there, or are the same; 1 a page differs, or a command failed; 2 wrong usage.
"""
import argparse
import difflib
import functools
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "docs"))
import walk  # noqa: E402, the pages that show what their commands print

PAGES = ROOT / "docs" / "results"
CASE_FORMAT = "docs/case-format.md"
JUDGE = "docs/judge.md"
MADE = "<!-- Made by `make results`: do not edit. -->"
MADE_SLOWLY = "<!-- Made by `make results-full`: do not edit. -->"


def run(ehd, *arguments):
    """What the command prints. A command that fails ends the script with its output."""
    process = subprocess.run([ehd, *arguments], cwd=ROOT, capture_output=True, text=True)
    if process.returncode != 0:
        sys.exit(f"{ehd} {' '.join(arguments)}: exit code {process.returncode}\n{process.stdout}{process.stderr}")
    return process.stdout


# ---- text ----------------------------------------------------------------------------------------------------------


def spans(rows):
    """Columns of an aligned table: (begin, end) of each. Two or more blanks in every row separate columns."""
    width = max(map(len, rows))
    used = [any(i < len(row) and row[i] != " " for row in rows) for i in range(width)]
    found = []
    for i in (i for i in range(width) if used[i]):
        if found and i - found[-1][1] < 2:
            found[-1][1] = i + 1
        else:
            found.append([i, i + 1])
    return found


def without(text, *columns):
    """The text with these columns left out of every table whose header names them."""
    lines, result = text.splitlines(), []
    while lines:
        if not any(re.search(rf"(^|  ){re.escape(name)}(  |$)", lines[0]) for name in columns):
            result.append(lines.pop(0))
            continue
        rows = []
        while lines and lines[0].strip() and not lines[0].lstrip().startswith("achieved:"):
            rows.append(lines.pop(0))
        begin = 0
        cells = [[] for _ in rows]
        for _, end in spans(rows):
            if rows[0][begin:end].strip() not in columns:
                for row, parts in zip(rows, cells):
                    parts.append(row[begin:end].ljust(end - begin))
            begin = end
        result += ["".join(parts).rstrip() for parts in cells]
    return "\n".join(result) + "\n"


def page(title, commands, text, words=""):
    """A page: a heading, the commands that print the text, a sentence or two, the text."""
    said = "\n".join(f"    {command}" for command in commands)
    blocks = (f"# {title}", MADE, said, words, text.strip("\n"))
    return "\n\n".join(block for block in blocks if block) + "\n"


def fenced(text):
    return "```text\n" + text.strip("\n") + "\n```"


def table(header, rows):
    lines = ["| " + " | ".join(row) + " |" for row in [header, *rows]]
    return "\n".join([lines[0], "|---" * len(header) + "|", *lines[1:]])


# ---- quick pages ---------------------------------------------------------------------------------------------------


def ladder(suite):
    lines = suite.splitlines()
    first = max(i for i, line in enumerate(lines) if line.startswith("rung  "))
    last = next(i for i in range(first, len(lines)) if lines[i].startswith("all "))
    return without("\n".join(lines[first : last + 1]), "worst claim", "margin")


def traceability(suite):
    """A row a part: its words, its claims, and how many of them pass in the quick suite."""
    parts = re.findall(r"^((?:work|readme)/[a-z-]+): (.*)\n  (.*)$", suite, re.MULTILINE)
    passed = dict(re.findall(r"^((?:work|readme)/[a-z-]+) +(\d+) ", suite, re.MULTILINE))
    rows = [(f"`{name}`", what, " ".join(f"`{id}`" for id in claims.split()), passed[name])
            for name, what, claims in parts]
    return table(("part", "what is said", "claims that support it", "pass"), rows)


def mutants():
    return tomllib.loads((ROOT / "verification" / "mutants" / "mutants.toml").read_text())["mutant"]


def mutant_page():
    by_rung = sorted(mutants(), key=lambda mutant: int(mutant["rung"]))
    rows = [(str(m["rung"]), f"`{m['id']}`", m["what"], f"`{m['file']}`") for m in by_rung]
    return table(("rung", "id", "what is wrong", "where"), rows)


def four_tolerances():
    return [word for tolerance in ("1e-2", "1e-3", "1e-4", "1e-5") for word in ("--tolerance", tolerance)]


def compared(ehd):
    text = without(run(ehd, "compare", "own-moes-20-10", *four_tolerances()), "ms")
    return re.sub(r"  +<?[\d.]+e-1[2-9]", lambda cell: "<1e-11".rjust(len(cell[0])), text)


def contact_without_cost(ehd):
    text = run(ehd, "solve", "examples/cylinder-on-plate.toml", "--tolerance", "1e-4")
    return "".join(line for line in text.splitlines(True) if not line.startswith("cost "))


def without_time(text):
    return "".join(line for line in text.splitlines(True) if not line.startswith("time"))


def bearings(ehd, *cases):
    return without(run(ehd, "bearing", *cases, "--details"), "balance error", "time s")


# Bearings in motion: two cases over clearance [um] and speed [rpm].
IN_MOTION = [("na4908", clearance, rpm) for clearance, rpm in
             [(0, 5000), (2.5, 5000), (10, 5000), (0, 1000), (0, 2500), (0, 10000)]]
IN_MOTION += [("examples/roller-bearing.toml", clearance, rpm) for clearance, rpm in
              [(0, 3000), (10, 3000), (30, 3000), (10, 1000), (10, 6000)]]


def motions(ehd):
    """Stiffness and damping of rings at 100 Hz: three digits and two, as their errors of 0.1 % and 1 to 2 % leave."""
    rows = []
    for case, clearance, rpm in IN_MOTION:
        bearing = json.loads(run(ehd, "bearing", case, "--law", "ehd", "--dynamic", "--frequency", "100",
                                 "--set", f"bearing.clearance_m={clearance}e-6",
                                 "--set", f"operation.speed_rpm={rpm}", "--json", "-"))
        ring = bearing["dynamics"][0]
        stiffness, damping = ring["stiffness_N_per_m"], ring["damping_N_s_per_m"]
        rows.append([bearing["case"], f"{clearance:g}", str(rpm),
                     *(f"{float(f'{1e-6 * stiffness[i][i]:.3g}'):.0f}" for i in (0, 1)),
                     *(f"{1e-3 * damping[i][i]:#.2g}".rstrip(".") for i in (0, 1)),
                     f"{100 * ring['error']:.1g}", f"{100 * ring['damping_error']:.1g}"])
    return table(("bearing", "clearance, um", "rpm", "stiffness along, N/um", "across", "damping along, kN s/m",
                  "across", "error of stiffness, %", "of damping, %"), rows)


def numbers(comparison, suite):
    """The table of the root README: why the results can be trusted."""
    judged = re.search(r"^all +(\d+) +(\d+) +(\d+) ", ladder(suite), re.MULTILINE)
    row = re.search(r"^  fast +0.001 +\S+ +(\S+) +(\S+)", comparison, re.MULTILINE)
    digits = re.search(r"^  reference +1e-5 +(\S+)", comparison, re.MULTILINE)[1]
    atlas = len(re.findall(r"^atlas-", (ROOT / "cases/atlas/atlas.csv").read_text(), re.MULTILINE))
    not_standing = int(judged[2]) + int(judged[3])
    return table(("question", "answer", "try it"), [
        ("Do the two codes agree?",
         f"On `own-moes-20-10` `fast` states an error of {row[1]} and errs by {row[2]}; "
         f"`reference` finds H_min = {digits}",
         "[`ehd compare`](docs/results/compare.md)"),
        ("Are the results right?", f"{judged[1]} claims hold in the quick suite, {not_standing} do not",
         "[`ehd verify --quick`](docs/results/ladder-quick.md)"),
        ("Would the suite see an error?",
         f"{len(mutants())} wrong programs are built; each has to fail on its own rung",
         "[`make mutants`](docs/results/mutants.md)"),
        ("Over which range?", f"{atlas} contacts over M and L are published with the digits that are known",
         "[`ehd cases --atlas`](cases/atlas/README.md)"),
    ])


def filled(text, name, mark, made):
    """The text of a written page with what was made between its marks."""
    marks = re.search(rf"(<!-- {mark}: made by make results -->\n).*?(<!-- end -->)", text, re.DOTALL)
    if marks is None:
        sys.exit(f"{name}: the marks of its {mark} are missing")
    return text.replace(marks[0], marks[1] + made.strip("\n") + "\n" + marks[2])


def typed(ehd, name):
    """A written page with what its commands print (tests/docs/walk.py). Other faults of the page end the script."""
    text, faults = walk.walked(pathlib.Path(ehd), ROOT / name)
    if others := [fault for fault in faults if not fault.startswith("$ ")]:
        sys.exit("\n".join([f"{name}:", *others]))
    return text


def first_cases(judgement):
    """The table of docs/judge.md: the cases that every judgement names, with what each tests."""
    cases = sorted((case for case in judgement["cases"] if "place" in case), key=lambda case: case["place"])
    return table(("case", "regime", "what it tests"), [
        (f"`{case['case']}`", f"{case['regime']['load']}, L {case['regime']['material']}", case["tests"])
        for case in cases])


def figure(ehd, words):
    """The figure that a command draws."""
    with tempfile.NamedTemporaryFile(suffix=".svg") as file:
        run(ehd, *words, "--plot", file.name)
        return pathlib.Path(file.name).read_text()


def quick_pages(ehd):
    """Name of each file, from the root of the repository, and the function that makes its text."""
    suite = functools.cache(lambda: run(ehd, "verify", "--quick", "--trace"))
    comparison = functools.cache(lambda: compared(ehd))
    clearances = ("na4908", "na4908-2.5um", "na4908-10um")
    results = {
        "na4908": lambda: page(
            "NA4908 at three clearances, dry and with films", ["ehd bearing " + " ".join(clearances) + " --details"],
            fenced(bearings(ehd, *clearances)),
            "Without balance errors and times. What the statements mean: [docs/statements.md](../statements.md)."),
        "bearing-dynamics": lambda: page(
            "NA4908 in small motion", ["ehd bearing na4908 --law ehd --dynamic --frequency 100"],
            fenced(bearings(ehd, "na4908", "--law", "ehd", "--dynamic", "--frequency", "100"))
            + "\n\n## Two bearings over clearance and speed\n\n"
            "The ring at 100 Hz:\n`ehd bearing CASE --law ehd --dynamic --frequency 100 "
            "--set bearing.clearance_m=PDe-6 --set operation.speed_rpm=RPM`.\n\n" + motions(ehd),
            "Without balance errors and times. What it means: [docs/bearing-dynamics.md](../bearing-dynamics.md)."),
        "statements": lambda: page(
            "The paper's statements, one choice changed at a time", ["ehd statements"], fenced(run(ehd, "statements")),
            "How the columns are read: [docs/statements.md](../statements.md)."),
        "ladder-quick": lambda: page(
            "The ladder, quick suite", ["ehd verify --quick"], fenced(ladder(suite())),
            "Without worst claims and margins, which rounding may decide. Slow topics count as skipped."),
        "traceability": lambda: page(
            "Which claims support which part of the work", ["ehd verify --quick --trace"], traceability(suite()),
            "`work/`: the work that this project implements. `readme/`: what the root README says.\n"
            "The last column counts claims of the quick suite; a full run fails where a part has none."),
        "cases": lambda: page("The benchmark cases", ["ehd cases"], fenced(run(ehd, "cases"))),
        "compare": lambda: page(
            "Both solvers at four tolerances", ["ehd compare own-moes-20-10 " + " ".join(four_tolerances())],
            fenced(comparison()), "Without times. Errors that rounding decides are printed as `<1e-11`."),
        "maps": lambda: page(
            "Film formulas and cut inlets against certified films", ["ehd maps"], fenced(run(ehd, "maps"))),
        "motion-maps": lambda: page(
            "Stiffness, damping and waviness over M and L", ["ehd maps --motion"],
            fenced(run(ehd, "maps", "--motion")), "What it means: [docs/response.md](../response.md)."),
        "films-table": lambda: page(
            "A table of films beside the film formulas", ["ehd maps --table"],
            fenced(without_time(run(ehd, "maps", "--table"))),
            "Without the time of an evaluation. How such a table is made: [docs/films-table.md](../films-table.md)."),
        "mutants": lambda: page(
            "Wrong programs that the suite has to catch", ["make mutants"], mutant_page(),
            f"{len(mutants())} of them, from `verification/mutants/mutants.toml`. "
            "Rung: where each has to be caught."),
        "examples": lambda: page(
            "The contact and the bearing of the root README",
            ["ehd solve examples/cylinder-on-plate.toml --tolerance 1e-4",
             "ehd bearing examples/roller-bearing.toml --details"],
            fenced(contact_without_cost(ehd)) + "\n\n" + fenced(bearings(ehd, "examples/roller-bearing.toml")),
            "Without costs, balance errors and times."),
    }
    judged = functools.cache(
        lambda: json.loads(run(ehd, "judge", "cases/submissions/ehd-fast-1e-3.json", "--json", "-")))
    written = {
        JUDGE: lambda: filled(typed(ehd, JUDGE), JUDGE, "first", first_cases(judged())),
        "README.md": lambda: filled(typed(ehd, "README.md"), "README.md", "numbers", numbers(comparison(), suite())),
        CASE_FORMAT: lambda: filled(typed(ehd, CASE_FORMAT), CASE_FORMAT, "keys", run(ehd, "new", "keys")),
    }
    figures = {"contact": ("solve", "examples/cylinder-on-plate.toml", "--tolerance", "1e-4"),
               "bearing": ("bearing", "examples/roller-bearing.toml")}
    pages = [str(page.relative_to(ROOT)) for page in walk.pages()]
    return {**{f"docs/figures/{name}.svg": functools.partial(figure, ehd, words) for name, words in figures.items()},
            **{name: functools.partial(typed, ehd, name) for name in pages}, **written,
            **{f"docs/results/{name}.md": made for name, made in results.items()}}


# ---- slow pages ----------------------------------------------------------------------------------------------------


def verdicts(stress):
    """What `ehd stress` prints at its end: a verdict and a sentence for each part."""
    return stress[re.search(r"^part +verdict ", stress, re.MULTILINE).start():]


def full_pages(ehd):
    whole = str
    slow = {"ladder-full": ("The ladder, full suite", ["verify"], whole),
            "stress": ("Numerical stability, the quick set", ["stress", "--quick"], verdicts),
            "bench": ("Time and work against achieved error, the quick set", ["bench", "--quick"], whole)}

    def make(title, words, shown):
        with tempfile.TemporaryDirectory() as folder:
            text = fenced(shown(run(ehd, *words, "--output", folder)))
        by = run(ehd, "--version").splitlines()[0] + "; " + run(ehd, "bench", "--part", "convolution").strip()
        return page(title, ["ehd " + " ".join(words)], text, by + ".").replace(MADE, MADE_SLOWLY)

    return {f"docs/results/{name}.md": functools.partial(make, *made) for name, made in slow.items()}


# ---- all of them ---------------------------------------------------------------------------------------------------


def check(pages):
    same = True
    for name, text in pages.items():
        kept = (ROOT / name).read_text() if (ROOT / name).exists() else ""
        versions = kept.splitlines(), text.splitlines(), name, name + " (made now)"
        for line in difflib.unified_diff(*versions, n=1, lineterm=""):
            print(line)
            same = False
    print("docs/results is as the program makes it" if same else "docs/results differs; to remake it: make results")
    return same


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--check", action="store_true", help=argparse.SUPPRESS)
    which.add_argument("--full", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--only", default="", metavar="NAME", help=argparse.SUPPRESS)
    parser.add_argument("ehd", metavar="EHD", help="the built program")
    arguments = parser.parse_args()
    ehd = str(pathlib.Path(arguments.ehd).resolve())
    makers = full_pages(ehd) if arguments.full else quick_pages(ehd)
    makers = {name: make for name, make in makers.items() if arguments.only in name}
    if not makers:
        parser.error(f"--only {arguments.only}: is in the path of no page")
    pages = {name: make() for name, make in makers.items()}
    if arguments.check:
        return 0 if check(pages) else 1
    for name, text in pages.items():
        (ROOT / name).write_text(text)
        print(name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
