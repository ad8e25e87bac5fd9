#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Types what a page says, in an empty folder, and compares what comes out with what the page shows.

  walk.py EHD PAGE...           exit code 0: the pages are right; 1: one is not; 77: a Python module is missing
  walk.py --write EHD PAGE...   puts what comes out into the page (make results)

A block of ```console has commands, each after "$ ", and under each what it prints, standard output and standard error
together. Any other block after a line "`NAME`:" is a file with that name. Files and commands of a page are taken in its
order, in one folder, where examples/ and build/ehd are as in a clone. A command has to end with exit code 0; a line
"exit code N" at the end of its output states another one. Times, and what rounding or the commit decide, may differ:
VARYING. A number of four digits and more in the words of such a page, or one with its error in brackets, has to stand
in one of its blocks, or in docs/results. So has one of any other page of docs/; the README of a folder may have numbers
of publications.

A line "    ehd ..." of an indented block is typed as well, and has to succeed, and so has `ehd ...` in a sentence. Left
out are commands with a place for a word (FILE, [--option]), those that name an option without its value
(`ehd solve --json`), and those of not_typed.toml, which take minutes.
"""
import functools
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import tomllib

import names

ROOT = pathlib.Path(__file__).resolve().parents[2]
SKIPPED = 77
TIMEOUT_S = 120  # ten times what the slowest command takes
MODULES = {"numpy": "python3-numpy", "matplotlib": "python3-matplotlib"}  # what a page's Python may import
CLONED = ("examples", "cases", "Makefile", "cmake")  # what a page's commands use of a clone
# What may differ between two runs: the pattern, and what stands for it in a comparison.
VARYING = (
    (r"^cost  .*", "cost"),  # times, and iterations, which rounding may decide
    (r"load error \S+, flux variation \S+", "load error"),  # residuals of an iteration
    (r"\b\d[\d.e+-]* (ms|s)\b", "a time"),
    (r"on \d+ threads?", "on threads"),
    (r", (commit [0-9a-f]+(, changed since)?|no commit)", ""),
    (r"\b\d{4}-\d\d-\d\dT[\d:]+Z", "now"),
    (r"\([^()]*FFTW [^()]*\)", "libraries"),
)
YEAR = re.compile(r"  year         = \{\d{4}\},")  # of the commit: there is none without git
LOOSE = re.compile(r"^    (?:build/)?(ehd [a-z].*?)(?:  .*|)$|`(?:build/)?(ehd [a-z]+ [^`\n]+)`", re.MULTILINE)
PLACE = re.compile(r"\b[A-Z]{2,}\b|[\[{|]|\.\.\.|…")  # for a word: FILE, [--option], one|other
BLOCK = re.compile(r"(?:`(?P<name>[\w-]+\.\w+)`:\n\n)?^```(?P<kind>\w+)\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)


class Wrong(Exception):
    """A page that does not say what happens."""


class Skipped(Exception):
    """A page that needs what is not installed."""


def constant(text):
    """The lines of a text, without what may differ between two runs."""
    lines = [line for line in text.splitlines() if not YEAR.fullmatch(line)]
    for pattern, word in VARYING:
        lines = [re.sub(pattern, word, line) for line in lines]
    return lines


def same(shown, printed):
    """Whether two texts say the same, line by line, up to VARYING."""
    return constant(shown) == constant(printed)


@functools.cache
def python_with(modules):
    """A Python that has the modules: this one, or Debian's, whose packages they are. None: neither has."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", f"import {modules}"], capture_output=True).returncode == 0:
            return python
    return None


class Shell:
    """A folder as a newcomer has it, and the commands that are typed there."""

    def __init__(self, ehd, folder):
        self.ehd, self.folder = ehd, folder / "here"
        self.words = folder / "bin"
        self.words.mkdir()
        (self.words / "ehd").symlink_to(ehd)
        outer_make = ("MAKEFLAGS", "MFLAGS", "MAKELEVEL", "MAKEOVERRIDES", "BUILD")  # of `make results BUILD=...`
        mine = {name: value for name, value in os.environ.items() if name not in outer_make}
        self.environment = {**mine, "PATH": f"{self.words}:{os.environ['PATH']}", "MPLBACKEND": "Agg"}
        self.as_in_a_clone(self.folder)
        self.has_program()

    @staticmethod
    def as_in_a_clone(folder):
        folder.mkdir()
        for name in CLONED:
            (folder / name).symlink_to(ROOT / name)

    def has_program(self):
        build = self.folder / "build"
        build.mkdir(exist_ok=True)
        if not (build / "ehd").exists():
            (build / "ehd").symlink_to(self.ehd)

    def clone(self, words):
        """git clone URL FOLDER: the tree without what is built."""
        self.as_in_a_clone(self.folder / words[-1])
        return ""

    def build(self, words):
        """make build: that the target leads to a program; this one is taken for it."""
        plan = self.typed(" ".join([words[0], "--dry-run", *words[1:]]))
        said = re.search(r'^echo "(.*)"$', plan, re.MULTILINE)
        if not re.search(r"^cmake --build build .*--target ehd_program$", plan, re.MULTILINE) or not said:
            raise Wrong(f"`{' '.join(words)}` does not build the program:\n{plan}")
        self.has_program()
        return said[1] + "\n"

    def has_python_for(self, script):
        """python3 is one that has the modules of the script."""
        modules = [name for name in MODULES if re.search(rf"^(import|from) {name}\b", script, re.MULTILINE)]
        python = python_with(", ".join(modules or ["sys"]))
        if python is None:
            raise Skipped("not installed: " + " or ".join(MODULES[name] for name in modules))
        (self.words / "python3").unlink(missing_ok=True)
        (self.words / "python3").symlink_to(python)

    def typed(self, command):
        """What the command prints."""
        words = command.split()
        if words[0] == "cd" and len(words) == 2:
            self.folder = self.folder / words[1]
            return ""
        # The network and four minutes of building are not for a test; make dist-check does both from the tarball.
        if words[:2] == ["git", "clone"]:
            return self.clone(words)
        if command == "make build":
            return self.build(words)
        for script in (word for word in re.findall(r"[\w./-]+\.py\b", command) if (self.folder / word).exists()):
            self.has_python_for((self.folder / script).read_text())
        with subprocess.Popen(["sh", "-c", command], cwd=self.folder, env=self.environment, start_new_session=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True) as running:
            try:
                printed, _ = running.communicate(timeout=TIMEOUT_S)
            except subprocess.TimeoutExpired:
                os.killpg(running.pid, signal.SIGKILL)  # the shell, and what it started
                raise
        return printed + (f"exit code {running.returncode}\n" if running.returncode else "")


def turns(body):
    """(command, what is shown under it) of a block."""
    found = []
    for line in body.splitlines(True):
        if line.startswith("$ "):
            found.append([line[2:].rstrip("\n"), ""])
        elif found:
            found[-1][1] += line
        else:
            raise Wrong(f"a console block begins with no command: {line}")
    return found


@functools.cache
def not_typed():
    """{command: who runs it instead}"""
    tables = tomllib.loads((pathlib.Path(__file__).parent / "not_typed.toml").read_text())
    return {command: by for by, commands in tables.items() for command in commands}


def whole_commands(ehd, text):
    """The commands of indented lines and of sentences that can be typed as they stand."""
    found = [indented or inline for indented, inline in LOOSE.findall(BLOCK.sub("", text))]
    return [command for command in found if not PLACE.search(command) and not names.lacks_value(str(ehd), command)]


def loose(ehd, text):
    """Those of them that a test types, each once."""
    return [command for command in dict.fromkeys(whole_commands(ehd, text)) if command not in not_typed()]


def unfounded(text):
    """Numbers in the words of a page that neither a block of it shows nor a page of docs/results, which is made."""
    shown = "".join(re.findall(r"^```.*?^```|^    .*?$", text, re.DOTALL | re.MULTILINE))
    shown += "".join(page.read_text() for page in sorted((ROOT / "docs" / "results").glob("*.md")))
    words = re.sub(r"<!-- .*?<!-- end -->|^```.*?^```|^    .*?$|`[^`]*`", "", text, flags=re.DOTALL | re.MULTILINE)
    return [number for number in re.findall(r"(?<![\w.])\d+\.\d+(?:\(\d+\))?(?![\w-]|\.\d)", words)
            if (number.endswith(")") or len(re.sub(r"^0\.0*|\.", "", number)) >= 4) and number not in shown]


def walked(ehd, page):
    """The page with what its commands print now, and a line for each command that prints something else."""
    text, faults = page.read_text(), []
    with tempfile.TemporaryDirectory() as name:
        shell = Shell(ehd, pathlib.Path(name))

        def follow(block):
            if block["kind"] != "console":
                if block["name"]:
                    (shell.folder / block["name"]).write_text(block["body"])
                return block[0]
            made = ""
            for command, shown in turns(block["body"]):
                printed = shell.typed(command)
                if not same(shown, printed):
                    faults.append(f"$ {command}\nthe page shows\n{shown}the command prints\n{printed}")
                    shown = printed
                made += f"$ {command}\n{shown}"
            return f"{block[0][:block.start('body') - block.start()]}{made}```"

        text = BLOCK.sub(follow, text)
        for command in loose(ehd, text):
            if re.search(r"^exit code \d", printed := shell.typed(command), re.MULTILINE):
                faults.append(f"{command}: fails\n{printed}")
    if "```console" in text or page.name != "README.md":
        faults += [f"{number} is in the words of the page, and no command prints it" for number in unfounded(text)]
    return text, faults


def pages():
    """The pages that show what their commands print: README.md and those of docs/."""
    candidates = (ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md")))
    return [page for page in candidates if "```console" in page.read_text()]


def main(arguments):
    write = arguments[:1] == ["--write"]
    if len(arguments) < (3 if write else 2):
        print(__doc__, file=sys.stderr)
        return 2
    ehd, *pages = [pathlib.Path(word).resolve() for word in arguments[write:]]
    wrong = False
    for page in pages:
        try:
            text, faults = walked(ehd, page)
        except Skipped as reason:
            print(f"{page.name}: skipped: {reason}")
            return SKIPPED
        except Wrong as fault:
            text, faults = None, [str(fault)]
        if write and text is not None:
            page.write_text(text)
            faults = [fault for fault in faults if not fault.startswith("$ ")]  # those are mended
        if faults:
            wrong = True
            print(f"{page}:", *faults, "to put what the commands print into the pages: make results", sep="\n")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
