# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd bearing --json` and `--csv`, derived from the case, solves of its contacts, and other runs."""

import bisect
import copy
import dataclasses
import functools
import math

import textbook
from judge import ROUND_OFF, Objections
from program import TOP, read_case, read_csv, side_by_side, to_toml
from textbook_bearing import DRY_LAWS, RACEWAYS, Bearing, straight_line

HERE = TOP / "tests" / "outputs" / "inputs"
LINE, CUT_LINE = "ehd-linear", "cut at delta = 0"  # f = max(0, K delta + dF), and its variant: f = 0 below delta = 0
LAWS = [*DRY_LAWS, LINE, "ehd"]
CAGE_POSITIONS = 4
# Of the load, for a central difference; what that neglects is of the order of its square.
LOAD_STEP = 1e-4
# The contacts of the film laws are solved to 1e-4, and here to 1e-5; an offset film keeps about that.
SOLVED = 2e-4
# A rolling force is known less well, above all between the points of a curve.
TORQUE_KNOWN = 5e-3
# The stiffness of `ehd` too: its error is a bound of what the splines between the points may change in the slope.
STIFFNESS_KNOWN = 0.03
# A balance returned is good to 1e-12 of the load: displacements follow to a few times that.
BALANCED = 1e-11


class Contacts:
    """Solved contacts of one raceway over the force: offset film F = delta_dry - delta, minimum film, rolling force."""

    def __init__(self, program, bearing, raceway, forces):
        self.program, self.bearing, self.raceway = program, bearing, raceway
        self.forces = sorted(forces)
        self.films = side_by_side([functools.partial(self.solve, force) for force in self.forces])

    def conditions(self, force):
        """w, R, E'."""
        return force / self.bearing.length, self.bearing.radius[self.raceway], self.bearing.modulus

    def solve(self, force):
        w, R, E = self.conditions(force)
        lubricant = dict(self.bearing.case["lubricant"])
        name = f"{self.raceway}-{force!r}"
        path = self.program.write(f"{name}.toml", to_toml({
            "id": name, "version": 1, "title": "A contact of the bearing", "source": "own",
            "conditions": {"load_N_per_m": w, "reduced_radius_m": R, "reduced_modulus_Pa": E,
                           "speed_sum_m_per_s": self.bearing.speed_sum,
                           "viscosity_Pa_s": lubricant.pop("viscosity_Pa_s")},
            "lubricant": lubricant, "domain": {"inlet": "flooded"}}))
        result = self.program.json("solve", path, "--tolerance", "1e-5")
        unit = textbook.half_width(w, R, E) ** 2 / R
        return {"offset": unit * (result["film"]["offset"]["hertz"] - textbook.DRY_OFFSET),
                "minimum": result["film"]["minimum"]["m"],
                "rolling": unit * textbook.hertz_pressure(w, R, E) * result["rolling_force"]["dimensionless"]}

    def film(self, which, force):
        """At a solved force that value; between two of them a power law. A wrong force need not be solved."""
        k = bisect.bisect_left(self.forces, force)
        if k < len(self.forces) and self.forces[k] == force:
            return self.films[k][which]
        k = min(max(k, 1), len(self.forces) - 1)
        x0, x1 = math.log(self.forces[k - 1]), math.log(self.forces[k])
        y0, y1 = math.log(self.films[k - 1][which]), math.log(self.films[k][which])
        return math.exp(y0 + (y1 - y0) * (math.log(force) - x0) / (x1 - x0))

    def approach(self, force, datum):
        return textbook.approach(*self.conditions(force), textbook.DRY_OFFSET, datum) - self.film("offset", force)


@dataclasses.dataclass
class Inputs:
    """What an audit of one law's result knows beside it."""
    bearing: Bearing
    form: str
    contacts: dict = dataclasses.field(default_factory=dict)  # Contacts of each raceway; none for a dry law
    lighter: dict | None = None    # this law at a load smaller by LOAD_STEP; plane form only
    heavier: dict | None = None    # and at a larger one
    positions: list | None = None  # this law at each position of the cage
    data: dict = dataclasses.field(default_factory=dict)      # this law with other data, by the words of the budget
    full: dict | None = None       # the law `ehd`, beside ehd-linear


