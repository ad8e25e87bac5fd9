# SPDX-License-Identifier: GPL-3.0-or-later
"""The inputs of bearings in `ehd cases --json`, each from the case's own file; and what its source says of it."""

import functools

from judge import ROUND_OFF, Objections
from program import TOP, read_case

CASES = ("na4908", "harris-209", "iso-6-rollers")
# What a file may leave out (docs/case-format.md).
DEFAULTS = {("bearing", "first_azimuth_deg"): 0, ("lubricant", "p0_Pa"): 1.9613e8, ("fit", "points"): 6}


def stated(case, table, key):
    """What the file has; absent where it leaves the key out and no default holds."""
    numbers = case.get(table, {})
    if table == "operation" and key in ("inner_speed_rpm", "outer_speed_rpm") and "speed_rpm" in numbers:
        return numbers["speed_rpm"] if key.startswith(case["bearing"]["rotating"]) else 0
    return numbers.get(key, DEFAULTS.get((table, key)))


def audit_inputs(said, inputs, case):
    expected = {"bearing", "operation", "material"} | ({"lubricant", "datum", "fit"} if "lubricant" in case else set())
    said.equal("tables", set(inputs) - {"oil"}, expected)
    for table in expected:
        for key in {*case.get(table, {}), *inputs[table]} - {"rotating", "speed_rpm"}:
            value, of_file = inputs[table].get(key), stated(case, table, key)
            if isinstance(of_file, list):
                said.equal(f"{table}.{key}", value, [float(one) for one in of_file])
            elif isinstance(of_file, str) or key == "law":
                said.equal(f"{table}.{key}", value, of_file or "palmgren")
            else:
                said.near(f"{table}.{key}", value, of_file, relative=ROUND_OFF)


def audit(document, case):
    said = Objections()
    said.equal("cases", len(document["cases"]), 1)
    one = document["cases"][0]
    said.equal("version", one["version"], case["version"])
    audit_inputs(said, one["inputs"], case)
    said.equal("expect", len(one["expect"]), len(case.get("expect", [])))
    for k, (found, of_file) in enumerate(zip(one["expect"], case.get("expect", []), strict=True)):
        if "value" not in of_file:
            continue
        said.equal(f"expect[{k}].value", found["value"], float(of_file["value"]))
        mantissa, _, exponent = of_file["value"].partition("e")
        half_unit = 0.5 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
        said.near(f"expect[{k}].uncertainty", found["uncertainty"],
                  of_file.get("uncertainty", half_unit / abs(found["value"])), relative=1e-9)
    return said


def documents(program):
    for name in CASES:
        document = program.json("cases", name)
        yield f"cases {name}", "cases", document, functools.partial(audit, document, read_case(
            TOP / "cases" / f"{name}.toml"))
