# SPDX-License-Identifier: GPL-3.0-or-later
"""ehd.judge: what it does with the program's answers, by a stand-in; and one submission by the program itself."""

import json
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


@pytest.fixture
def stand_in(tmp_path, monkeypatch):
    file = tmp_path / "ehd"
    file.write_text(STAND_IN.format(python=sys.executable), encoding="utf-8")
    file.chmod(0o755)
    monkeypatch.setenv("EHD_PROGRAM", os.fspath(file))


@pytest.mark.usefixtures("stand_in")
@pytest.mark.parametrize("name", ["mine.json", "gate.json", "-strange.json"])
def test_a_judgement_is_read_by_attribute(name):
    judged = ehd.judge(name)
    assert judged.median["film.minimum"] == 3.2 and judged.name == name


@pytest.mark.usefixtures("stand_in")
def test_a_refused_file_is_bad_input():
    with pytest.raises(ehd.InputError, match="bad.json:1: schema"):
        ehd.judge("bad.json")


@pytest.mark.usefixtures("stand_in")
@pytest.mark.parametrize("wrong", [None, {}, 3, "", "mine\0.json"])
def test_what_is_no_path_is_bad_input(wrong):
    with pytest.raises(ehd.InputError) as caught:
        ehd.judge("mine.json", wrong)
    assert str(caught.value) == f"submission = {wrong!r}: is no path; allowed is the path of a submission"


@pytest.mark.usefixtures("stand_in")
def test_a_program_that_crashes_is_no_judgement():
    with pytest.raises(RuntimeError, match="ended with 3"):
        ehd.judge("crash.json")


def test_the_program_judges_a_submission_made_here(tmp_path, program):
    if program("judge", "--help").returncode != 0:
        pytest.skip("this program has no judge")
    r = ehd.solve("own-moes-20-10", tolerance=1e-4)
    result = {"case": r.case, "version": r.version, "scaling": "hertz", "film.minimum": r.film.minimum.hertz,
              "film.central": r.film.central.hertz, "stated_error": 1e-4}
    file = tmp_path / "mine.json"
    file.write_text(json.dumps({"schema": "ehd-submission-1", "solver": {"name": "ehd.solve", "version": "1"},
                                "results": [result]}), encoding="utf-8")
    judged = ehd.judge(file)
    scores = next(one for one in judged.cases if one.case == r.case).scores
    digits = {score.quantity: score.digits for score in scores if not score.missing}
    assert set(digits) == {"film.minimum", "film.central"} and min(digits.values()) >= 4  # tolerance 1e-4
    file.write_text("{}", encoding="utf-8")
    with pytest.raises(ehd.InputError, match="mine.json"):
        ehd.judge(file)
