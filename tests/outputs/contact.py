# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd solve --json`, derived from the case, the profile and the other solver."""

import dataclasses
import functools
import math

import textbook
from judge import ROUND_OFF, Objections
from program import TOP, read_case, read_csv, side_by_side

# Case, options, and how the run may end. A solver is held against the other one: `reference` against `fast`.
RUNS = [
    ("steel-roller", ["--tolerance", "1e-3"], 0),
    ("steel-roller", ["--tolerance", "1e-5"], 0),
    ("own-moes-20-10", ["--solver", "reference", "--tolerance", "1e-4"], 0),
    ("own-moes-20-10", ["--solver", "fast.uniform", "--nodes", "512"], 0),
    ("kostreva-100lb-2500rpm", ["--tolerance", "1e-4"], 0),
    ("own-isoviscous-10-0", ["--tolerance", "1e-4"], 0),
    ("own-steel-20-10", ["--solver", "reference.linear", "--tolerance", "1e-2"], 0),
    ("dry-steel", [], 0),
]

FILMS = ("minimum", "central", "couette")
EXTRAPOLATING = ("fast", "reference.linear")
PEAKS = ("maximum", "spike")


@dataclasses.dataclass
class Inputs:
    """What an audit of one solve knows beside its result."""
    case: dict          # the TOML file
    tolerance: float    # of the films, as asked for or as stated
    truth: dict | None  # the other solver's result at a tolerance of 1e-7; none for a dry contact
    profile: list       # rows of the CSV of the same run; empty where there is none
    dense: bool = False  # the solver has neither transforms nor Krylov iterations
    field_error: float | None = None    # what the result states of its fields
    pressure_error: float | None = None
    pressure_resolved: bool = True
    spike_reported: bool = False
    offset: float | None = None         # H_0 from the profile
    rolling_force: float | None = None  # from the profile


def scales_of(case):
    """Groups and scales that the case fixes, by their names in the JSON; and the unit of film thickness [m]."""
    lubricant = case.get("lubricant", {})
    if SI := case.get("conditions"):
        w, R, E = (SI[key] for key in ("load_N_per_m", "reduced_radius_m", "reduced_modulus_Pa"))
        b, p_H = textbook.half_width(w, R, E), textbook.hertz_pressure(w, R, E)
        known = {"hertz_pressure_Pa": p_H, "half_width_m": b}
        if lubricant:
            speed, viscosity, alpha = SI["speed_sum_m_per_s"], SI["viscosity_Pa_s"], lubricant["alpha_per_Pa"]
            known["M"], known["L"] = textbook.moes_groups(w, R, E, speed, viscosity, alpha)
            known["lambda"] = 6 * viscosity * speed * R**2 / (b**3 * p_H)
            known["alpha_p_H"] = alpha * p_H
            known |= {"W": w / (E * R), "U_mean": viscosity * speed / 2 / (E * R), "G": alpha * E}
        return known, b * b / R
    if moes := case.get("moes"):
        known = {"M": moes["M"], "L": moes["L"], "lambda": textbook.lambda_of(moes["M"]),
                 "alpha_p_H": textbook.alpha_p_hertz(moes["M"], moes["L"])}
    else:
        stated = case["hertz"]
        M = math.sqrt(3 * math.pi**2 / (8 * stated["lambda"]))
        known = {"M": M, "L": stated["alpha_p_H"] / math.sqrt(M / (2 * math.pi)),
                 "lambda": stated["lambda"], "alpha_p_H": stated["alpha_p_H"]}
    if "alpha_per_Pa" in lubricant:
        known["hertz_pressure_Pa"] = known["alpha_p_H"] / lubricant["alpha_per_Pa"]
    return known, None


def quadrature_error(profile):
    """Of a deflection whose pressure is linear between nodes: order 3/2 in the cells at the edge of the contact."""
    X = [row["X"] for row in profile]
    return max(b - a for a, b in zip(X, X[1:], strict=False) if abs(a) < 1.2) ** 1.5


def cell_around(profile, x):
    """The largest cell among those about x."""
    X = [row["X"] for row in profile]
    at = min(range(len(X)), key=lambda k: abs(X[k] - x))
    return max(abs(X[k + 1] - X[k]) for k in range(max(0, at - 1), min(len(X) - 1, at + 1)))