def directions(rollers):
    return [(math.cos(math.radians(one["azimuth_deg"])), math.sin(math.radians(one["azimuth_deg"])))
            for one in rollers]


def audit_contact_row(said, name, row, raceway, law, result, inputs, with_film):
    """Force and approach obey the law; pressure, film and lambda ratio follow."""
    bearing, force = inputs.bearing, row["force_N"]
    said.within(f"{name}.force_N", force, 0)
    said.equal(f"{name} has a film", "film_minimum_m" in row, with_film and force > 0)
    said.equal(f"{name} has a pressure", "hertz_pressure_Pa" in row, force > 0)
    if force > 0:
        p_H = textbook.hertz_pressure(force / bearing.length, bearing.radius[raceway], bearing.modulus)
        said.near(f"{name}.hertz_pressure_Pa", row["hertz_pressure_Pa"], p_H, relative=ROUND_OFF)
        expected, allowed = approach_by_law(law, raceway, force, result, inputs)
        said.near(f"{name}.displacement_m", row["displacement_m"], expected, absolute=allowed)
    else:  # a gap: below the approach at which the law begins
        line = result["fit"][raceway] if law == LINE else None
        begins = -line["dF_N"] / line["K_N_per_m"] if line else 0.0
        said.within(f"{name}.displacement_m", row["displacement_m"], high=begins + 1e-15)
    if "film_minimum_m" in row:
        curve = result["curve"][raceway]
        said.near(f"{name}.film_minimum_m", row["film_minimum_m"], inputs.contacts[raceway].film("minimum", force),
                  relative=SOLVED + curve["interpolation_error"] + curve["joint_error"])
        said.near(f"{name}.lambda_ratio", row["lambda_ratio"], row["film_minimum_m"] / bearing.roughness,
                  relative=ROUND_OFF)


def approach_by_law(law, raceway, force, result, inputs):
    """Approach at a force > 0, and its uncertainty."""
    if law in DRY_LAWS:
        expected = inputs.bearing.dry_approach(law, raceway, force)
        return expected, BALANCED * abs(expected)
    if law in (LINE, CUT_LINE):
        line = result["fit"][raceway]
        expected = (force - line["dF_N"]) / line["K_N_per_m"]
        if law == CUT_LINE:  # at zero approach the line jumps, and any force below dF is possible
            expected = max(0.0, expected)
        return expected, BALANCED * (abs(expected) + line["dF_N"] / line["K_N_per_m"])
    contacts, curve = inputs.contacts[raceway], result["curve"][raceway]
    stated = SOLVED + curve["interpolation_error"] + curve["joint_error"]
    return contacts.approach(force, result["datum"][f"{raceway}_x0_m"]), stated * contacts.film("offset", force)


def audit_balance(said, name, balance, inputs):
    """Rollers and ring: places, compatibility, forces."""
    bearing, rollers = inputs.bearing, balance["rollers"]
    x, y = balance["displacement_m"], balance["displacement_lateral_m"]
    said.equal(f"{name}rollers", len(rollers), bearing.Z)
    for j, (one, psi) in enumerate(zip(rollers, bearing.azimuths(), strict=True)):
        said.near(f"{name}rollers[{j}].azimuth_deg", one["azimuth_deg"], psi, absolute=1e-9)
        inner, outer = one["inner"], one["outer"]
        said.near(f"{name}rollers[{j}]: sum of approaches", inner["displacement_m"] + outer["displacement_m"],
                  bearing.gap(x, y, psi), absolute=BALANCED * (abs(x) + abs(bearing.clearance)))
        said.near(f"{name}rollers[{j}]: f_o - f_i", outer["force_N"] - inner["force_N"], bearing.centrifugal,
                  absolute=ROUND_OFF * bearing.load)
    along = [one["inner"]["force_N"] * c for one, (c, _) in zip(rollers, directions(rollers), strict=True)]
    across = [one["inner"]["force_N"] * s for one, (_, s) in zip(rollers, directions(rollers), strict=True)]
    said.near(f"{name}: Sum f cos psi", math.fsum(along), bearing.load, relative=BALANCED)
    if inputs.form == "plane":
        said.near(f"{name}: Sum f sin psi", math.fsum(across), 0, absolute=BALANCED * bearing.load)
    else:
        said.equal(f"{name}displacement_lateral_m", y, 0)
    said.within(f"{name}balance_error", balance["balance_error"], 0, 1e-12)


