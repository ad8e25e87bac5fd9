#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""names.py EHD: what the pages name exists. Exit code 0: all; 1: a name is wrong.

Every README.md and every page of docs/ but docs/results:
- `ehd COMMAND --option`: the program's help has command and option;
- `make TARGET`: the Makefile has the target;
- [a link](to/a/file): the file is there, and the heading after #;
- `folder/file.cpp`: the file is there, seen from the root or from the page;
- the version is one in CMakeLists.txt, CITATION.cff, CHANGELOG.md and cases/references.bib;
- docs/README.md links every page of docs/;
- docs/start.md: at most four commands from a clone to a result;
- a table with the columns "function" and "file": the file has the function;
- the commands in not_typed.toml stand on a page, and something runs them, or they are named there as left to people.
"""
import functools
import pathlib
import re
import subprocess
import sys
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = [path.name for path in ROOT.iterdir() if path.is_dir() and not path.name.startswith((".", "build", "out"))]
FILE = re.compile(rf"`((?:{'|'.join(map(re.escape, ROOMS))})/[\w./-]+\.(?:cpp|hpp|ipp|h|py|md|toml|json|sh|f90|m))`")
NO_STEP = "no step"  # the table of not_typed.toml with what no step runs
MADE = "docs/results/"  # some of them are not committed
COMMAND = re.compile(r"(?:^|`|\$ |\| |    )(?:build/)?ehd ([a-z]+)((?: [^`|\n]*)?)", re.MULTILINE)
CONSOLE = re.compile(r"^```console\n.*?^```", re.MULTILINE | re.DOTALL)
TYPED = re.compile(r"^\$ .*$", re.MULTILINE)
MAKE = re.compile(r"(?:`|^    |^\$ )make ([a-z][a-z-]*)", re.MULTILINE)
LINK = re.compile(r"\]\((?!https?:|mailto:)([^)#\s]*)(?:#([\w-]+))?\)")


def pages():
    """(page, its text). What is built, found or made is no page of ours."""
    found = [path for room in ROOMS for path in (ROOT / room).rglob("*.md")] + list(ROOT.glob("*.md"))
    return [(path, path.read_text()) for path in sorted(found) if MADE not in str(path)]


@functools.cache
def help_of(ehd, command):
    """What `ehd COMMAND --help` says; empty for no command."""
    asked = subprocess.run([ehd, command, "--help"], capture_output=True, text=True)
    return asked.stdout if asked.returncode == 0 else ""


def lacks_value(ehd, command):
    """Whether the last word is an option that wants a value: such a command names an option, and cannot be typed."""
    _, subcommand, *words = command.split()
    wants_value = re.compile(rf"^ +{re.escape(words[-1])} [A-Z]+\b" if words else r"\Z.", re.MULTILINE)
    return bool(wants_value.search(help_of(ehd, subcommand)))


def code_of(text):
    """The text without its prose: blocks of code, of the console only what is typed, and words in backticks."""
    typed = CONSOLE.sub(lambda block: "\n".join(TYPED.findall(block[0])), text)
    blocks = re.findall(r"^```\w*\n.*?^```|^    .*?$|^\$ .*?$|`[^`\n]+`", typed, re.MULTILINE | re.DOTALL)
    return "\n".join(blocks)


def wrong_commands(ehd, text):
    for command, rest in COMMAND.findall(code_of(text)):
        said = help_of(ehd, command)
        if not said:
            yield f"ehd {command}: there is no such command"
        for option in re.findall(r"(?<![\w'-])--[a-z][\w-]*", rest):
            if said and not re.search(rf"{option}\b(?!-)", said):
                yield f"ehd {command} {option}: the command has no such option"


def wrong_targets(text):
    for target in MAKE.findall(code_of(text)):
        if target not in targets():
            yield f"make {target}: the Makefile has no such target"


def anchors(text):
    """The anchors of the headings, as GitHub and the site make them."""
    headings = re.findall(r"^#+ (.*)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def wrong_links(page, text):
    prose = re.sub(r"^```\w*\n.*?^```", "", text, flags=re.MULTILINE | re.DOTALL)
    for place, anchor in LINK.findall(prose):
        target = (page.parent / place).resolve() if place else page
        if not target.exists():
            yield f"{place}: the link leads nowhere"
        elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text()):
            yield f"{place}#{anchor}: the page has no such heading"


def wrong_files(page, text):
    for file in FILE.findall(text):
        if not file.startswith(MADE) and not any((folder / file).exists() for folder in (ROOT, page.parent)):
            yield f"{file}: there is no such file"


def cells(row):
    return [cell.strip() for cell in row.strip().strip("|").split(" | ")]


def has_function(source, name):
    """Whether a source file has the function, written Class::function or function."""
    *scope, function = name.split("::")
    return re.search(rf"\b{function}\(", source) and all(re.search(rf"\b{part}\b", source) for part in scope)


def wrong_functions(text):
    """Rows of tables with the columns "function" and "file"; a cell may name several, in backticks."""
    for table in re.findall(r"(?:^\|.*\|\n)+", text, re.MULTILINE):
        header, _, *rows = table.splitlines()
        if not {"function", "file"} <= set(cells(header)):
            continue
        at_function, at_file = cells(header).index("function"), cells(header).index("file")
        for row in map(cells, rows):
            files = [ROOT / name for name in re.findall(r"`([^`]+)`", row[at_file])]
            missing = [file for file in files if not file.exists()]
            yield from (f"{file.relative_to(ROOT)}: there is no such file" for file in missing)
            source = "" if missing else "".join(file.read_text() for file in files)
            for name in re.findall(r"`([\w:]+)`", row[at_function]):
                if not missing and not has_function(source, name):
                    yield f"{name}: {row[at_file]} has no such function"


def versions():
    """Where the version stands: file, version."""
    places = {"CMakeLists.txt": r"^project\(ehd VERSION ([\d.]+)", "CITATION.cff": r"^version: (\S+)",
              "CHANGELOG.md": r"^## ([\d.]+)", "cases/references.bib": r"^@misc\{own,.*?version = \{([\d.]+)"}
    return {file: re.search(pattern, (ROOT / file).read_text(), re.MULTILINE | re.DOTALL)[1]
            for file, pattern in places.items()}


def different_versions(found):
    return [f"the version is not one: {found}"] if len(set(found.values())) != 1 else []


@functools.cache
def targets():
    return set(re.findall(r"^([a-z][a-z-]*):", (ROOT / "Makefile").read_text(), re.MULTILINE))


def long_starts(page, text):
    """start.md: from a clone to the first own result, at most four commands."""
    if page == ROOT / "docs" / "start.md":
        commands = TYPED.findall(CONSOLE.search(text)[0])
        if len(commands) > 4 or not commands[0].startswith("$ git clone") or " solve " not in commands[-1]:
            yield f"{len(commands)} commands from a clone to a result; at most 4"


def forgotten(page, text):
    """docs/README.md links every page of docs/."""
    if page == ROOT / "docs" / "README.md":
        linked = {place for place, _ in LINK.findall(text)}
        yield from (f"{other.name}: the list has no link to it" for other in page.parent.glob("*.md")
                    if other.name not in linked | {page.name})


@functools.cache
def steps():
    """{name: command} of .ci/steps.toml"""
    return {step["name"]: step["command"] for step in tomllib.loads((ROOT / ".ci" / "steps.toml").read_text())["step"]}


def stale_rows(tables, texts):
    """Rows of not_typed.toml whose command stands on no page, and tables that name nothing that runs; targets on pages
    that neither a step of .ci/steps.toml nor a row has."""
    code = "\n".join(map(code_of, texts))
    for by, commands in tables.items():
        if by not in {NO_STEP, *steps()} and by.removeprefix("make ") not in targets():
            yield f"not_typed.toml: {by}: neither a target of the Makefile nor a step of .ci/steps.toml"
        for command in commands:
            if not re.search(rf"{re.escape(command)}(?=`|  |$)", code, re.MULTILINE):
                yield f"not_typed.toml: {command}: no page has this command"
    made = [word for command in steps().values() if command.startswith("make ") for word in command.split()]
    for target in dict.fromkeys(MAKE.findall(code)):
        if target not in made and f"make {target}" not in tables.get(NO_STEP, {}):
            yield f"make {target}: a page has it, and neither .ci/steps.toml nor not_typed.toml"


def faults(ehd, page, text):
    return [*wrong_commands(ehd, text), *wrong_targets(text), *wrong_links(page, text), *wrong_files(page, text),
            *wrong_functions(text), *long_starts(page, text), *forgotten(page, text)]


def main(arguments):
    if len(arguments) != 1:
        print(__doc__, file=sys.stderr)
        return 2
    ehd = str(pathlib.Path(arguments[0]).resolve())
    wrong = [f"{page.relative_to(ROOT)}: {fault}" for page, text in pages() for fault in faults(ehd, page, text)]
    wrong += different_versions(versions())
    wrong += stale_rows(tomllib.loads((HERE / "not_typed.toml").read_text()), [text for _, text in pages()])
    print(*wrong, sep="\n", end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