def audit_place(said, name, entry, groups):
    """A place in metres is X times b, where b is known."""
    said.equal(f"{name} in metres", "x_m" in entry, "half_width_m" in groups)
    if "x_m" in entry:
        said.near(f"{name}.x_m", entry["x_m"], entry["x"] * groups["half_width_m"], relative=ROUND_OFF)


def audit_films(said, result, inputs):
    groups, unit_m = scales_of(inputs.case)
    for name in ("minimum", "central"):
        audit_place(said, f"film.{name}", result["film"][name], groups)
    films = result["film"]
    for name in FILMS:
        film, true = films[name], inputs.truth["film"][name]
        said.near(f"film.{name}.hertz", film["hertz"], true["hertz"], relative=film["error"] + true["error"])
        said.near(f"film.{name}.moes", film["moes"], film["hertz"] * 8 * groups["M"] / math.pi, relative=ROUND_OFF)
        said.equal(f"film.{name} in metres", "m" in film, unit_m is not None)
        if "m" in film:
            said.near(f"film.{name}.m", film["m"], film["hertz"] * unit_m, relative=ROUND_OFF)
        audit_error(said, f"film.{name}", film)
    # H is parabolic at its minimum, so the place is known to the cell only.
    place = inputs.truth["film"]["minimum"]["x"]
    said.near("film.minimum.x", films["minimum"]["x"], place, absolute=cell_around(inputs.profile, place))
    said.equal("film.central.x", films["central"]["x"], 0)
    if result["status"] == "converged":
        for name in ("minimum", "central"):
            said.within(f"film.{name}.error", films[name]["error"], 0, inputs.tolerance)


SUM_OF_THREE = 1e-15  # a source may be as small as round-off


def audit_error(said, name, entry):
    """A stated error is not negative, and is the sum of its sources."""
    said.within(f"{name}.error", entry["error"], 0)
    if sources := entry.get("errors"):
        for source, value in sources.items():
            said.within(f"{name}.errors.{source}", value, 0)
        said.near(f"{name}.error", entry["error"], sum(sources.values()), relative=SUM_OF_THREE)


def audit_fields(said, result, inputs):
    """The films of the fields are as far from the reported ones as extrapolation moves these, and those are off by
    their stated errors."""
    films, stated = result["film"], result["fields"]["film_error"]
    errors = [films[name]["error"] for name in ("minimum", "central")]
    if result["solver"] in EXTRAPOLATING:
        seen = [lowest(inputs.profile), value_at(inputs.profile, "H", 0)[0]]
        off = max(abs(film / films[name]["hertz"] - 1) + films[name]["error"]
                  for film, name in zip(seen, ("minimum", "central"), strict=True))
        said.near("fields.film_error", stated, off, relative=0.25)  # the film at a place between nodes
    else:
        said.near("fields.film_error", stated, max(errors), absolute=ROUND_OFF)


def audit_pressure_field(said, result, inputs):
    """P is off by at most the stated error, in L2. `reference` has polynomials between nodes: its nodes count alone."""
    seen, true = inputs.profile, inputs.truth["profile"]
    nodes = seen if result["solver"] == "reference" else true
    begin, end = max(seen[0]["X"], true[0]["X"]), min(seen[-1]["X"], true[-1]["X"])
    places = [row["X"] for row in nodes if begin <= row["X"] <= end]
    P, exact = ([value_at(rows, "P", x)[0] for x in places] for rows in (seen, true))
    off = [(a - b) ** 2 for a, b in zip(P, exact, strict=True)]
    distance = math.sqrt(textbook.trapezoid(places, off) / textbook.trapezoid(places, [p * p for p in exact]))
    said.within("fields.pressure_error", result["fields"]["pressure_error"], distance)


