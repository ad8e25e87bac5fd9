# SPDX-License-Identifier: GPL-3.0-or-later
"""The `lubricant` of `ehd solve --json`: an oil by its grade, derived from the standards' formulas."""

import math

import textbook
from judge import Objections
from program import to_toml

CASE = {"id": "oil", "version": 1, "title": "an oil by its grade", "source": "own",
        "conditions": {"load_N_per_m": 1.0e5, "reduced_radius_m": 0.01, "reduced_modulus_Pa": 2.2e11,
                       "speed_sum_m_per_s": 3.0},
        "domain": {"inlet": "flooded"}}
LAWS = {"viscosity": "roelands", "density": "dowson-higginson"}
OILS = [
    {"iso_vg": 68, "temperature_C": 60.0},
    {"iso_vg": 7, "viscosity_index": 120.0, "temperature_C": 25.0, "density_15C_kg_per_m3": 850.0},
    {"viscosity_40C_mm2_per_s": 73.3, "viscosity_100C_mm2_per_s": 8.86, "temperature_C": 90.0, "alpha_per_Pa": 2.1e-8},
]
MIDPOINTS = {7: 6.8}  # of grades that are not their number
INVERTED = 1e-9  # log log Z and the index are inverted here and there


def audit(result, stated):
    said = Objections()
    oil = result["lubricant"]
    grade = stated.get("iso_vg")
    said.equal("iso_vg", oil.get("iso_vg"), grade)
    cold = MIDPOINTS.get(grade, grade) or stated["viscosity_40C_mm2_per_s"]
    said.equal("viscosity_40C_mm2_per_s", oil["viscosity_40C_mm2_per_s"], cold)
    hot = oil["viscosity_100C_mm2_per_s"]
    index = textbook.viscosity_index(cold, hot)
    said.near("viscosity_index", oil["viscosity_index"], index, relative=INVERTED)
    if grade:
        said.near("viscosity_index", index, stated.get("viscosity_index", 95), relative=INVERTED)
    else:
        said.equal("viscosity_100C_mm2_per_s", hot, stated["viscosity_100C_mm2_per_s"])
    T, density_15C = stated["temperature_C"], stated.get("density_15C_kg_per_m3", 870)
    said.equal("temperature_C", oil["temperature_C"], T)
    said.equal("density_15C_kg_per_m3", oil["density_15C_kg_per_m3"], density_15C)
    viscosity = textbook.walther(cold, hot, T)
    expansion = 0.6278 / density_15C * (T - 15)
    density = density_15C * math.exp(-expansion - 0.8 * expansion**2)
    eta = 1e-6 * viscosity * density
    said.near("viscosity_mm2_per_s", oil["viscosity_mm2_per_s"], viscosity, relative=INVERTED)
    said.near("density_kg_per_m3", oil["density_kg_per_m3"], density, relative=INVERTED)
    said.near("viscosity_Pa_s", oil["viscosity_Pa_s"], eta, relative=INVERTED)
    alpha = stated.get("alpha_per_Pa") or 1e-8 * (0.6 + 0.965 * math.log10(1000 * eta))
    if "alpha_per_Pa" not in stated:
        said.near("estimated_alpha_per_Pa", oil["estimated_alpha_per_Pa"], alpha, relative=INVERTED)
    SI = CASE["conditions"]
    M, L = textbook.moes_groups(SI["load_N_per_m"], SI["reduced_radius_m"], SI["reduced_modulus_Pa"],
                                SI["speed_sum_m_per_s"], eta, alpha)
    said.near("M", result["groups"]["M"], M, relative=INVERTED)
    said.near("L", result["groups"]["L"], L, relative=INVERTED)
    return said


def documents(program):
    for number, stated in enumerate(OILS):
        path = program.write("oil.toml", to_toml({**CASE, "lubricant": {**LAWS, **stated}}))
        result = program.json("solve", path, "--tolerance", "1e-2")
        # The rest of a result is held by the module contact.
        document = {"lubricant": result["lubricant"], "groups": {key: result["groups"][key] for key in "ML"}}
        yield f"oil {number + 1}", "oil", document, lambda d=document, s=stated: audit(d, s)