def audit_loaded(said, result):
    """The rollers with at least 1 % of the largest force."""
    forces = [one["inner"]["force_N"] for one in result["rollers"]]
    said.equal("loaded_rollers", result["loaded_rollers"], sum(force >= 0.01 * max(forces) for force in forces))


def audit_places(said, result):
    """The contacts of the largest pressure and of the smallest film are among those of the loaded rollers."""
    largest = max(one["inner"]["force_N"] for one in result["rollers"])
    contacts = [{"azimuth_deg": one["azimuth_deg"], "raceway": raceway, **one[raceway]} for one in result["rollers"]
                for raceway in RACEWAYS if one["inner"]["force_N"] >= 0.01 * largest]
    for name, key, extreme in (("largest_pressure", "hertz_pressure_Pa", max),
                               ("smallest_film", "film_minimum_m", min)):
        having = [one for one in contacts if key in one]
        said.equal(f"{name} is there", name in result, bool(having))
        if having:
            said.equal(f"{name} is a contact", result[name] in contacts, True)
            said.near(f"{name}.{key}", result[name][key], extreme(one[key] for one in having), relative=ROUND_OFF)


def audit_zone(said, result):
    """From the first to the last roller with more than 1 % of the largest force. No roller here carries less but more
    than nothing, unless its law always pushes."""
    rollers = result["rollers"]
    largest = max(one["inner"]["force_N"] for one in rollers)
    loaded = [one["azimuth_deg"] for one in rollers if one["inner"]["force_N"] > 0.01 * largest]
    said.equal("load_zone_deg", result["load_zone_deg"], [min(loaded), max(loaded)])


def audit_geometric_zone(said, result, inputs):
    """cos(half the zone) = P_d/(2 delta_r), about the direction in which the ring has moved."""
    along, across = result["displacement_m"], result["displacement_lateral_m"]
    cosine = inputs.bearing.clearance / 2 / math.hypot(along, across)
    half = math.degrees(math.acos(max(cosine, -1)))
    for end, sign in zip(result["geometric_load_zone_deg"], (-1, 1), strict=True):
        said.near("geometric_load_zone_deg", end, math.degrees(math.atan2(across, along)) + sign * half, absolute=1e-9)


def audit_stiffness(said, result, inputs):
    K = result["stiffness_N_per_m"]
    said.equal("stiffness is symmetric", K[0][1], K[1][0])
    if inputs.heavier:  # K d(place)/d(load) = (1, 0)
        step = 2 * LOAD_STEP * inputs.bearing.load
        rate = [(inputs.heavier[key] - inputs.lighter[key]) / step
                for key in ("displacement_m", "displacement_lateral_m")]
        for row, force in ((0, 1), (1, 0)):
            size = sum(abs(K[row][k] * rate[k]) for k in (0, 1))
            said.near(f"stiffness_N_per_m[{row}]", K[row][0] * rate[0] + K[row][1] * rate[1], force,
                      absolute=100 * LOAD_STEP**2 * size)
    said.equal("stiffness_error is there", "stiffness_error" in result, result["law"] not in DRY_LAWS)
    if result["law"] == "ehd":
        said.within("stiffness_error", result["stiffness_error"], 0, STIFFNESS_KNOWN)
        return
    if result["law"] == LINE:
        away = abs(K[0][0] - inputs.full["stiffness_N_per_m"][0][0])
        own = inputs.full["stiffness_error"] * inputs.full["stiffness_N_per_m"][0][0]
        said.near("stiffness_error", result["stiffness_error"], (away + own) / K[0][0], relative=1e-6)
    own = [[0.0, 0.0], [0.0, 0.0]]  # each roller: its two contacts in series
    for one, n in zip(result["rollers"], directions(result["rollers"]), strict=True):
        if one["inner"]["force_N"] > 0:
            soft = sum(1 / result["fit"][raceway]["K_N_per_m"] if result["law"] == LINE else
                       inputs.bearing.compliance(result["law"], raceway, one[raceway]["force_N"])
                       for raceway in RACEWAYS)
            for i in (0, 1):
                for k in (0, 1):
                    own[i][k] += n[i] * n[k] / soft
    for i in (0, 1):
        for k in (0, 1):
            said.near(f"stiffness_N_per_m[{i}][{k}]", K[i][k], own[i][k], absolute=1e-8 * own[0][0])


