# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of the results.json that `ehd verify --output DIR` writes: each claim with its error, tolerance, margin
and verdict; and every count."""

import fnmatch
import functools
import re

from judge import ROUND_OFF, Objections
from program import TOP, read_case

RUNS = [["--rung", "2"], ["--case", "kostreva-100lb-2500rpm"], ["--case", "harris-209"], ["--case", "na4908-10um"]]
VERDICTS = ("pass", "fail", "inconclusive")
EPSILON = 2.0**-52
RUNGS = 12


def last_digit(text):
    """A unit of the last digit of a number as it is printed."""
    mantissa, _, exponent = text.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))


def audit_tolerance(said, name, claim):
    """A tolerance is what its reason says. Numbers in the reason have three digits."""
    tolerance = claim["tolerance"]
    value, reason = tolerance["value"], tolerance["reason"]
    said.within(f"{name}: tolerance", value, 0)
    if match := re.fullmatch(r"([\d.e+]+) operations, condition ([\d.e+-]+)", reason):
        said.near(f"{name}: tolerance", value, float(match[1]) * float(match[2]) * EPSILON, relative=1e-2)
    elif match := re.fullmatch(r"estimate ([\d.e+-]+) x safety ([\d.e+-]+)", reason):
        said.near(f"{name}: tolerance", value, float(match[1]) * float(match[2]), relative=1e-2)
    elif match := re.fullmatch(r"half a unit of the last digit of ([\d.e+-]+)", reason):
        said.near(f"{name}: tolerance", value, last_digit(match[1]) / 2 / abs(float(match[1])), relative=ROUND_OFF)
    elif match := re.search(r" below ([\d.e-]+)$", reason) or re.match(r"--tolerance ([\d.e-]+) asks ", reason):
        said.equal(f"{name}: tolerance", value, float(match[1]))


def audit_claim(said, claim, expectations):
    name = claim["id"]
    error, uncertainty, tolerance = claim["error"], claim["uncertainty"], claim["tolerance"]["value"]
    said.within(f"{name}: error", error, 0)
    said.within(f"{name}: uncertainty", uncertainty, 0)
    audit_tolerance(said, name, claim)
    verdict = "pass" if error + uncertainty <= tolerance else \
        "fail" if error - uncertainty > tolerance else "inconclusive"
    said.equal(f"{name}: verdict", claim["verdict"], verdict)
    # What is left of the tolerance; a fact that holds or does not leaves nothing.
    left = 1 - (error + uncertainty) / tolerance if tolerance > 0 else 0
    said.near(f"{name}: margin", claim["margin"], left, absolute=2 * EPSILON)
    if "expected" in claim and "measured" in claim:
        said.near(f"{name}: error", error, abs(claim["measured"] / claim["expected"] - 1), absolute=ROUND_OFF)
        printed = name.rsplit("/", 1)[1]
        if printed in expectations.get(claim.get("case"), ()):
            said.equal(f"{name}: expected", claim["expected"], float(printed))


@functools.cache
def matches(name, pattern):
    return fnmatch.fnmatchcase(name, pattern)


def count(claims, skipped):
    counts = {verdict: sum(one["verdict"] == verdict for one in claims) for verdict in VERDICTS}
    return counts | {"skipped": len(skipped)}


def audit_verify(results):
    said = Objections()
    claims, skipped = results["claims"], results["skipped"]
    cases = {one["case"]: read_case(TOP / "cases" / f"{one['case']}.toml") for one in claims + skipped if "case" in one}
    expectations = {name: [str(one["value"]) for one in case.get("expect", []) if "value" in one]
                    for name, case in cases.items()}
    for claim in claims:
        audit_claim(said, claim, expectations)
    for one in claims + skipped:
        if "version" in one:
            said.equal(f"{one['id']}: version", one["version"], cases[one["case"]]["version"])
    summary = results["summary"]
    for name, number in count(claims, skipped).items():
        said.equal(f"summary: {name}", summary[name], number)
    said.equal("rungs", [one["rung"] for one in results["rungs"]], list(range(RUNGS)))
    for rung in results["rungs"]:
        of = [[one for one in ones if one["rung"] == rung["rung"]] for ones in (claims, skipped)]
        for name, number in count(*of).items():
            said.equal(f"rung {rung['rung']}: {name}", rung[name], number)
        margins = [one["margin"] for one in of[0] if one["tolerance"]["value"] > 0 and not one.get("finding")]
        said.equal(f"rung {rung['rung']}: worst_margin", rung.get("worst_margin"), min(margins, default=None))
    for part in results["traceability"]:
        of = [[one for one in ones if any(matches(one["id"], pattern) for pattern in part["patterns"])]
              for ones in (claims, skipped)]
        said.equal(f"{part['part']}: claims", part["claims"], len(of[0]))
        for name, number in count(*of).items():
            said.equal(f"{part['part']}: {name}", part[name], number)
    said.equal("schema", results["schema"], "ehd-verify-2")
    said.equal("threads", summary["threads"], results["figures"]["threads"])
    said.within("cores", results["provenance"]["cores"], 1)
    for time in [summary["wall_s"], *(topic["wall_s"] for topic in results["topics"])]:
        said.within("a time", time, 0)
    return said


def documents(program):
    for number, options in enumerate(RUNS):
        folder = program.folder / f"verify-{number}"
        program.run("verify", "--quick", *options, "--output", folder)
        results = program.read_json(folder / "results.json")
        results["figures"] = {"threads": results["figures"]["threads"]}  # the figures repeat what other audits hold
        yield f"verify {' '.join(options)}", "verify", results, functools.partial(audit_verify, results)