def audit_offset(said, result, inputs):
    unit_m = scales_of(inputs.case)[1]
    offset, approach = result["film"]["offset"], result["approach"]
    if inputs.truth:
        true = inputs.truth["film"]["offset"]
        said.near("film.offset.hertz", offset["hertz"], true["hertz"], absolute=offset["error"] + true["error"])
        said.near("film.offset.hertz", offset["hertz"], inputs.offset,
                  absolute=10 * inputs.tolerance + quadrature_error(inputs.profile))
    else:
        said.near("film.offset.hertz", offset["hertz"], textbook.DRY_OFFSET, relative=ROUND_OFF)
        said.equal("film.offset.error", offset["error"], 0)
    audit_error(said, "film.offset", offset)
    said.equal("approach.hertz", approach["hertz"], -offset["hertz"])
    said.near("approach.error", approach["error"], offset["error"], relative=ROUND_OFF)
    said.equal("approach in metres", "m" in approach, unit_m is not None)
    if "m" in approach:
        said.near("approach.m", approach["m"], approach["hertz"] * unit_m, relative=ROUND_OFF)


def audit_pressure(said, result, inputs):
    pressure, groups = result["pressure"], result["groups"]
    for name in PEAKS:
        if name not in pressure:
            continue
        peak = pressure[name]
        if inputs.truth:
            true = inputs.truth["pressure"][name]
            said.near(f"pressure.{name}.hertz", peak["hertz"], true["hertz"], relative=peak["error"] + true["error"])
            # Known to the cell; on a parabola of curvature 1 to the square root of the error.
            said.near(f"pressure.{name}.x", peak["x"], true["x"],
                      absolute=min(cell_around(inputs.profile, true["x"]), math.sqrt(2 * peak["error"])))
        else:
            said.equal(f"pressure.{name}", peak | {"Pa": 0}, {"hertz": 1, "Pa": 0, "x": 0, "x_m": 0, "error": 0})
        audit_place(said, f"pressure.{name}", peak, groups)
        audit_error(said, f"pressure.{name}", peak)
        if "Pa" in peak:
            said.near(f"pressure.{name}.Pa", peak["Pa"], peak["hertz"] * groups["hertz_pressure_Pa"],
                      relative=ROUND_OFF)
    said.equal("pressure.exit_x in metres", "exit_x_m" in pressure, "half_width_m" in groups)
    if "exit_x_m" in pressure:
        said.near("pressure.exit_x_m", pressure["exit_x_m"], pressure["exit_x"] * groups["half_width_m"],
                  relative=ROUND_OFF)
    if inputs.truth:
        true = inputs.truth["pressure"]
        said.near("pressure.exit_x", pressure["exit_x"], true["exit_x"],
                  relative=pressure["exit_x_error"] + true["exit_x_error"])
        said.within("pressure.exit_x_error", pressure["exit_x_error"], 0)
    else:
        said.equal("pressure.exit_x", (pressure["exit_x"], pressure["exit_x_error"]), (1, 0))


def audit_cost(said, cost, inputs):
    for name, value in cost.items():
        for one in value.values() if isinstance(value, dict) else [value]:
            said.within(f"cost.{name}", one, 0)
    said.near("cost.total_s", cost["total_s"], cost["wall_s"] + cost["planning_s"], relative=ROUND_OFF)
    if inputs.truth is None:
        said.equal("cost of a dry contact", set(cost.values()), {0})
        return
    if inputs.profile:
        said.equal("cost.nodes", cost["nodes"], len(inputs.profile) - 1)
    if inputs.dense:
        for name in ("planning_s", "krylov_iterations", "fft_plans"):
            said.equal(f"cost.{name}", cost[name], 0)
    if inputs.case["lubricant"]["density"] != "incompressible":  # both laws are evaluated at the same points
        said.equal("cost.density_points", cost["density_points"], cost["viscosity_points"])
    else:
        said.equal("cost.density_points", cost["density_points"], 0)
    # A work unit is a product on the finest grid. No product weighs more.
    said.within("cost.work_units", cost["work_units"], 1, cost["convolutions"])