def audit_cage(said, cage, inputs):
    said.equal("cage.positions", cage["positions"], len(inputs.positions))
    for key in ("displacement_m", "displacement_lateral_m"):
        places = [one[key] for one in inputs.positions]
        size = max(one["displacement_m"] for one in inputs.positions)
        said.near(f"cage.{key}.mean", cage[key]["mean"], math.fsum(places) / len(places), absolute=BALANCED * size)
        said.near(f"cage.{key}.peak_to_peak", cage[key]["peak_to_peak"], max(places) - min(places),
                  absolute=BALANCED * size)
    largest = max(roller["inner"]["force_N"] for one in inputs.positions for roller in one["rollers"])
    said.near("cage.largest_force_N", cage["largest_force_N"], largest, relative=BALANCED)


def audit_fit(said, result, inputs):
    """The line through contacts solved here once more. Their errors are SOLVED times the offset film."""
    stated = inputs.bearing.case["fit"]
    low, high = stated["load_N"]
    n = stated["points"]
    for raceway in RACEWAYS:
        line, contacts = result["fit"][raceway], inputs.contacts[raceway]
        said.equal(f"fit.{raceway}.load_N", line["load_N"], [low, high])
        said.equal(f"fit.{raceway}.points", line["points"], n)
        forces = [low + (high - low) * k / (n - 1) for k in range(n)]
        x_0 = result["datum"][f"{raceway}_x0_m"]
        own = straight_line([contacts.approach(force, x_0) for force in forces], forces)
        # A point moves along the line by K times the error of its approach. Slopes and deviations move in proportion.
        moved = SOLVED * max(contacts.film("offset", force) for force in forces) * own["K_N_per_m"]
        said.near(f"fit.{raceway}.misfit", line["misfit"], line["residual_N"] / high, relative=ROUND_OFF)
        by_line, by_ehd = ([roller[raceway] for roller in one["rollers"]] for one in (result, inputs.full))
        least = max(at["force_N"] for at in by_line) / 100
        loads = [at["force_N"] for at in by_line if at["force_N"] >= least]
        let_go = [at for at, own in zip(by_ehd, by_line, strict=True) if at["force_N"] >= least > own["force_N"]]
        loads += [at["force_N"] for at in let_go]
        missed = max((abs(at["force_N"] - max(0.0, line["K_N_per_m"] * at["displacement_m"] + line["dF_N"]))
                      for at in let_go), default=0)
        said.within(f"fit.{raceway}.in_use.residual_N", line["in_use"]["residual_N"], (1 - BALANCED) * missed)
        said.equal(f"fit.{raceway}.in_use.load_N", line["in_use"]["load_N"], [min(loads), max(loads)])
        said.near(f"fit.{raceway}.in_use.misfit", line["in_use"]["misfit"],
                  line["in_use"]["residual_N"] / max(loads), relative=ROUND_OFF)
        for name, expected in own.items():
            size = {"correlation": 1.0, "K_N_per_m": own["K_N_per_m"], "dF_N": own["dF_N"]}.get(name, abs(expected))
            said.near(f"fit.{raceway}.{name}", line[name], expected, absolute=4 * moved / own["residual_N"] * size)


def audit_datum(said, result, inputs):
    """x_0 at which the dry approach meets the hertz law at the stated force."""
    force = inputs.bearing.case["datum"]["load_N"]
    for raceway in RACEWAYS:
        w, R, E = inputs.contacts[raceway].conditions(force)
        dry = inputs.bearing.dry_approach("hertz", raceway, force)
        x_0 = textbook.half_width(w, R, E) * math.exp(dry * math.pi * E / (4 * w) + 2 * textbook.DRY_OFFSET)
        said.near(f"datum.{raceway}_x0_m", result["datum"][f"{raceway}_x0_m"], x_0, relative=ROUND_OFF)


