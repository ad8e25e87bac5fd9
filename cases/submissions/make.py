#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Remakes the submissions of this folder: make submissions.

  make.py EHD [--only NAME]           writes them
  make.py --check EHD                 fails where one differs from what its solver finds now, beyond rounding

This project's own solvers, and the templates of examples/solvers, on the first ten cases of ehd judge. No times and no
profiles, so that another machine makes the same text up to rounding. The templates need NumPy, gfortran and Octave;
--check judges those that can run here.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SOLVERS = HERE.parents[1] / "examples" / "solvers"
OWN = {  # file: (solver, tolerance)
    "ehd-reference": ("reference", "1e-8"),
    "ehd-reference-linear-1e-3": ("reference.linear", "1e-3"),
    "ehd-reference-uniform-1e-2": ("reference.uniform", "1e-2"),  # to 1e-3 two of the cases take minutes, and miss it
    "ehd-fast-1e-6": ("fast", "1e-6"),
    "ehd-fast-1e-3": ("fast", "1e-3"),
    "ehd-fast-uniform-1e-3": ("fast.uniform", "1e-3"),
}
TEMPLATE_TOLERANCE = "5e-3"
DIGITS = 12
SAME = 1e-7  # relative; an iteration that ends elsewhere moves a number by less


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


def templates(folder):
    """The command of each that can run here; the Fortran one is compiled into the folder."""
    found = {}
    if subprocess.run([sys.executable, "-c", "import numpy"], capture_output=True).returncode == 0:
        found["line-contact-py"] = [sys.executable, SOLVERS / "line_contact.py"]
    if shutil.which("gfortran"):
        program = pathlib.Path(folder, "line_contact")
        subprocess.run(["gfortran", "-O2", "-o", program, SOLVERS / "line_contact.f90"], check=True, cwd=folder)
        found["line-contact-f90"] = [program]
    if shutil.which("octave-cli"):
        found["line-contact-m"] = ["octave-cli", "--norc", SOLVERS / "line_contact.m"]
    return found


def template(ehd, cases, command, folder):
    made = None
    problem, out = pathlib.Path(folder, "case.json"), pathlib.Path(folder, "out.json")
    for case in cases:
        problem.write_text(json.dumps(json.loads(run(ehd, "cases", case, "--json"))["cases"][0]["problem"]))
        out.unlink(missing_ok=True)
        subprocess.run([*command, problem, out, TEMPLATE_TOLERANCE], stderr=subprocess.DEVNULL)
        if not out.exists():
            continue  # it found nothing: the case is missing
        one = json.loads(out.read_text())
        for result in one["results"]:
            result.pop("wall_s", None), result.pop("profile", None)
            for key, value in result.items():
                if "." in key:
                    result[key] = rounded(value)
            result["stated_error"] = float(f"{result['stated_error']:.1e}")
        made = made or one | {"results": []}
        made["results"] += one["results"]
    return made


def differences(kept, made, where=""):
    if isinstance(kept, dict) and isinstance(made, dict) and kept.keys() == made.keys():
        return [line for key in kept for line in differences(kept[key], made[key], f"{where}/{key}")]
    if isinstance(kept, list) and isinstance(made, list) and len(kept) == len(made):
        return [line for k, one in enumerate(kept) for line in differences(one, made[k], f"{where}/{k}")]
    if isinstance(kept, float) and isinstance(made, float):
        same = 0.11 if where.endswith("stated_error") else SAME  # stated errors have two digits
        return [] if abs(made - kept) <= same * abs(kept) else [f"{where}: kept {kept}, now {made}"]
    return [] if kept == made else [f"{where}: kept {kept}, now {made}"]


def main(check, ehd, only=None):
    cases = first_cases(ehd)
    makers = {name: lambda one=one: own(ehd, cases, *one) for name, one in OWN.items()}
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        for name, command in templates(folder).items():
            makers[name] = lambda command=command: template(ehd, cases, command, folder)
        for name, make in makers.items():
            if only not in (None, name):
                continue
            file = HERE / f"{name}.json"
            if check:
                wrong += differences(json.loads(file.read_text()), make(), file.name)
            else:
                file.write_text(json.dumps(make(), indent=2) + "\n")
                print(file)
    if wrong:
        sys.exit("\n".join(wrong) + "\nto remake them: make submissions")
    if check:
        print(f"cases/submissions: {', '.join(makers)} as their solvers find now")


if __name__ == "__main__":
    words = sys.argv[1:]
    check = words[:1] == ["--check"]
    words = words[1:] if check else words
    if not (len(words) == 1 or (len(words) == 3 and words[1] == "--only" and not check)):
        sys.exit(__doc__)
    main(check, words[0], *words[2:])