def audit_contact(result, inputs):
    said = Objections()
    said.equal("version", result["version"], inputs.case["version"])
    groups = scales_of(inputs.case)[0]
    said.equal("groups", sorted(result["groups"]), sorted(groups))
    for name, expected in groups.items():
        said.near(f"groups.{name}", result["groups"][name], expected, relative=ROUND_OFF)
    if inputs.truth:
        audit_films(said, result, inputs)
        if inputs.profile:
            audit_fields(said, result, inputs)
            audit_pressure_field(said, result, inputs)
        force, true = result["rolling_force"], inputs.truth["rolling_force"]
        said.near("rolling_force", force["dimensionless"], true["dimensionless"],
                  relative=force["error"] + true["error"])
        said.within("rolling_force.error", force["error"], 0)
        groups, unit_m = scales_of(inputs.case)
        said.equal("rolling_force in SI", "N_per_m" in force, unit_m is not None)
        if "N_per_m" in force:
            said.near("rolling_force.N_per_m", force["N_per_m"],
                      force["dimensionless"] * groups["hertz_pressure_Pa"] * unit_m, relative=ROUND_OFF)
        said.near("rolling_force", force["dimensionless"], inputs.rolling_force,
                  relative=10 * inputs.tolerance + 1e-2)
        for name in ("load_error", "flux_variation"):
            said.within(name, result[name], 0, inputs.tolerance)
    audit_offset(said, result, inputs)
    audit_pressure(said, result, inputs)
    audit_cost(said, result["cost"], inputs)
    return said


def inlet_moment(profile):
    """-Int H dP before the first node: there P falls with |X|^-3 and H grows with X^2, so that it is 3 P H."""
    return 3 * profile[0]["P"] * profile[0]["H"]


def from_profile(profile, flooded):
    """H_0 and the rolling force, from nodes alone."""
    X, P, H = ([row[name] for row in profile] for name in ("X", "P", "H"))
    middle = min(range(len(X)), key=lambda k: abs(X[k]))
    offset = H[middle] - X[middle] ** 2 / 2 - textbook.deflection(X, P, X[middle])
    if flooded:  # the load P |X|/2 before the first node stands about 2 |X| away
        offset += P[0] * abs(X[0]) / 2 / math.pi * math.log(2 * abs(X[0]))
    moment = textbook.trapezoid(P, H) + (inlet_moment(profile) if flooded else 0)
    return offset, abs(moment) / 2


def value_at(profile, name, x):
    """A column of a profile at X, linear between its nodes, and the length of the cell."""
    for a, b in zip(profile, profile[1:], strict=False):
        if a["X"] <= x <= b["X"]:
            cell = b["X"] - a["X"]
            return a[name] + (b[name] - a[name]) * (x - a["X"]) / cell, cell
    raise ValueError(f"X = {x} lies outside the profile")


def lowest(profile):
    """The smallest film between nodes: of the parabola through the lowest node and its neighbours."""
    at = min(range(len(profile)), key=lambda k: profile[k]["H"])
    (x0, y0), (x1, y1), (x2, y2) = ((row["X"], row["H"]) for row in profile[at - 1:at + 2])
    left, right = (y1 - y0) / (x1 - x0), (y2 - y1) / (x2 - x1)
    bend = (right - left) / (x2 - x0)
    slope = left + bend * (x1 - x0)
    return y1 - slope * slope / (4 * bend)


