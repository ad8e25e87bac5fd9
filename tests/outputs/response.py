# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd response --json` by fast: against the reference, and against kappa where a formula gives them."""

import cmath
import functools
import math

from judge import ROUND_OFF, Objections
from program import TOP, read_case

CASE = "own-steel-20-10"
QUESTIONS = ("--omega", 0.5, "--omega", 2, "--frequency", 1000, "--wavelength", 1, "--slip", 0.5)
TOLERANCE, CERTIFIED = 1e-4, 1e-7


def value_of(kappa):
    return complex(kappa["real"], kappa["imag"])


def near_truth(said, name, value, error, truth, largest=TOLERANCE):
    said.within(f"{name}: error", error, 0, largest)
    said.near(name, value, truth, relative=error + CERTIFIED)


def audit_si(said, name, entry, stiffness, damping, error):
    """Stiffness and damping a length in SI: kappa p_H R/b, and kappa's imaginary part over omega."""
    said.near(f"{name}: stiffness", entry["stiffness_N_per_m2"], stiffness, relative=ROUND_OFF)
    said.near(f"{name}: damping", entry["damping_N_s_per_m2"], damping, relative=ROUND_OFF)
    said.within(f"{name}: stiffness_error", entry["stiffness_error"], (1 - ROUND_OFF) * error, 1.2 * error)


def audit(result, steady, truth, case):
    said = Objections()
    SI = case["conditions"]
    radius, mean_speed = SI["reduced_radius_m"], SI["speed_sum_m_per_s"] / 2
    said.equal("version", result["version"], case["version"])
    said.same("groups", result["groups"], steady["groups"])
    half_width = result["groups"]["half_width_m"]
    unit = result["groups"]["hertz_pressure_Pa"] * radius / half_width
    second = half_width / mean_speed
    slow = result["slow"]
    for name in ("kappa_0", "kappa_1"):
        near_truth(said, name, slow[name]["value"], slow[name]["error"], truth["slow"][name]["value"])
    audit_si(said, "slow", slow, slow["kappa_0"]["value"] * unit, slow["kappa_1"]["value"] * unit * second,
             slow["kappa_0"]["error"])
    said.near("slow: damping_error", slow["damping_error"], slow["kappa_1"]["error"], relative=ROUND_OFF)
    highest = max(at["omega"] for at in result["response"])
    said.equal("highest_certified_omega", result["highest_certified_omega"], highest)
    for name, at, exact, asked in zip(("first", "second", "third"), result["response"], truth["response"],
                                      (0.5, 2, 2000 * math.pi * second), strict=True):
        said.near(f"{name}: omega", at["omega"], asked, relative=ROUND_OFF)
        said.near(f"{name}: frequency_Hz", at["frequency_Hz"], at["omega"] / (2 * math.pi * second), relative=ROUND_OFF)
        kappa = value_of(at["kappa"])
        near_truth(said, f"{name}: kappa", kappa, at["kappa"]["error"], value_of(exact["kappa"]))
        said.near(f"{name}: damping", at["damping"]["value"], kappa.imag / at["omega"], relative=ROUND_OFF)
        # An error of kappa, all of it in the imaginary part, is the most that the damping can be off.
        most = at["kappa"]["error"] * abs(kappa / kappa.imag)
        said.within(f"{name}: damping error", at["damping"]["error"], 0, most * (1 + ROUND_OFF))
        said.near(f"{name}: damping error", at["damping_error"], at["damping"]["error"], relative=ROUND_OFF)
        audit_si(said, name, at, kappa.real * unit, at["damping"]["value"] * unit * second, at["kappa"]["error"])
    wave, exact = result["waviness"][0], truth["waviness"][0]
    said.equal("wavelength", wave["wavelength"], 1)
    said.equal("slip", wave["slip"], 0.5)
    near_truth(said, "wavy film", film(wave), wave["error"], film(exact))
    cost = result["cost"]
    for name, number in cost.items():
        said.within(name, number, 0)
    said.near("cost.total_s", cost["total_s"], cost["wall_s"] + cost["planning_s"], relative=ROUND_OFF)
    said.equal("cost.krylov_iterations of a dense solver", truth["cost"]["krylov_iterations"], 0)
    return said


def film(wave):
    return cmath.rect(wave["amplitude_ratio"], math.radians(wave["phase_deg"]))


def documents(program):
    path = TOP / "cases" / f"{CASE}.toml"
    steady = program.json("solve", path, "--tolerance", "1e-2")
    truth = program.json("response", path, *QUESTIONS, "--solver", "reference", "--tolerance", CERTIFIED)
    result = program.json("response", path, *QUESTIONS, "--tolerance", TOLERANCE)
    yield f"response {CASE}", "response", result, functools.partial(audit, result, steady, truth, read_case(path))
