# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd bench` (work-precision and scaling) and of `ehd stress` (part d), small forms."""

import functools
import math
import re
import statistics

from judge import ROUND_OFF, Objections
from program import TOP, read_case
from verify import EPSILON, last_digit

CASE, SOLVER = "own-moes-20-10", "fast"
FILMS = ("film.minimum", "film.central")
ASKED = [("tolerance", 1e-2), ("tolerance", 1e-3), ("tolerance", 1e-4),
         ("nodes", 256), ("nodes", 1024), ("nodes", 4096)]
COUNTS = ("work_units", "nodes", "levels", "convolutions", "newton_iterations", "krylov_iterations")
SCALING_PROBLEM = {"M": 5, "L": 5}
# On a grid that is asked for, bench stops the iteration earlier than ehd solve: the film moves by this share of its
# error, and the counts are others.
STOPPED_EARLIER = 0.1
# Below this, the iteration that stops earlier decides about the error.
NEAR_ROUND_OFF = 1e-11


def film_of(result, name):
    return result["film"][name.removeprefix("film.")]


def audit_truth(said, truth, case, single):
    """The reference at its tightest against `ehd solve`, and against the digits of the case."""
    digits = {one["quantity"]: one["value"] for one in case["expect"]}
    said.equal("truth: tolerance", truth["tolerance"], 1e-8)
    said.within("truth: wall_s", truth["wall_s"], 0)
    said.within("truth: pressure", truth["pressure"]["error"], 0)
    for name in FILMS:
        film = truth[name]
        said.near(f"truth: {name}", film["value"], film_of(single, name)["hertz"], relative=2 * film["error"])
        said.within(f"truth: {name}: error", film["error"], 0, 1e-8)
        said.near(f"truth: {name}: from_digits", film["from_digits"], abs(film["value"] / float(digits[name]) - 1),
                  absolute=4 * EPSILON)
        said.near(f"truth: {name}: digits_uncertainty", film["digits_uncertainty"],
                  last_digit(digits[name]) / 2 / float(digits[name]), relative=1e-9)


def audit_work_row(said, name, row, truth, single):
    """`single`: `ehd solve` with the same solver and tolerance."""
    cost, on_grid = row["cost"], "nodes" in row
    for count in COUNTS:
        if on_grid and count not in ("nodes", "levels"):
            said.within(f"{name}: {count}", cost[count], 1, single["cost"][count])
        else:
            said.equal(f"{name}: {count}", cost[count], single["cost"][count])
    said.within(f"{name}: solves", cost["solves"], 1)
    said.within(f"{name}: wall_s", cost["wall_s"], cost["fastest_s"], cost["slowest_s"])
    for time in (cost["fastest_s"], cost["planning_s"], *cost["stage_s"].values()):
        said.within(f"{name}: a time", time, 0)
    said.near(f"{name}: total_s", cost["total_s"], cost["wall_s"] + cost["planning_s"], relative=ROUND_OFF)
    for quantity in FILMS:
        film, alone = row[quantity], film_of(single, quantity)
        said.within(f"{name}: {quantity}: reported", film["reported"], alone["error"],
                    math.inf if on_grid else alone["error"])
        achieved = abs(alone["hertz"] / truth[quantity]["value"] - 1)
        said.near(f"{name}: {quantity}: achieved", film["achieved"], achieved,
                  absolute=NEAR_ROUND_OFF if on_grid and achieved < NEAR_ROUND_OFF else 4 * EPSILON,
                  relative=STOPPED_EARLIER if on_grid else 0)
        said.equal(f"{name}: {quantity}: truth_error", film["truth_error"], truth[quantity]["error"])
        said.equal(f"{name}: {quantity}: covered", film["covered"], film["achieved"] <= film["reported"])
    said.equal(f"{name}: pressure", row["pressure"]["truth_error"], truth["pressure"]["error"])
    said.within(f"{name}: pressure", row["pressure"]["achieved"], 0)


def audit_equal_error(said, entries, rows):
    """The quickest row of those that are good enough."""
    before = None
    for entry in entries:
        again = before and before["quantity"] == entry["quantity"]
        said.near("level", entry["level"], before["level"] / 10 if again else 1e-2, relative=ROUND_OFF)
        before = entry
        good = [row for row in rows if row[entry["quantity"]]["achieved"] <= entry["level"]]
        expected = [{key: row[key] for key in ("solver", "tolerance", "nodes") if key in row}
                    | {"wall_s": row["cost"]["wall_s"]} for row in good]
        said.equal("quickest", entry["quickest"], sorted(expected, key=lambda row: row["wall_s"])[:1])


def audit_coverage(said, entries, rows):
    for entry in entries:
        films = [row[entry["quantity"]] for row in rows]
        excess = [film["reported"] / film["achieved"] for film in films]
        said.equal("covered", entry["covered"], sum(film["covered"] for film in films))
        said.equal("missed", entry["missed"], sum(not film["covered"] for film in films))
        said.equal("undecided", entry["undecided"], 0)
        said.near("median_excess", entry["median_excess"], statistics.median(excess), relative=ROUND_OFF)
        said.near("smallest_excess", entry["smallest_excess"], min(excess), relative=ROUND_OFF)