def audit_row(k, inputs):
    """Row k of a profile, neither the first nor the last: the other solver's film, the laws and the units."""
    said = Objections()
    before, row, after = inputs.profile[k - 1:k + 2]
    said.within("X", row["X"], before["X"], after["X"])
    said.within("P", row["P"], -ROUND_OFF)
    if said:
        return said
    true = inputs.truth["profile"]
    if true[0]["X"] <= before["X"] and after["X"] <= true[-1]["X"]:
        film, cell = value_at(true, "H", row["X"])  # H'' is about 1, more at the spike
        said.near("H", row["H"], film, relative=10 * inputs.tolerance, absolute=cell**2)
        around = [value_at(true, "P", one["X"])[0] for one in (before, row, after)]
        # Steep where the oil stiffens.
        said.within("P", row["P"], 0.8 * min(around) - ROUND_OFF, 1.2 * max(around) + ROUND_OFF)
    if "H_error" in row:
        said.near("H_error", row["H_error"], inputs.field_error, relative=ROUND_OFF)
    else:  # not known beside a spike, the last maximum of the pressure, whose height is not reported
        said.equal("spike", inputs.spike_reported, False)
        nodes = inputs.profile
        tops = [at["X"] for left, at, right in zip(nodes, nodes[1:], nodes[2:]) if left["P"] < at["P"] > right["P"]]
        spike = tops[-1]
        said.near("X without an error", row["X"], spike, absolute=0.04)
    said.equal("P_unresolved", row.get("P_unresolved"), None if inputs.pressure_resolved else 0)
    if "H_error" in row and inputs.pressure_error is not None:
        said.near("P_error", row["P_error"], inputs.pressure_error, relative=ROUND_OFF)
    else:
        said.equal("P_error", "P_error" in row, False)
    groups, unit_m = scales_of(inputs.case)
    p_H, lubricant = groups.get("hertz_pressure_Pa"), inputs.case["lubricant"]
    if p_H:
        p, alpha = row["P"] * p_H, lubricant["alpha_per_Pa"]
        p0 = lubricant.get("p0_Pa", 1.9613e8)
        z = lubricant.get("z") or alpha * p0 / (math.log(inputs.case["conditions"]["viscosity_Pa_s"]) + 9.67)
        said.near("eta", row["eta"], math.exp(textbook.ln_roelands(p, alpha, z, p0)), relative=1e-11)
        said.near("rho", row["rho"], textbook.dowson_higginson(p), relative=ROUND_OFF)
    else:
        said.near("eta", row["eta"], math.exp(groups["alpha_p_H"] * row["P"]), relative=1e-11)
        said.equal("rho", row["rho"], 1)
    if unit_m:
        said.near("x_m", row["x_m"], row["X"] * groups["half_width_m"], relative=ROUND_OFF)
        said.near("p_Pa", row["p_Pa"], row["P"] * p_H, relative=ROUND_OFF)
        said.near("h_m", row["h_m"], row["H"] * unit_m, relative=ROUND_OFF)
    return said


def solve(program, case, options, ends=0, truth=None):
    """The result of one solve and what its audit knows. `case`: an id or a path. `truth`: of an earlier solve."""
    path = TOP / "cases" / f"{case}.toml" if isinstance(case, str) else case
    profile_csv = program.folder / f"{path.stem}-{'-'.join(options).replace('/', '')}.csv"
    result = program.json("solve", path, *options, "--profile", profile_csv, allowed=(ends,))
    inputs = Inputs(read_case(path), 1e-3, truth, [])
    if "lubricant" not in inputs.case:
        return result, inputs
    if not truth:
        other = "fast" if result["solver"] == "reference" else "reference"
        true_csv = profile_csv.with_suffix(".true.csv")
        inputs.truth = program.json("solve", path, "--solver", other, "--tolerance",
                                    "1e-7" if other == "reference" else "1e-6", "--profile", true_csv)
        inputs.truth["profile"] = read_csv(true_csv)
    films = result["film"]
    stated = max(films["minimum"]["error"], films["central"]["error"])
    inputs.tolerance = float(options[options.index("--tolerance") + 1]) if "--tolerance" in options else stated
    inputs.dense = result["solver"].startswith("reference")
    inputs.profile = read_csv(profile_csv)
    inputs.field_error = result["fields"]["film_error"]
    inputs.pressure_error = result["fields"].get("pressure_error")
    inputs.pressure_resolved = result["fields"]["pressure_resolved"]
    inputs.spike_reported = "spike" in result["pressure"]
    flooded = inputs.case["domain"]["inlet"] == "flooded"
    inputs.offset, inputs.rolling_force = from_profile(inputs.profile, flooded)
    return result, inputs


def documents(program):
    """(name, kind, document, audit) of every run; of each profile every 32nd row. Not a row next to X = 0: doubled, its
    X still stands between its neighbours."""
    runs = side_by_side([lambda run=run: solve(program, *run) for run in RUNS])
    for (case, options, _), (result, inputs) in zip(RUNS, runs, strict=True):
        name = f"solve {case} {' '.join(options)}".strip()
        yield name, "contact", result, functools.partial(audit_contact, result, inputs)
        for k in range(16, len(inputs.profile) - 1, 32):
            X, following = inputs.profile[k]["X"], inputs.profile[k + 1]["X"]
            if abs(X) < following - X:
                continue
            yield f"{name}, row {k} of the profile", "profile", inputs.profile[k], \
                functools.partial(audit_row, k, inputs)
