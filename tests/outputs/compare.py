# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd compare --json`: its runs against `ehd solve`, its errors against the digits of the case. And the
one number of `ehd plan --json`."""

import functools

from judge import ROUND_OFF, Objections
from program import TOP, read_case

CASE = "own-moes-20-10"
SOLVERS, TOLERANCES = ("reference", "fast"), (1e-2, 1e-4)
TIMES = ("wall_s", "planning_s", "total_s", "stage_s")
OF_COMPARE = ("tolerance", "achieved_error", "within_tolerance")


def audit_run(said, name, run, single, tolerance, digits):
    """`single`: of `ehd solve` with the same solver and tolerance. The same run, so the same bits."""
    said.same(name, run, single, apart=(*TIMES, *OF_COMPARE))
    for time in (run["cost"]["wall_s"], run["cost"]["planning_s"], *run["cost"].get("stage_s", {}).values()):
        said.within(f"{name}: a time", time, 0)
    said.near(f"{name}: total_s", run["cost"]["total_s"], run["cost"]["wall_s"] + run["cost"]["planning_s"],
              relative=ROUND_OFF)
    said.equal(f"{name}: tolerance", run["tolerance"], tolerance)
    for film in ("minimum", "central"):
        expected = abs(run["film"][film]["hertz"] / digits[film] - 1)
        said.near(f"{name}: achieved_error of film.{film}", run["achieved_error"][f"film.{film}"], expected,
                  absolute=ROUND_OFF)
        said.equal(f"{name}: within_tolerance of film.{film}", run["within_tolerance"].get(f"film.{film}"),
                   expected <= tolerance)


def audit_compare(result, case, singles):
    said = Objections()
    said.equal("version", result["version"], case["version"])
    digits = {one["quantity"].removeprefix("film."): float(one["value"]) for one in case["expect"]}
    said.equal("runs", len(result["runs"]), len(singles))
    for run, ((solver, tolerance), single) in zip(result["runs"], singles.items(), strict=True):
        audit_run(said, f"{solver} at {tolerance}", run, single, tolerance, digits)
    return said


def audit_plan(result, case):
    said = Objections()
    said.equal("version", result["version"], case["version"])
    return said


def documents(program):
    path = TOP / "cases" / f"{CASE}.toml"
    case = read_case(path)
    singles = {(solver, tolerance): program.json("solve", path, "--solver", solver, "--tolerance", tolerance)
               for solver in SOLVERS for tolerance in TOLERANCES}
    compared = program.json("compare", path, *(word for name in SOLVERS for word in ("--solver", name)),
                            *(word for tolerance in TOLERANCES for word in ("--tolerance", tolerance)))
    for result in compared:
        yield f"compare {CASE}", "compare", result, functools.partial(audit_compare, result, case, singles)
    bearing = TOP / "tests" / "outputs" / "inputs" / "roller-bearing.toml"
    for path in (path, bearing):
        plan = program.json("plan", path)
        yield f"plan {path.stem}", "plan", plan, functools.partial(audit_plan, plan, read_case(path))
