# SPDX-License-Identifier: GPL-3.0-or-later
"""The rows of `ehd sweep`: rows.json against `ehd solve` and `ehd bearing` of the same case; rows.csv against it."""

import copy
import functools

import bearing
from judge import Objections
from program import TOP, read_case, read_csv, to_toml

INPUTS = TOP / "tests" / "outputs" / "inputs"
NOT_REPEATED = ("wall_s", "planning_s", "total_s", "stage_s")  # times
# From a column of a contact's row to its place in the JSON.
CONTACT_COLUMNS = {
    "M": "groups/M", "L": "groups/L", "hertz_pressure_Pa": "groups/hertz_pressure_Pa",
    "film_minimum_hertz": "film/minimum/hertz", "film_minimum_moes": "film/minimum/moes",
    "film_minimum_error": "film/minimum/error", "film_central_hertz": "film/central/hertz",
    "film_central_moes": "film/central/moes", "film_central_error": "film/central/error",
    "film_offset_hertz": "film/offset/hertz", "pressure_maximum_hertz": "pressure/maximum/hertz",
    "approach_hertz": "approach/hertz", "load_error": "load_error", "nodes": "cost/nodes",
}


def keys_of(sweep_file, row):
    """The values that the sweep file gives to a row."""
    values = []
    for value in sweep_file["keys"].values():
        if isinstance(value, dict):
            low, high, n = value["from"], value["to"], value["points"]
            logarithmic = value["spacing"] == "logarithmic"
            value = [low * (high / low) ** (k / (n - 1)) if logarithmic else low + (high - low) * k / (n - 1)
                     for k in range(n)]
        values.append(value)
    if sweep_file["combine"] == "zip":
        return dict(zip(sweep_file["keys"], [value[row] for value in values], strict=True))
    chosen = {}
    for name, value in reversed(list(zip(sweep_file["keys"], values, strict=True))):  # the last key changes fastest
        row, k = divmod(row, len(value))
        chosen[name] = value[k]
    return chosen


def with_keys(case, keys):
    case = copy.deepcopy(case)
    for name, value in keys.items():
        table, key = name.split(".")
        case[table][key] = value
    return case


def audit_row(row, number, sweep_file, single):
    """`single`: the results of the same case alone."""
    said = Objections()
    said.equal("row", row["row"], number)
    expected = keys_of(sweep_file, number)
    said.equal("keys", set(row["keys"]), set(expected))
    for name, value in expected.items():
        said.near(name, row["keys"][name], value, relative=1e-14)
    said.equal("results", len(row["results"]), len(single))
    for one, other in zip(row["results"], single, strict=True):
        said.same("", one, other, apart=NOT_REPEATED)
    return said


def audit_contact_line(line, rows):
    said = Objections()
    if line["row"] not in range(len(rows)):
        return [f"no row {line['row']}"]
    row = rows[int(line["row"])]
    for column, value in line.items():
        if column in row["keys"]:
            said.equal(column, value, row["keys"][column])
        elif column in CONTACT_COLUMNS:
            expected = row["results"][0]
            for key in CONTACT_COLUMNS[column].split("/"):
                expected = expected[key]
            said.equal(column, value, expected)
    return said