def audit_scaling(said, row):
    n, name = row["nodes"], f"scaling, {row['solver']} {row['nodes_asked']}"
    said.equal(f"{name}: nodes", n, row["nodes_asked"])
    for key, value in SCALING_PROBLEM.items():
        said.equal(f"{name}: {key}", row[key], value)
    for key in ("convolution_s", "peak_bytes", "newton_iterations", "solves"):
        said.within(f"{name}: {key}", row[key], 1e-12)
    for time in row["stage_s"].values():
        said.within(f"{name}: a time", time, 0)
    said.near(f"{name}: time_per_unit", row["time_per_unit"],
              row["wall_s"] / row["work_units"] / row["convolution_s"], relative=ROUND_OFF)
    said.near(f"{name}: ns_per_n_log2_n", row["ns_per_n_log2_n"], 1e9 * row["wall_s"] / (n * math.log2(n)),
              relative=ROUND_OFF)


def audit_bench(result, case, truth, singles):
    said = Objections()
    said.equal("schema", result["schema"], "ehd-bench-1")
    said.equal("looks", sorted(result["looks"].values()), list(range(1, len(result["looks"]) + 1)))
    said.equal("time_limit_s", result["settings"]["time_limit_s"], 30)
    said.within("cores", result["provenance"]["cores"], 1)
    work = result["work_precision"]
    said.within("cpu_share", work["cpu_share"], 0)
    said.within("c_s", work["c_s"], 0, 1e-3)  # one transform of 1024 numbers and back
    audit_truth(said, work["truths"][0], case, truth)
    said.equal("rows", len(work["rows"]), len(singles))
    for row, (asked, value), single in zip(work["rows"], ASKED, singles, strict=True):
        said.equal(asked, row[asked], value)
        audit_work_row(said, f"{SOLVER}, {asked} {value}", row, work["truths"][0], single)
    audit_equal_error(said, work["at_equal_error"], work["rows"])
    audit_coverage(said, work["coverage"], work["rows"])
    for row in result["scaling"]:
        audit_scaling(said, row)
    return said


def audit_stress(result):
    """Part d: no film moves by more than its bound."""
    said = Objections()
    said.equal("schema", result["schema"], "ehd-stress-1")
    said.within("cores", result["provenance"]["cores"], 1)
    part = result["parts"][0]
    said.equal("settings", part["settings"],
               {"intervals": 256, "tolerance": 1e-5, "inlet": -4.0, "quick": True})
    said.within("wall_s", result["wall_s"], part["wall_s"], part["wall_s"] + 1)
    said.within("wall_s", part["wall_s"], 0)
    numbers = re.fullmatch(r"([\d.e+-]+) operations, condition ([\d.e+-]+); stopped at residual ([\d.e+-]+), "
                           r"amplification ([\d.e+-]+)", part["tolerance"]["reason"])
    operations, condition, residual, amplification = (float(text) for text in numbers.groups())
    said.near("tolerance", part["tolerance"]["value"], operations * condition * EPSILON + residual * amplification,
              relative=1e-2)
    names = [column["name"] for column in part["columns"]]
    rows = [dict(zip(names, row, strict=True)) for row in part["rows"]]
    fixed = [row for row in rows if row["by"] == "operations x condition"]
    moves = ("H_min moves", "H_cen moves")
    for row in rows:
        for key in moves:
            said.within(f"{row['solver']}, {row['mode']}: {key}", row[key], 0, row["bound"])
    said.equal("converged", f"{sum(row['status'] == 'converged' for row in rows)} of {len(rows)}",
               part["summary"].split(" solves")[0])
    largest = float(re.search(r"move by at most ([\d.e-]+),", part["summary"])[1])
    said.near("largest move on a fixed grid", max(row[key] for row in fixed for key in moves), largest, relative=5e-2)
    share = float(re.search(r"by at most ([\d.e-]+) of its bound", part["summary"])[1])
    said.near("largest share", max(row[key] / row["bound"] for row in rows for key in moves), share, relative=5e-2)
    return said


def documents(program):
    path = TOP / "cases" / f"{CASE}.toml"
    program.run("bench", "--quick", "--part", "work-precision", "--part", "scaling", "--case", CASE, "--solver", SOLVER,
                "--output", program.folder)
    result = program.read_json(program.folder / "bench.json")
    truth = program.json("solve", path, "--solver", "reference", "--tolerance", "1e-8")
    singles = [program.json("solve", path, "--solver", SOLVER, f"--{asked}", value) for asked, value in ASKED]
    yield "bench", "bench", result, functools.partial(audit_bench, result, read_case(path), truth, singles)
    program.run("stress", "--quick", "--part", "d", "--output", program.folder)
    result = program.read_json(program.folder / "stress.json")
    yield "stress, part d", "stress", result, functools.partial(audit_stress, result)