def audit_solved(said, raceway, curve, contacts):
    """The points of a curve are contacts, solved here once more."""
    solved = curve["solved"]
    forces = solved["force_N"]
    said.equal(f"curve.{raceway}.solved", {len(values) for values in solved.values()}, {curve["points"]})
    said.equal(f"curve.{raceway}.solved.force_N", [forces[0], forces[-1]], curve["load_N"])
    said.equal(f"curve.{raceway}.solved.force_N increases", forces, sorted(set(forces)))
    for key, which in (("offset_film_m", "offset"), ("film_minimum_m", "minimum"),
                       ("rolling_force_N_per_m", "rolling")):
        for k, (force, value) in enumerate(zip(forces, solved[key], strict=True)):
            said.near(f"curve.{raceway}.solved.{key}[{k}]", value, contacts[raceway].film(which, force),
                      relative=SOLVED)


def audit_torque(said, result, inputs):
    """u_s l Sum F_t over the speed between the rings. A contact below the lightest solved one follows a formula."""
    bearing = inputs.bearing
    forces = [(raceway, one[raceway]["force_N"]) for one in result["rollers"] for raceway in RACEWAYS]
    rolling = math.fsum(inputs.contacts[raceway].film("rolling", force) for raceway, force in forces if force > 0)
    said.near("torque_N_m", result["torque_N_m"], bearing.speed_sum * bearing.length * rolling / bearing.turn,
              relative=SOLVED + min(result["torque_error"], TORQUE_KNOWN))
    if result["law"] == LINE:  # the distance from ehd, and what that may be off
        full, own = inputs.full["torque_N_m"], inputs.full["torque_error"]
        away = abs(result["torque_N_m"] - full) + own * full
        said.near("torque_error", result["torque_error"], away / result["torque_N_m"], relative=1e-6)
    else:
        said.within("torque_error", result["torque_error"], 0, TORQUE_KNOWN)


def audit_curve(said, result, inputs):
    for raceway in RACEWAYS:
        curve = result["curve"][raceway]
        low, high = curve["load_N"]
        heaviest = max(one[raceway]["force_N"] for one in result["rollers"])
        said.within(f"curve.{raceway}.load_N[0]", low, 0, heaviest)
        said.within(f"curve.{raceway}.load_N[1]", high, heaviest)
        said.within(f"curve.{raceway}.points", curve["points"], 3)
        for name in ("interpolation_error", "joint_error", "joint_force_error", "force_error", "solver_error"):
            said.within(f"curve.{raceway}.{name}", curve[name], 0, 1e-2)
        said.within(f"curve.{raceway}.force_error", curve["force_error"], curve["joint_force_error"])
        audit_solved(said, raceway, curve, inputs.contacts)
    # Every point of curve and fit is a contact that was solved or remembered.
    points = sum(one[raceway]["points"] for one in (result["curve"], result.get("fit")) if one for raceway in RACEWAYS)
    said.within("contacts", result["cost"]["contact_solves"] + result["cost"]["contacts_from_memory"], points)


def thinnest(result):
    """The smallest film of a balance, with its raceway."""
    return min((one[raceway]["film_minimum_m"], raceway) for one in result["rollers"] for raceway in RACEWAYS
               if "film_minimum_m" in one[raceway])


def difference(one, other):
    """A row of the error budget: how far one balance is from the other."""
    change = [abs(a["inner"]["force_N"] - b["inner"]["force_N"])
              for a, b in zip(one["rollers"], other["rollers"], strict=True)]
    forces = [roller["inner"]["force_N"] for roller in other["rollers"]]
    return {"displacement_m": abs(one["displacement_m"] - other["displacement_m"]),
            "displacement_lateral_m": abs(one["displacement_lateral_m"] - other["displacement_lateral_m"]),
            "largest_force_N": change[forces.index(max(forces))], "any_force_N": max(change),
            "smallest_film_relative": abs(thinnest(one)[0] / thinnest(other)[0] - 1)}


