#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""wrong_pages.py EHD: walk.py and names.py notice a page that is wrong. Exit code 0: each one; 1: one is missed.

Each row is a page that is right, the text in it that is replaced, and by what."""
import pathlib
import subprocess
import sys
import tempfile

import names
import walk

HERE = pathlib.Path(__file__).resolve().parent
SOLVE = """The film of `my.txt` is 0.07808, or 3.976(4): `ehd new contact`, and `ehd solve --json` too.

    ehd convert M=20 L=10   # the same in other groups
    ehd convert WORD

`my.txt`:

```text
film.minimum
```

```console
$ ehd solve --M 20 --L 10 | grep -f my.txt | head -n 1
  film.minimum   0.07808(8)   3.976(4)  0.939
$ ehd solve --M 20 --L 1000
--L 1000: is out of range; allowed is 0, or 1e-12 to 100
exit code 2
$ ehd convert M=20 L=10 | wc -l
```
"""
WALKED = (
    ("another digit", "0.07808(8)", "0.07809(8)"),
    ("a line less", "  film.minimum   0.07808(8)   3.976(4)  0.939\n", ""),
    ("a number that no block shows", "is 0.07808", "is 0.07809"),
    ("an error that no block shows", "or 3.976(4)", "or 3.976(5)"),
    ("another file", "```text\nfilm.minimum", "```text\nfilm.central"),
    ("a failure that is not said", "exit code 2\n", ""),
    ("an indented command that fails", "    ehd convert M=20 L=10   #", "    ehd convert X=20 L=10   #"),
    ("a command in a sentence that fails", "`ehd new contact`", "`ehd new conact`"),
    ("a command that is not there", "ehd solve --M 20 --L 10 ", "ehd sovle --M 20 --L 10 "),
)
LOOSE = "The film is 0.07808:\n\n    ehd convert M=20 L=10   # the same in other groups\n"  # no block shows the number
NAMED = """    ehd solve own-moes-20-10 --tolerance 1e-4

`make verify` and `contact/hertz.cpp`; [tests](README.md#tests).

## Tests

| function | file |
|---|---|
| `half_width_m` | `contact/hertz.cpp` |
"""
NAMES = (
    ("a command", "ehd solve", "ehd sovle"),
    ("an option", "--tolerance", "--tolerence"),
    ("a target", "make verify", "make verifi"),
    ("a file", "`contact/hertz.cpp`;", "`contact/herz.cpp`;"),
    ("a link", "](README.md", "](READNE.md"),
    ("a heading", "README.md#tests", "README.md#test"),
    ("a function", "`half_width_m`", "`half_with_m`"),
    ("a file of a function", "| `contact/hertz.cpp` |", "| `contact/herz.cpp` |"),
)
ROW_PAGE = "`ehd verify --quick`, `make verify`, `make atlas`\n\n    ehd bench --quick  some parts\n"
ATLAS = {"no step": {"make atlas": "an hour"}}
ROWS = (
    ("a target that nothing runs", {}, 1),
    ("right rows", {**ATLAS, "make verify": {"ehd verify --quick": ""}, "bench, quick": {"ehd bench --quick": ""}}, 0),
    ("a command of no page", {**ATLAS, "make verify": {"ehd verify": "minutes"}}, 1),
    ("a target that is not there", {**ATLAS, "make verifi": {"ehd verify --quick": "a minute"}}, 1),
)
LONG_START = """```console
$ git clone URL ehd
$ cd ehd
$ make build
$ build/ehd new contact my-contact.toml
$ build/ehd solve my-contact.toml
```
"""


def walked(ehd, folder, text):
    page = folder / "page.md"
    page.write_text(text)
    return subprocess.run([sys.executable, HERE / "walk.py", ehd, page], capture_output=True, text=True)


def main(ehd):
    missed = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        right = folder / "right.md"
        right.write_text(SOLVE)
        subprocess.run([sys.executable, HERE / "walk.py", "--write", ehd, right], check=True)  # the last output
        page = right.read_text()
        if walked(ehd, folder, page).returncode != 0:
            missed.append("the right page is called wrong: " + walked(ehd, folder, page).stdout)
        for what, text, by in WALKED:
            if page.count(text) < 1 or walked(ehd, folder, page.replace(text, by, 1)).returncode != 1:
                missed.append(f"walk.py: {what}")
        rounded = LOOSE.replace("0.07808", "0.078")
        if (walked(ehd, folder, LOOSE).returncode, walked(ehd, folder, rounded).returncode) != (1, 0):
            missed.append("walk.py: a number on a page that shows no output")
        readme = folder / "README.md"
        for what, text, by in (("nothing", "", ""), *NAMES):
            wrong = NAMED.replace(text, by, 1)
            readme.write_text(wrong)
            faults = list(names.faults(str(ehd), readme, wrong))
            if bool(faults) != bool(text):
                missed.append(f"names.py: {what}: {faults}")
    docs = names.ROOT / "docs"
    listed = (docs / "README.md").read_text().replace("](faq.md)", "](glossary.md)")
    if not list(names.forgotten(docs / "README.md", listed)):
        missed.append("names.py: a page that docs/README.md forgets")
    if not list(names.long_starts(docs / "start.md", LONG_START)):
        missed.append("names.py: five commands to a result")
    if not names.different_versions({**names.versions(), "CITATION.cff": "0.0.1"}):
        missed.append("names.py: another version")
    for what, rows, faults in ROWS:
        if len(list(names.stale_rows(rows, [ROW_PAGE]))) != faults:
            missed.append(f"names.py: {what} of not_typed.toml")
    print(*missed, sep="\n", end="\n" if missed else "")
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
