# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd statements --json`: changes of loads and approaches against `ehd bearing` of the changed case."""

import functools

import bearing
from judge import ROUND_OFF, Objections
from program import TOP, read_case

CASES = ("na4908", "na4908-2.5um", "na4908-10um")  # by clearance
FILM_LAWS = (bearing.LINE, "ehd")
# Rows that are computed again: their key, and what they change.
CHANGES = {
    ("as the case", ""): None,
    ("rotating ring", "outer"): ("bearing", {"rotating": "outer"}),
    ("length", "0.018 m"): ("bearing", {"length_m": 0.018}),
}


def top(result):
    """The inner contact of the roller in the load line."""
    return min(result["rollers"], key=lambda one: abs(one["azimuth_deg"]))["inner"]


def values_of(dry, film):
    """What (a), (b) and (c) say in numbers. `dry`, `film`: results at the three clearances."""
    load = [top(b)["force_N"] / top(a)["force_N"] - 1 for a, b in zip(dry, film, strict=True)]
    approach = [top(b)["displacement_m"] / top(a)["displacement_m"] - 1 for a, b in zip(dry, film, strict=True)]
    loaded, others = approaches_of(dry, film)
    return {"a": {"change": load[0], "apart": apart(dry[0], film[0])},
            "b": {"least": max(approach), "most": min(approach), "loaded": max(b / a - 1 for a, b in loaded),
                  "outside_m": max([0, *(b - a for a, b in others)])},
            "c": {"middle": load[1], "largest": load[2], "apart": apart(dry[1], film[1])}, "d": {}}


def apart(dry, film):
    """The largest change of a roller's load by the film, over the largest dry load."""
    forces = [[one["inner"]["force_N"] for one in result["rollers"]] for result in (dry, film)]
    return max(abs(a - b) for a, b in zip(*forces, strict=True)) / max(forces[0])


def approaches_of(dry, film):
    """(dry, with films) of each inner contact at all clearances: of the rollers that the dry law loads, by at least 1 %
    of the largest load, and of the others."""
    loaded, others = [], []
    for a, b in zip(dry, film, strict=True):
        largest = max(one["inner"]["force_N"] for one in a["rollers"])
        for one, two in zip(a["rollers"], b["rollers"], strict=True):
            of = loaded if one["inner"]["force_N"] >= 0.01 * largest else others
            of.append((one["inner"]["displacement_m"], two["inner"]["displacement_m"]))
    return loaded, others


def common(*lists):
    """What lists of intervals have in common."""
    result = lists[0]
    for other in lists[1:]:
        result = [[max(a, c), min(b, d)] for a, b in result for c, d in other if max(a, c) <= min(b, d)]
    return result


def audit_row(said, row, expected):
    name = f"{row['factor']} {row['value']}, {row['law']}"
    for statement in row["statements"]:
        values = expected[statement["letter"]]
        said.equal(f"{name}: ({statement['letter']})", set(statement["values"]), set(values))
        for key, value in values.items():
            said.near(f"{name}: {key}", statement["values"][key], value, absolute=ROUND_OFF)
    a, b, c, d = (row[f"x0_{letter}_m"] for letter in "abcd")
    for key, ranges in row.items():
        if key.endswith("_m") and isinstance(ranges, list):
            ends = [0, row["x0_lowest_m"], *(end for one in ranges for end in one), row["x0_highest_m"]]
            said.equal(f"{name}: {key} increases", ends, sorted(ends))
    said.equal(f"{name}: x0_abc_m", row["x0_abc_m"], common(a, b, c))
    said.equal(f"{name}: x0_all_hold_m", row["x0_all_hold_m"], common(a, b, c, d))
    for letter, all_rollers in (("b", b), ("c", c)):  # what holds for every roller holds at psi = 0
        said.equal(f"{name}: x0_{letter}_m", all_rollers, common(all_rollers, row[f"x0_{letter}_at_psi_0_m"]))


def audit_statements(document, all_rows, runs):
    said = Objections()
    for row in document["rows"]:
        at = runs[row["factor"], row["value"]]
        audit_row(said, row, values_of([one["hertz"] for one in at], [one[row["law"]] for one in at]))
    for one in document["summary"]:
        single = [row for row in all_rows if row["law"] == one["law"] and row["factor"] != "two choices"]
        holds = [statement["holds"] for row in single for statement in row["statements"]
                 if statement["letter"] == one["letter"]]
        said.equal(f"summary of ({one['letter']}), {one['law']}", (one["holds"], one["of"]), (sum(holds), len(single)))
        alone = [statement for row in single for statement in row["statements"]
                 if statement["letter"] == one["letter"] and statement.get("holds_at_psi_0") and not statement["holds"]]
        named = one["at_psi_0_alone"].split("; ") if one["at_psi_0_alone"] else []
        said.equal(f"summary of ({one['letter']}), {one['law']}: at psi = 0 alone", len(named), len(alone))
    said.within("contact_solves", document["contact_solves"], 1)
    said.within("contacts_from_memory", document["contacts_from_memory"], 1)
    return said


def changed_runs(program, change):
    """The three clearances with a change, each by law."""
    results = []
    for name in CASES:
        case = read_case(TOP / "cases" / f"{name}.toml")
        if change:
            case = bearing.changed(case, f"{name}-changed", change[0], **change[1])
        results.append(bearing.run(program, case, laws=["hertz", *FILM_LAWS]))
    return results


def documents(program):
    """The rows of CHANGES with the summary; the other rows are counted."""
    document = program.json("statements")
    runs = {key: changed_runs(program, change) for key, change in CHANGES.items()}
    all_rows = document["rows"]
    document["rows"] = [row for row in all_rows if (row["factor"], row["value"]) in CHANGES]
    yield "statements", "statements", document, functools.partial(audit_statements, document, all_rows, runs)