def audit_budget(said, result, inputs):
    numbers = ("displacement_m", "displacement_lateral_m", "largest_force_N", "any_force_N", "smallest_film_relative")
    for row in result["error_budget"]:
        name = f"error_budget {row['source']}, {row['of']}"
        for key in numbers:
            said.within(f"{name}: {key}", row.get(key, 0), 0)
        said.equal(f"{name}: what has no bound", row.get("unknown", []), [])  # the audited results converged
        said.within(f"{name}: largest_force_N", row["largest_force_N"], high=row["any_force_N"])
        if row["kind"] == "difference":
            expected = difference(inputs.full, result) if row["source"] == "fit" else \
                difference(inputs.data[row["of"]], result)
            sizes = {"displacement_m": result["displacement_m"], "displacement_lateral_m": result["displacement_m"],
                     "smallest_film_relative": 1.0}
            for key in numbers:
                said.near(f"{name}: {key}", row[key], expected[key],
                          absolute=BALANCED * sizes.get(key, inputs.bearing.load))
        elif row["source"] == "interpolation":
            curve = result["curve"][thinnest(result)[1]]
            said.equal(f"{name}: smallest film", row["smallest_film_relative"], curve["interpolation_error"])
        if row["of"].endswith(", films"):
            said.equal(f"{name}: the balance", [row[key] for key in numbers[:4]], [0, 0, 0, 0])
    for key in numbers:
        said.near(f"errors.{key}", result["errors"][key],
                  sum(row.get(key, 0) for row in result["error_budget"] if row["source"] != "datum"), relative=1e-14)


def audit_variant(said, variant, result, inputs):
    """ehd-linear cut at zero approach."""
    audit_balance(said, f"{variant['name']}: ", variant, inputs)
    for one in variant["rollers"]:
        for raceway in RACEWAYS:
            row, name = one[raceway], f"{variant['name']} at {one['azimuth_deg']}: {raceway}"
            audit_contact_row(said, name, row, raceway, variant["name"], result, inputs, False)


def audit_bearing(result, inputs):
    said = Objections()
    law = result["law"]
    said.equal("version", result["version"], inputs.bearing.case["version"])
    audit_balance(said, "", result, inputs)
    for j, one in enumerate(result["rollers"]):
        for raceway in RACEWAYS:
            audit_contact_row(said, f"rollers[{j}].{raceway}", one[raceway], raceway, law, result, inputs,
                              law not in DRY_LAWS)
    audit_loaded(said, result)
    audit_places(said, result)
    audit_zone(said, result)
    audit_geometric_zone(said, result, inputs)
    audit_stiffness(said, result, inputs)
    if "cage" in result:
        audit_cage(said, result["cage"], inputs)
    if law not in DRY_LAWS:
        audit_datum(said, result, inputs)
        audit_curve(said, result, inputs)
        audit_torque(said, result, inputs)
        audit_budget(said, result, inputs)
    if law == LINE:
        audit_fit(said, result, inputs)
        for variant in result["variants"]:
            audit_variant(said, variant, result, inputs)
    cost = result["cost"]
    for name, value in cost.items():
        said.within(f"cost.{name}", value, 0)
    # Mirrored rollers are balanced once.
    groups = len({round(abs(psi), 9) for psi in inputs.bearing.azimuths()})
    said.equal("cost.rollers_balanced", cost["rollers_balanced"], groups * cost["newton_iterations"])
    if law in DRY_LAWS:
        said.equal("contacts of a dry law", (cost["contact_solves"], cost["contacts_from_memory"]), (0, 0))
    return said


def audit_csv_row(row, result, bearing):
    """A row of the CSV repeats the JSON."""
    said = Objections()
    said.equal("clearance_m", row["clearance_m"], bearing.clearance)
    azimuths = {one["azimuth_deg"]: one for one in result["rollers"]}
    if row["azimuth_deg"] not in azimuths:
        return [f"no roller at {row['azimuth_deg']}"]
    roller = azimuths[row["azimuth_deg"]]
    said.equal("roller", row["roller"], result["rollers"].index(roller) + 1)
    for key, value in row.items():
        for raceway in RACEWAYS:
            if key.startswith(raceway + "_"):
                said.equal(key, value, roller[raceway][key.removeprefix(raceway + "_")])
    return said


