# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers that the report draws (figures of results.json): profiles, bearings and force laws."""

import functools

import bearing
import contact
import textbook
import textbook_bearing
from judge import ROUND_OFF, Objections
from program import TOP, read_case, read_csv

CONTACT, BEARING = "kostreva-100lb-2500rpm", "na4908-10um"
TOLERANCE = 1e-4  # of the solves that are drawn
CHORD = 1e-3  # how far a drawn line may be from its curve


def true_fields(rows, offset):
    """A function of X: P, H and the cell of a profile on many nodes. Beyond its exit the gap opens without pressure."""
    X, P = ([row[key] for row in rows] for key in "XP")

    @functools.cache
    def at(x):
        if x > X[-1]:
            return 0.0, offset + x * x / 2 + textbook.deflection(X, P, x), 1e-2
        pressure, cell = contact.value_at(rows, "P", x)
        return pressure, contact.value_at(rows, "H", x)[0], cell
    return at


def audit_solver(said, drawn, alone, true):
    """`alone`: `ehd solve` of the same case; `true`: P and H over X."""
    name = drawn["solver"]
    said.equal(f"{name}: tolerance", drawn["tolerance"], TOLERANCE)
    for key in ("film", "pressure"):
        for entry, values in drawn[key].items():
            said.same(f"{name}: {key}.{entry}", values, alone[key][entry])
    for count in ("work_units", "nodes", "newton_iterations"):
        said.equal(f"{name}: {count}", drawn[count], alone["cost"][count])
    said.equal(f"{name}: field_error", drawn["field_error"], alone["fields"]["film_error"])
    said.within(f"{name}: wall_s", drawn["wall_s"], 0)
    said.within(f"{name}: chord_error", drawn["chord_error"], CHORD, CHORD)
    said.equal(f"{name}: X increases", drawn["X"], sorted(drawn["X"]))
    for x, p, h in zip(drawn["X"], drawn["P"], drawn["H"], strict=True):
        pressure, film, cell = true(x)
        said.near(f"{name}: P at {x}", p, pressure, absolute=min(CHORD, pressure / 3) + cell**2)
        said.near(f"{name}: H at {x}", h, film, absolute=CHORD + cell**2)


def audit_case(drawn, case, alone, true):
    said = Objections()
    said.equal("version", drawn["version"], case["version"])
    groups = contact.scales_of(case)[0]
    for key in ("M", "L"):
        said.near(key, drawn[key], groups[key], relative=ROUND_OFF)
    said.equal("inlet", drawn["inlet"], case["domain"]["inlet"])
    for one in drawn["solvers"]:
        audit_solver(said, one, alone[one["solver"]], true)
    return said


def audit_difference(difference, alone):
    """fast - reference, from the profiles of both."""
    said = Objections()
    for film in ("minimum", "central"):
        expected = alone["fast"]["film"][film]["hertz"] / alone["reference"]["film"][film]["hertz"] - 1
        said.near(f"film_{film}", difference[f"film_{film}"], expected, absolute=ROUND_OFF)
    return said


def audit_bearing(drawn, case, alone):
    said = Objections()
    said.equal("version", drawn["version"], case["version"])
    said.equal("clearance_m", drawn["clearance_m"], case["bearing"]["clearance_m"])
    for key in ("radial_load_N", "speed_rpm"):
        said.equal(key, drawn[key], case["operation"][key])
    for law in drawn["laws"]:
        for key, value in law.items():
            said.same(f"{law['law']}: {key}", value, alone[law["law"]][key])
    return said


def audit_dry_law(drawn, of):
    """A curve of force over approach."""
    said = Objections()
    for approach, force in zip(drawn["displacement_m"], drawn["force_N"], strict=True):
        said.near(f"approach at {force} N", approach, of.dry_approach(drawn["law"], drawn["raceway"], force),
                  relative=1e-9)
    return said


def documents(program):
    path, table = TOP / "cases" / f"{CONTACT}.toml", program.folder / "figure.csv"
    program.run("verify", "--quick", "--case", CONTACT, "--output", program.folder)
    drawn = program.read_json(program.folder / "results.json")["figures"]["cases"][0]
    alone = {solver: program.json("solve", path, "--solver", solver, "--tolerance", TOLERANCE)
             for solver in ("reference", "fast")}
    fine = program.json("solve", path, "--nodes", 4096, "--profile", table)
    true = true_fields(read_csv(table), fine["film"]["offset"]["hertz"])
    case = read_case(path)
    difference = drawn.pop("difference")
    yield f"figure of {CONTACT}", "figure", drawn, functools.partial(audit_case, drawn, case, alone, true)
    difference = {key: difference[key] for key in ("film_minimum", "film_central")}
    yield f"difference in {CONTACT}", "figure", difference, functools.partial(audit_difference, difference, alone)
    program.run("verify", "--quick", "--case", BEARING, "--output", program.folder)
    figures = program.read_json(program.folder / "results.json")["figures"]
    case = read_case(TOP / "cases" / f"{BEARING}.toml")
    alone = bearing.run(program, case, laws=[law["law"] for law in figures["bearing"][0]["laws"]])
    yield f"figure of {BEARING}", "figure-bearing", figures["bearing"][0], \
        functools.partial(audit_bearing, figures["bearing"][0], case, alone)
    of = textbook_bearing.Bearing(case)
    for law in figures["force_law"]:
        if law["law"] in textbook_bearing.DRY_LAWS:
            yield f"force law {law['law']}, {law['raceway']}", "figure-law", law, \
                functools.partial(audit_dry_law, law, of)