def audit_bearing_line(line, rows, roughness):
    """What a line says of a balance, from its rollers."""
    said = Objections()
    if line["row"] not in range(len(rows)):
        return [f"no row {line['row']}"]
    row = rows[int(line["row"])]
    result = next(one for one in row["results"] if one["law"] == line["law"])
    rollers = result["rollers"]
    contacts = [one[raceway] for one in rollers for raceway in bearing.RACEWAYS]
    top = max(rollers, key=lambda one: one["inner"]["force_N"])
    largest = top["inner"]["force_N"]
    expected = dict(row["keys"])
    expected |= {name: result[name] for name in ("displacement_m", "displacement_lateral_m", "balance_error")}
    expected |= {"largest_force_N": largest, "largest_force_azimuth_deg": top["azimuth_deg"],
                 "hertz_pressure_maximum_Pa": max(one.get("hertz_pressure_Pa", 0) for one in contacts),
                 "contacts": result["cost"]["contact_solves"]}
    if films := [one["film_minimum_m"] for one in contacts if "film_minimum_m" in one]:
        expected |= {"film_minimum_m": min(films), "datum_inner_x0_m": result["datum"]["inner_x0_m"],
                     "datum_outer_x0_m": result["datum"]["outer_x0_m"], "lambda_ratio_minimum": min(films) / roughness}
    if fit := result.get("fit"):  # where the line was not fitted; a contact without force says nothing of it
        ends = {raceway: fit[raceway]["load_N"] for raceway in bearing.RACEWAYS}
        forces = [(raceway, one[raceway]["force_N"]) for one in rollers for raceway in bearing.RACEWAYS]
        expected["fit_used_outside"] = sum(force > 0 and not ends[raceway][0] <= force <= ends[raceway][1]
                                           for raceway, force in forces)
    if errors := result.get("errors"):
        expected |= {"displacement_error_m": errors["displacement_m"],
                     "displacement_lateral_error_m": errors["displacement_lateral_m"],
                     "largest_force_error_N": errors["largest_force_N"],
                     "film_minimum_error": errors["smallest_film_relative"]}
    for column, value in expected.items():
        said.near(column, line[column], value, relative=1e-14)
    # Loaded: with any force, or with more than 1 % of the largest.
    forces = [one["inner"]["force_N"] for one in rollers]
    said.within("loaded_rollers", line["loaded_rollers"], sum(force > 0.01 * largest for force in forces),
                sum(force > 0 for force in forces))
    return said


def audit_cost(cost, rows):
    said = Objections()
    for name, expected in (("rows", len(rows)), ("computed", len(rows)), ("failed", 0), ("threads", 2)):
        said.equal(name, cost[name], expected)
    # A row states the solves that it needs alone. What it takes from other rows is saved.
    alone = sum(one["cost"].get("contact_solves", 1) for row in rows for one in row["results"])
    said.within("contact_solves", cost["contact_solves"], 1, alone)
    said.equal("contact_solves + contact_solves_saved", cost["contact_solves"] + cost["contact_solves_saved"], alone)
    for name in ("wall_s", "rows_s"):
        said.within(name, cost[name], 0)
    said.within("provenance.cores", cost["provenance"]["cores"], 1)
    return said


def swept(program, name):
    folder = program.folder / name
    program.run("sweep", INPUTS / f"{name}.toml", "--output", folder, "--threads", 2)
    return read_case(INPUTS / f"{name}.toml"), program.read_json(folder / "rows.json"), read_csv(folder / "rows.csv"), \
        program.read_json(folder / "cost.json")


def documents(program):
    """(name, kind, document, audit) of every row and every line."""
    file, result, lines, cost = swept(program, "contacts")
    case = read_case(TOP / "cases" / f"{file['case']}.toml")
    for number, row in enumerate(result["rows"]):
        path = program.write(f"{case['id']}.toml", to_toml(with_keys(case, keys_of(file, number))))
        single = [program.json("solve", path, "--solver", file["solver"], "--tolerance", file["tolerance"])]
        yield f"sweep contacts, row {number}", "sweep", row, functools.partial(audit_row, row, number, file, single)
    for line in lines:
        yield f"sweep contacts, line {line['row']}", "sweep-csv", line, \
            functools.partial(audit_contact_line, line, result["rows"])
    yield "sweep contacts, cost.json", "sweep-cost", cost, functools.partial(audit_cost, cost, result["rows"])
    file, result, lines, cost = swept(program, "bearings")
    case = read_case(INPUTS / file["case"])
    for number, row in enumerate(result["rows"]):
        single = list(bearing.run(program, with_keys(case, keys_of(file, number)), laws=file["laws"]).values())
        for one in single:
            one.pop("error_budget", None)  # of `ehd bearing` alone
        yield f"sweep bearings, row {number}", "sweep", row, functools.partial(audit_row, row, number, file, single)
    for line in lines:
        yield f"sweep bearings, line {line['row']} {line['law']}", "sweep-csv", line, \
            functools.partial(audit_bearing_line, line, result["rows"], case["bearing"]["roughness_m"])
    yield "sweep bearings, cost.json", "sweep-cost", cost, functools.partial(audit_cost, cost, result["rows"])
