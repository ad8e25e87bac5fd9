# SPDX-License-Identifier: GPL-3.0-or-later
"""What `ehd atlas` writes of a point: its record, its row of the table, its case. The films once more by `fast`, which
shares no discretisation with the atlas; the printed errors from those of the record."""

import functools
import json
import math

from judge import Objections
from program import TOP, read_case, read_csv
from response import film

POINTS, MOTION = "roelands-m20-l10-", "roelands-m1-l10-"
INLETS = {"flooded": "flooded", "cut4": -4}
TOLERANCE, TIME_LIMIT_S = 1e-10, 30
MOTION_TOLERANCE, MOTION_TIME_LIMIT_S = 1e-5, 200
FAST = {"films": "1e-6", "motion": "1e-4"}  # tolerances of the second opinion
ALPHA = 2.2e-8
# Where `ehd solve --json` has a column; whether the column's error is absolute, as that of the program.
COLUMNS = {"H_min": (("film", "minimum", "hertz"), ("film", "minimum", "error"), False),
           "H_cen": (("film", "central", "hertz"), ("film", "central", "error"), False),
           "H_couette": (("film", "couette", "hertz"), ("film", "couette", "error"), False),
           "X_exit": (("pressure", "exit_x"), ("pressure", "exit_x_error"), False),
           "H_0": (("film", "offset", "hertz"), ("film", "offset", "error"), True),
           "rolling_force": (("rolling_force", "dimensionless"), ("rolling_force", "error"), False),
           "P_spike": (("pressure", "spike", "hertz"), ("pressure", "spike", "error"), False)}
PLACE_KNOWN = 1e-3  # of X_spike by fast, which states no error of a place
QUANTITIES = {"film.minimum": "H_min", "film.central": "H_cen", "film.couette": "H_couette", "film.offset": "H_0",
              "pressure.exit": "X_exit", "pressure.spike": "P_spike", "rolling_force": "rolling_force"}


def at(document, path):
    for key in path:
        document = document[key]
    return document


def audit_head(said, record, point, tolerance, limit):
    said.equal("record: schema", record["schema"], 1)
    said.equal("record: id", record["id"], point)
    said.equal("record: tolerance", record["tolerance"], tolerance)
    said.equal("record: time_limit_s", record["time_limit_s"], limit)
    for name in ("nodes", "wall_s"):
        said.within(f"record: {name}", record[name], 1e-9)


def audit_printed(said, name, printed, error, reading, absolute):
    """The printed error covers that of the reading and the rounding of the text, and is rounded up to two digits."""
    said.within(f"{name}: error of the record", reading["absolute_error"], 0)
    covered = reading["absolute_error"] + abs(printed - reading["value"])
    size = 1 if absolute else abs(printed)
    said.within(f"{name}: printed error", error, (1 - 1e-6) * covered / size, 1.12 * covered / size)


def audit_values(said, record, row, alone):
    readings = record["readings"]
    said.equal("readings", set(readings), {*COLUMNS, "X_spike"})
    for name, (value, error, absolute) in COLUMNS.items():
        true, stated = at(alone, value), at(alone, error)
        reading = readings[name]
        said.near(f"{name} of the record", reading["value"], true,
                  absolute=reading["absolute_error"] + stated * (1 if absolute else abs(true)))
        audit_printed(said, name, row[name], row[f"{name}_error"], reading, absolute)
    said.near("X_spike of the record", readings["X_spike"]["value"], alone["pressure"]["spike"]["x"],
              absolute=PLACE_KNOWN)
    audit_printed(said, "X_spike", row["X_spike"], row["X_spike_error"], readings["X_spike"], True)


def audit_case(said, case, row, M, L):
    said.equal("case: version", case["version"], 1)
    said.equal("case: moes", case["moes"], {"M": M, "L": L})
    said.equal("case: lubricant", case["lubricant"], {"viscosity": "roelands", "density": "dowson-higginson",
                                                      "alpha_per_Pa": ALPHA, "z": 0.68, "p0_Pa": 1.96e8})
    said.equal("case: inlet", case["domain"]["inlet"], INLETS[row["id"].rsplit("-", 1)[1]])
    said.equal("case: quantities", {one["quantity"] for one in case["expect"]}, set(QUANTITIES))
    for one in case["expect"]:
        name = QUANTITIES[one["quantity"]]
        said.equal(f"case: {name}", float(one["value"]), row[name])
        size = 1 if name != "H_0" else abs(row[name])  # relative throughout
        said.near(f"case: {name}: uncertainty", one["uncertainty"], row[f"{name}_error"] / size, relative=0.1)


