# SPDX-License-Identifier: GPL-3.0-or-later
"""ehd.judge against a stand-in for the program: the score itself is tested with the program."""

import os
import sys

import ehd
import pytest

STAND_IN = """#!{python}
import json, sys
arguments, name = sys.argv[1:], sys.argv[-1]
assert arguments[:-1] == ["judge", "--json", "-", "--"], arguments
if name == "bad.json":
    print("bad.json:1: schema = x: is unknown", file=sys.stderr)
    sys.exit(2)
if name == "crash.json":
    sys.exit(3)
print(json.dumps({{"schema": "ehd-judge-1", "median": {{"film.minimum": 3.2}}, "name": name}}))
sys.exit(1 if name == "gate.json" else 0)
"""


@pytest.fixture(autouse=True)
def stand_in(tmp_path, monkeypatch):
    file = tmp_path / "ehd"
    file.write_text(STAND_IN.format(python=sys.executable), encoding="utf-8")
    file.chmod(0o755)
    monkeypatch.setenv("EHD_PROGRAM", os.fspath(file))


@pytest.mark.parametrize("name", ["mine.json", "gate.json", "-strange.json"])
def test_a_judgement_is_read_by_attribute(name):
    judged = ehd.judge(name)
    assert judged.median["film.minimum"] == 3.2 and judged.name == name


def test_a_refused_file_is_bad_input():
    with pytest.raises(ehd.InputError, match="bad.json:1: schema"):
        ehd.judge("bad.json")


def test_a_program_that_crashes_is_no_judgement():
    with pytest.raises(RuntimeError, match="ended with 3"):
        ehd.judge("crash.json")
