#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solvers of examples/solvers, run by `ehd compare --external` and judged by `ehd judge`: their digits, and the
errors that they state.

  templates.py EHD        exit code 0: all hold; 1: one does not; 77: neither NumPy, gfortran nor Octave is there

With EHD_REQUIRE_OCTAVE=1 a missing Octave is a failure (make octave).
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOLVERS = pathlib.Path(__file__).resolve().parents[2] / "examples" / "solvers"
CASES = ("own-isoviscous-10-0", "own-moes-5-5")
FLOODED = "own-moes-20-10-flooded"  # Fortran and Octave want a cut inlet, and say so
LIGHT = "kostreva-100lb-5000rpm"  # no answer: docs/judge.md says so
TOLERANCE = 1e-2  # 256 nodes; a second in Python
SKIPPED = 77
os.environ["OMP_NUM_THREADS"] = "1"


def python_with_numpy():
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import numpy"], capture_output=True).returncode == 0:
            return python
    return None


def commands(folder):
    found = {}
    if python := python_with_numpy():
        found["python"] = f"{python} {SOLVERS / 'line_contact.py'}"
    if shutil.which("gfortran"):
        program = pathlib.Path(folder, "line_contact")
        subprocess.run(["gfortran", "-O2", "-o", program, SOLVERS / "line_contact.f90"], check=True, cwd=folder)
        found["fortran"] = str(program)
    if shutil.which("octave-cli"):
        found["octave"] = f"octave-cli --norc {SOLVERS / 'line_contact.m'}"
    return found


def output(*command):
    process = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if process.returncode not in (0, 1):
        sys.exit(f"{command}: exit code {process.returncode}\n{process.stderr}")
    return json.loads(process.stdout)


def require(holds, what):
    if not holds:
        sys.exit(f"templates: {what}")


def compare(ehd, name, command):
    """Every case at a tolerance that it meets, and one that it does not."""
    call = f"{name}={command} {{case}} {{out}} {{tolerance}}"
    for compared in output(ehd, "compare", *CASES, "--solver", "fast", "--tolerance", TOLERANCE, "--external", call,
                           "--json", "-"):
        mine = compared["runs"][-1]
        require(mine["solver"] == name and mine["status"] == "converged", f"{compared['case']}: {name}: {mine}")
        for film in ("minimum", "central"):
            achieved, stated = mine["achieved_error"][f"film.{film}"], mine["film"][film]["error"]
            require(achieved <= stated <= TOLERANCE,
                    f"{compared['case']}: {name}: film.{film}: achieved {achieved}, stated {stated}")
    mine = output(ehd, "compare", CASES[0], "--solver", "fast", "--tolerance", 1e-9, "--external", call,
                  "--json", "-")[0]["runs"][-1]
    require(mine["status"] == "tolerance-not-met", f"{name} at 1e-9: {mine['status']}")
    if name == "python":  # it takes a flooded inlet
        return
    ended = subprocess.run([ehd, "compare", FLOODED, "--solver", "fast", "--tolerance", "1e-2", "--external", call],
                           capture_output=True, text=True)
    require("the inlet is not cut" in ended.stderr, f"{name} says of a flooded inlet: {ended.stderr}")


def judge(ehd, folder, name, command):
    """The submission as it is, with its profile where it writes one."""
    problem, out = pathlib.Path(folder, "case.json"), pathlib.Path(folder, f"{name}.json")
    case = CASES[-1]
    problem.write_text(json.dumps(output(ehd, "cases", case, "--json")["cases"][0]["problem"], indent=2))
    subprocess.run([*command.split(), problem, out, str(TOLERANCE)], check=True)
    judgement = output(ehd, "judge", out, "--json", "-")
    mine = next(one for one in judgement["cases"] if one["case"] == case)
    digits = {score["quantity"]: score["digits"] for score in mine["scores"] if not score["missing"]}
    require(min(digits["film.minimum"], digits["film.central"]) > 2, f"{name}: digits {digits}")
    require(judgement["honesty"]["missed"] == 0 and judgement["honesty"]["met"] == 2, f"{name}: {judgement['honesty']}")
    require(judgement["gates_hold"], f"{name}: {mine.get('profile')}")
    require(name != "python" or all(gate["verdict"] == "pass" for gate in mine["profile"]["gates"]),
            f"{name}: {mine.get('profile')}")


def refuse(ehd, folder, name, command):
    """A law that the solver does not have is no isoviscous oil, and a tolerance that is no number is not met. A case
    that is not there, and one that is too light for the solver, give one line."""
    problem, out = pathlib.Path(folder, "wrong.json"), pathlib.Path(folder, f"wrong-{name}.json")
    case = output(ehd, "cases", CASES[-1], "--json")["cases"][0]["problem"]
    for law, tolerance in (("carreau", "1e-2"), (case["viscosity"]["law"], "nan")):
        problem.write_text(json.dumps(case | {"viscosity": case["viscosity"] | {"law": law}}, indent=2))
        ended = subprocess.run([*command.split(), problem, out, tolerance], capture_output=True)
        require(ended.returncode != 0, f"{name}: law {law}, tolerance {tolerance}: exit code 0")
        require(law != "carreau" or ended.returncode == 2 and not out.exists(), f"{name}: law {law}: {ended}")
    light = pathlib.Path(folder, "light.json")
    light.write_text(json.dumps(output(ehd, "cases", LIGHT, "--json")["cases"][0]["problem"], indent=2))
    for file, code, why in ((pathlib.Path(folder, "nowhere.json"), 2, "nowhere.json"), (light, 1, "did not converge")):
        ended = subprocess.run([*command.split(), file, out, "1e-2"], capture_output=True, text=True)
        lines = [line for line in ended.stderr.splitlines() if not line.startswith("error: ignoring")]  # Octave 7's own
        require(ended.returncode == code and len(lines) == 1 and why in lines[0], f"{name}: {ended}")


def main(ehd):
    with tempfile.TemporaryDirectory() as folder:
        found = commands(folder)
        require("octave" in found or os.environ.get("EHD_REQUIRE_OCTAVE") != "1", "octave-cli is not installed")
        for name, command in found.items():
            compare(ehd, name, command)
            judge(ehd, folder, name, command)
            refuse(ehd, folder, name, command)
        for name, needs in (("python", "NumPy"), ("fortran", "gfortran"), ("octave", "octave-cli")):
            print(f"{name}: {'holds' if name in found else 'not run: there is no ' + needs}")
    return 0 if found else SKIPPED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
