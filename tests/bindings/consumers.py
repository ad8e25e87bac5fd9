#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""consumers.py BUILD: the installed program and library, used as a newcomer would.

BUILD is installed into an empty folder, which is then moved: nothing may point back to the place of the installation.
Where this script runs as root, the program runs as an ordinary user who sees an empty folder in place of the source
tree: nothing may be found there. The blocks of docs/library.md are saved and run, in
order, with the flags of the page: none of the flags that the library was compiled with. Nothing is skipped: a compiler
that is missing is a failure with its name."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
NOBODY = 65534
# Of `ehd verify --quick`: all rungs with WHOLE_SUITE in the environment (make check-all), else these. Rung 10 reads
# every case and the atlas, and no other rung reads a file that it does not. Those left out take 75 of the 90 s of
# processor time.
LIGHT_RUNGS = ("0", "1", "2", "3", "4", "7", "9", "10")
INSTALLED = ["bin/ehd", "include/ehd/ehd.h", "lib/libehd.so", "lib/libehd.so.0", "lib/pkgconfig/ehd.pc",
             "lib/cmake/ehd/ehd-config.cmake", "lib/python3/dist-packages/ehd/__init__.py",
             "share/ehd/cases/na4908.toml", "share/ehd/fortran/ehd.f90", "share/ehd/octave/ehd_solve.m",
             "share/bash-completion/completions/ehd", "share/zsh/vendor-completions/_ehd"]
if shutil.which("help2man"):
    INSTALLED += ["share/man/man1/ehd.1.gz", "share/man/man1/ehd-solve.1.gz"]
# sh -c HIDE FOLDER COMMAND...: the command as an ordinary user, to whom the folder is empty.
AS_NOBODY = f"setpriv --reuid={NOBODY} --regid={NOBODY} --clear-groups"
HIDE = f'mount -t tmpfs none "$0" && exec {AS_NOBODY} "$@"'


def run(command, **options):
    """The standard output of a command that must succeed."""
    ended = subprocess.run(command, text=True, capture_output=True, timeout=600, **options)
    if ended.returncode != 0:
        sys.exit(f"consumers.py: {command}: exit code {ended.returncode}\n{ended.stdout[-4000:]}{ended.stderr[-4000:]}")
    return ended.stdout


def need(condition, what):
    if not condition:
        sys.exit(f"consumers.py: {what}")


def install(build, folder):
    """The folder to which the installed tree was moved."""
    first, moved = folder / "first", folder / "moved"
    run(["cmake", "--install", str(build), "--prefix", str(first)])
    first.rename(moved)
    for name in INSTALLED:
        need((moved / name).is_file(), f"{name} was not installed")
    for file in (moved / "lib/pkgconfig/ehd.pc", *(moved / "lib/cmake/ehd").iterdir()):
        for place in (str(first), str(SOURCE)):
            need(place not in file.read_text(), f"{file.name} names {place}")
    return moved


def as_newcomer():
    """What runs a command as HIDE says; else as it is, with a line that says so."""
    hidden = ["unshare", "--mount", "sh", "-c", HIDE, str(SOURCE)]
    sees = subprocess.run([*hidden, "ls", str(SOURCE)], text=True, capture_output=True)
    if sees.returncode == 0:
        need(sees.stdout == "", f"{SOURCE} is not hidden: {sees.stdout}")
        return hidden
    print("consumers.py: the source tree is in sight: only root can hide it")
    return AS_NOBODY.split() if os.getuid() == 0 else []


def use_program(prefix, newcomer):
    environment = {key: value for key, value in os.environ.items() if not key.startswith("EHD_")}

    def ehd(*arguments):
        return run([*newcomer, str(prefix / "bin/ehd"), *arguments], env=environment, cwd="/")

    # A case that the source tree does not have: the cases are those beside the program.
    text = (prefix / "share/ehd/cases/dry-steel.toml").read_text()
    (prefix / "share/ehd/cases/only-here.toml").write_text(text.replace('"dry-steel"', '"only-here"'))
    need("only-here" in ehd("cases"), "the installed cases were not found")
    need("converged" in ehd("solve", "own-moes-20-10"), "ehd solve")
    need("ehd-linear" in ehd("bearing", "na4908"), "ehd bearing")
    for part in [[]] if "WHOLE_SUITE" in os.environ else [["--rung", rung] for rung in LIGHT_RUNGS]:
        need("\nall " in ehd("verify", "--quick", *part), f"ehd verify --quick {part}")


def use_python(prefix, newcomer):
    """The line of docs/python.md for an installation, by Debian's Python, which has NumPy where any has it."""
    line = re.search(r"^    (PYTHONPATH=\$PREFIX.*)$", (SOURCE / "docs/python.md").read_text(), re.MULTILINE)
    need(line, "docs/python.md has no line for an installation")
    environment = {key: value for key, value in os.environ.items() if not key.startswith(("EHD_", "PYTHON"))}
    environment |= {"PREFIX": str(prefix), "PATH": f"/usr/bin:{os.environ['PATH']}"}
    if subprocess.run(["python3", "-c", "import numpy"], env=environment, capture_output=True).returncode != 0:
        print("consumers.py: Python was not tried: there is no NumPy")
        return
    output = run([*newcomer, "sh", "-ec", line[1]], env=environment, cwd="/")
    need("hertz=0.078" in output, f"{line[1]}\nprints {output}")


def follow_page(prefix, folder):
    """Runs docs/library.md: a block after `name`: becomes that file, a block of sh is run."""
    page = (SOURCE / "docs/library.md").read_text()
    flags = ("CMAKE", "CFLAGS", "CXXFLAGS")
    environment = {key: value for key, value in os.environ.items() if not key.startswith(flags)}
    environment["PREFIX"] = str(prefix)
    script, files = ["set -eu"], 0
    block = re.compile(r"(?:`([\w.]+)`:\n\n)?^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    for name, language, text in block.findall(page):
        if language == "sh":
            script.append(text)
            continue
        need(name, f"a block of {language} has no file name before it")
        (folder / name).write_text(text)
        files += 1
    need(files == 3 and len(script) == 5, f"docs/library.md has {files} files and {len(script) - 1} blocks of sh")
    output = run(["sh", "-c", "\n".join(script)], cwd=folder, env=environment)
    for pattern in (r"^minimum film 0\.\d+ um, relative error \de-0[4-9]$",  # C
                    r"^2e-06 m: \d\d\d+(\.\d+)? N, [\d.e+]+ N/m$",  # C++
                    r"^minimum film 0\.0780\d\d at X = 0\.9\d\d, relative error \d\.\dE-0[5-9]$",  # Fortran
                    r"^the film at \d+ nodes is nowhere below 0\.07[78]\d\d\d$"):
        need(re.search(pattern, output, re.MULTILINE), f"{pattern} is not in what the page's programs print:\n{output}")
    strict = ["cc", "-std=c99", "-O0", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I",
              str(prefix / "include"), "contact.c"]
    run(strict, cwd=folder)


def main():
    need(len(sys.argv) == 2, "usage: consumers.py BUILD")
    for tool in ("cmake", "cc", "gfortran", "pkg-config"):
        need(shutil.which(tool), f"{tool} is not installed")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)  # for the ordinary user
        prefix = install(pathlib.Path(sys.argv[1]), folder)
        newcomer = as_newcomer()
        use_program(prefix, newcomer)
        use_python(prefix, newcomer)
        (folder / "work").mkdir()
        follow_page(prefix, folder / "work")


main()