def run(program, case, *options, laws=LAWS):
    """The results of a case (a dictionary), by law."""
    path = program.write(f"{case['id']}.toml", to_toml(case))
    results = program.json("bearing", path, *options, *(word for law in laws for word in ("--law", law)))
    return {one["law"]: one for one in (results if isinstance(results, list) else [results])}


def changed(case, name, table, **values):
    """A copy of a case with its own id and some keys of a table replaced."""
    copied = copy.deepcopy(case)
    copied["id"] = name
    if table == "datum":
        copied["datum"] = {}
    copied[table].update(values)
    return copied


def other_runs(program, case, base):
    """Runs of neighbouring cases: loads, positions of the cage, data; each by law."""
    load, stated, x_0 = case["operation"]["radial_load_N"], case["bearing"], base["ehd"]["datum"]["inner_x0_m"]
    turns = [stated["first_azimuth_deg"] + 360 / stated["rollers"] * k / CAGE_POSITIONS
             for k in range(CAGE_POSITIONS)]
    cases = {
        "lighter": changed(case, "lighter", "operation", radial_load_N=load * (1 - LOAD_STEP)),
        "heavier": changed(case, "heavier", "operation", radial_load_N=load * (1 + LOAD_STEP)),
        "lundberg": changed(case, "datum-lundberg", "datum", law="lundberg"),
        "x_0 twice that of the inner raceway": changed(case, "datum-x0", "datum", law="x0", x0_m=2 * x_0)}
    cases |= {k: changed(case, f"turn-{k}", "bearing", first_azimuth_deg=turn) for k, turn in enumerate(turns)}
    runs = side_by_side([functools.partial(run, program, one) for one in cases.values()])
    return dict(zip(cases, runs, strict=True))


def solved_contacts(program, bearing, results):
    """Contacts at every force that a law with films met, and at those of the fit."""
    low, high = bearing.case["fit"]["load_N"]
    n = bearing.case["fit"]["points"]
    fitted = {low + (high - low) * k / (n - 1) for k in range(n)}
    return {raceway: Contacts(program, bearing, raceway,
                              fitted | {one[raceway]["force_N"] for result in results for one in result["rollers"]
                                        if "film_minimum_m" in one[raceway]}
                              | {force for result in results
                                 for force in result["curve"][raceway]["solved"]["force_N"]})
            for raceway in RACEWAYS}


def documents(program):
    """(name, kind, document, audit): every law in the plane, one along the load alone, the CSV, dry bearings."""
    case = read_case(HERE / "roller-bearing.toml")
    bearing, table = Bearing(case), program.folder / "bearing.csv"
    base = run(program, case, "--cage-positions", CAGE_POSITIONS, "--csv", table)
    others = other_runs(program, case, base)
    contacts = solved_contacts(program, bearing, [base[LINE], base["ehd"]])
    for law, result in base.items():
        inputs = Inputs(bearing, "plane", contacts, others["lighter"][law], others["heavier"][law],
                        [others[k][law] for k in range(CAGE_POSITIONS)],
                        {of: runs[law] for of, runs in others.items() if isinstance(of, str)}, base["ehd"])
        yield f"bearing, {law}", "bearing", result, functools.partial(audit_bearing, result, inputs)
    inputs, result = Inputs(bearing, "radial"), run(program, case, "--form", "radial", laws=["tripp"])["tripp"]
    yield "bearing --form radial, tripp", "bearing", result, functools.partial(audit_bearing, result, inputs)
    for k, row in enumerate(read_csv(table)):
        if k % 5 == 0:
            yield f"bearing --csv, row {k}", "bearing-csv", row, \
                functools.partial(audit_csv_row, row, base[row["law"]], bearing)
    preloaded = changed(changed(case, "preloaded", "bearing", rotating="outer", clearance_m=-1e-6),
                        "preloaded", "operation", radial_load_N=2.5e4)
    for dry in (read_case(TOP / "cases" / "harris-209.toml"), preloaded):
        for law, result in run(program, dry, laws=["hertz", "iso", "lundberg"]).items():
            inputs = Inputs(Bearing(dry), "plane")
            yield f"{dry['id']}, {law}", "bearing", result, functools.partial(audit_bearing, result, inputs)
