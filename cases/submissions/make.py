#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remakes the submissions of this folder: make submissions.

  make.py EHD [--only NAME]

This project's own solvers, and the template of examples/solvers, on the first ten cases of ehd judge. No times and no
profiles, so that another machine makes the same text up to rounding. The template needs NumPy.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TEMPLATE = HERE.parents[1] / "examples" / "solvers" / "line_contact.py"
OWN = {  # file: (solver, tolerance)
    "ehd-reference": ("reference", "1e-8"),
    "ehd-fast-1e-6": ("fast", "1e-6"),
    "ehd-fast-1e-3": ("fast", "1e-3"),
    "ehd-fast-uniform-1e-3": ("fast.uniform", "1e-3"),
}
TEMPLATE_TOLERANCE = "5e-3"
DIGITS = 12


def run(*command, codes=(0, 1)):
    process = subprocess.run(command, capture_output=True, text=True)
    if process.returncode not in codes:
        sys.exit(f"{' '.join(map(str, command))}: exit code {process.returncode}\n{process.stderr}")
    return process.stdout


def first_cases(ehd):
    """As a judgement names them: it lists those that a submission leaves out."""
    one = {"case": "own-barus-5-5", "version": 1, "scaling": "hertz", "film.minimum": 0.2467}
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump({"schema": "ehd-submission-1", "solver": {"name": "none"}, "results": [one]}, file)
        file.flush()
        cases = json.loads(run(ehd, "judge", file.name, "--json", "-"))["cases"]
    return [case["case"] for case in sorted((c for c in cases if "place" in c), key=lambda c: c["place"])]


def rounded(value):
    return float(f"{value:.{DIGITS}g}")


def result_of(solved):
    result = {"case": solved["case"], "version": solved["version"], "scaling": "hertz"}
    errors = []
    for name in ("minimum", "central"):
        film = solved["film"][name]
        result[f"film.{name}"] = rounded(film["hertz"])
        errors.append(film["error"])
    if "spike" in solved["pressure"]:
        result["pressure.spike"] = rounded(solved["pressure"]["spike"]["hertz"])
    result["pressure.exit"] = rounded(solved["pressure"]["exit_x"])
    result["stated_error"] = float(f"{max(errors):.1e}")
    return result


def own(ehd, cases, solver, tolerance):
    results = []
    for case in cases:
        solved = json.loads(run(ehd, "solve", case, "--solver", solver, "--tolerance", tolerance, "--json", "-"))
        if "film" in solved:
            results.append(result_of(solved))
    return {"schema": "ehd-submission-1",
            "solver": {"name": f"ehd {solver}", "version": f"tolerance {tolerance}"}, "results": results}


def template(ehd, cases):
    made = None
    with tempfile.TemporaryDirectory() as folder:
        problem, out = pathlib.Path(folder, "case.json"), pathlib.Path(folder, "out.json")
        for case in cases:
            problem.write_text(json.dumps(json.loads(run(ehd, "cases", case, "--json"))["cases"][0]["problem"]))
            out.unlink(missing_ok=True)
            subprocess.run([sys.executable, TEMPLATE, problem, out, TEMPLATE_TOLERANCE], stderr=subprocess.DEVNULL)
            if not out.exists():
                continue  # it found nothing: the case is missing
            one = json.loads(out.read_text())
            for result in one["results"]:
                result.pop("wall_s"), result.pop("profile")
                for key, value in result.items():
                    if "." in key:
                        result[key] = rounded(value)
                result["stated_error"] = float(f"{result['stated_error']:.1e}")
            made = made or one | {"results": []}
            made["results"] += one["results"]
    return made


def main(ehd, only=None):
    cases = first_cases(ehd)
    makers = {name: lambda one=one: own(ehd, cases, *one) for name, one in OWN.items()}
    makers["line-contact-py"] = lambda: template(ehd, cases)
    for name, make in makers.items():
        if only in (None, name):
            (HERE / f"{name}.json").write_text(json.dumps(make(), indent=2) + "\n")
            print(HERE / f"{name}.json")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    main(sys.argv[1], *sys.argv[3:])