def audit_point(document, alone, point):
    said, (record, row) = Objections(), (document["record"], document["row"])
    M, L = 20, 10
    audit_head(said, record, point, TOLERANCE, TIME_LIMIT_S)
    said.equal("row: id", row["id"], point)
    said.equal("row: M, L", (row["M"], row["L"]), (M, L))
    said.equal("row: inlet", row["inlet"], INLETS[point.rsplit("-", 1)[1]])
    said.near("row: p_H_GPa", row["p_H_GPa"], 1e-9 * L * math.sqrt(M / (2 * math.pi)) / ALPHA, relative=1e-3)
    said.equal("row: tolerance", row["tolerance"], TOLERANCE)
    said.equal("row: nodes", row["nodes"], record["nodes"])
    said.near("row: wall_s", row["wall_s"], record["wall_s"], relative=1e-2)
    audit_values(said, record, row, alone)
    audit_case(said, document["case"], row, M, L)
    return said


def audit_reading(said, name, readings, row, column, true, known):
    """A number of the motion: by `fast` to `known`, and as it is printed."""
    reading = readings[name]
    said.near(f"{name} of the record", reading["value"], true, absolute=reading["absolute_error"] + known)
    audit_printed(said, name, row[column], row[f"{column}_error"], reading, True)


def audit_motion(document, alone, point, lengths):
    said, record = Objections(), document["record"]
    audit_head(said, record, point, MOTION_TOLERANCE, MOTION_TIME_LIMIT_S)
    readings = record["readings"]
    said.equal("readings", len(readings), 2 * (len(document["kappa"]) + len(document["waves"])))
    for row in document["kappa"] + document["waves"]:
        said.equal("row: M, L", (row["M"], row["L"]), (1, 10))
    said.equal("Omega", [row["Omega"] for row in document["kappa"]], list(range(9)))
    for row in document["kappa"]:
        omega = round(row["Omega"])
        if omega == 0:
            parts = [(alone["slow"][f"kappa_{k}"]["value"], alone["slow"][f"kappa_{k}"]["error"]) for k in (0, 1)]
            values = [(value, error * abs(value)) for value, error in parts]
        else:
            kappa = alone["response"][omega - 1]["kappa"]
            size = kappa["error"] * math.hypot(kappa["real"], kappa["imag"])
            values = [(kappa["real"], size), (kappa["imag"] / omega, size / omega)]
        for column, (true, known) in zip(("stiffness", "damping"), values, strict=True):
            audit_reading(said, f"{column} {omega}", readings, row, column, true, known)
    said.equal("wavelengths", [row["wavelength"] for row in document["waves"]], lengths)
    for row, wave in zip(document["waves"], alone["waviness"], strict=True):
        said.equal("slip", row["slip"], 1)
        true = film(wave)
        for column, value, size in (("ratio", abs(true), 1), ("phase_deg", wave["phase_deg"], 180 / math.pi)):
            known = wave["error"] * size * (abs(true) if column == "ratio" else 1)
            audit_reading(said, f"{column} {row['wavelength']:g} 1", readings, row, column, value, known)
    return said


def record_of(folder, point, part="films"):
    """From the journal. A line: a checksum, the point's key, the record."""
    lines = (folder / ".progress" / part / "journal").read_text().splitlines()[1:]
    return next(record for line in lines if (record := json.loads(line.split(" ", 2)[2]))["id"] == point)


def documents(program):
    folder, cases = program.folder / "atlas", TOP / "cases" / "atlas"
    program.run("atlas", "--only", POINTS, "--output", folder)
    for row in read_csv(folder / "atlas.csv"):
        point = row["id"]
        alone = program.json("solve", cases / f"{point}.toml", "--tolerance", FAST["films"])
        document = {"record": record_of(folder, point), "row": row, "case": read_case(folder / f"{point}.toml")}
        yield point, "atlas", document, functools.partial(audit_point, document, alone, point)
    program.run("atlas", "--motion", "--only", MOTION, "--output", folder)
    rows = {name: read_csv(folder / f"{name}.csv") for name in ("kappa", "waviness")}
    point, lengths = rows["kappa"][0]["id"], [row["wavelength"] for row in rows["waviness"]]
    # 1, 2, 4, 8, 16 L^(1/2)/M^(3/4) up to 20 b, in four digits.
    wanted = [float(f"{length:.4g}") for length in (2**k * math.sqrt(10) for k in range(5)) if length <= 20]
    asked = [word for omega in range(1, 9) for word in ("--omega", omega)]
    asked += [word for length in lengths for word in ("--wavelength", length)]
    alone = program.json("response", cases / f"{point}.toml", *asked, "--tolerance", FAST["motion"])
    document = {"record": record_of(folder, point, "motion"), "kappa": rows["kappa"], "waves": rows["waviness"]}
    yield f"{point} in motion", "atlas-motion", document, \
        functools.partial(audit_motion, document, alone, point, wanted)
