# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of `ehd convert --json`, each from the formulas of the textbook."""

import math

import textbook
from judge import Objections

SI = {"load_N_per_m": 1.1e5, "reduced_radius_m": 0.012, "reduced_modulus_Pa": 2.2e11, "speed_sum_m_per_s": 3.1,
      "viscosity_Pa_s": 0.021, "alpha_per_Pa": 2.3e-8}
LOGARITHMS = 1e-12  # the program converts through logarithms


def everything():
    w, R, E, u, eta, alpha = SI.values()
    M, L = textbook.moes_groups(w, R, E, u, eta, alpha)
    b, p_H = textbook.half_width(w, R, E), textbook.hertz_pressure(w, R, E)
    return SI | {"M": M, "L": L, "lambda": textbook.lambda_of(M), "alpha_p_H": alpha * p_H, "W": w / (E * R),
                 "U_mean": eta * u / 2 / (E * R), "G": alpha * E, "viscosity_times_speed_N_per_m": eta * u,
                 "hertz_pressure_Pa": p_H, "half_width_m": b, "film_moes_per_hertz": 8 * M / math.pi,
                 "film_m_per_hertz": b * b / R}


# What is given, and what it leaves open.
WAYS = [
    (tuple(SI), ()),
    (("M", "L"), ("W", "U_mean", "G", *SI, "viscosity_times_speed_N_per_m", "hertz_pressure_Pa", "half_width_m",
                  "film_m_per_hertz")),
    (("W", "U_mean", "G", "reduced_modulus_Pa", "reduced_radius_m"), ("viscosity_Pa_s", "speed_sum_m_per_s")),
]


def audit(document, known, left_open):
    said = Objections()
    numbers = {name: value for name, value in document.items() if name not in ("schema", "provenance")}
    said.equal("names", sorted(numbers), sorted(set(known) - set(left_open)))
    for name, value in numbers.items():
        said.near(name, value, known[name], relative=LOGARITHMS)
    return said


def documents(program):
    known = everything()
    for given, left_open in WAYS:
        document = program.json("convert", *(f"{name}={known[name]!r}" for name in given))
        yield f"convert {' '.join(given)}", "convert", document, lambda d=document, o=left_open: audit(d, known, o)
