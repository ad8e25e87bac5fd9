# SPDX-License-Identifier: GPL-3.0-or-later
"""Geometry and dry contact laws of a roller bearing, from the literature once more. SI, but laws printed in mm."""

import math
from math import pi

RACEWAYS = ("inner", "outer")


class Bearing:
    """A bearing case with what follows from it by the textbook."""

    def __init__(self, case):
        self.case = case
        stated, operation, material = case["bearing"], case["operation"], case["material"]
        self.Z, self.d_m, self.D = stated["rollers"], stated["pitch_diameter_m"], stated["roller_diameter_m"]
        self.length, self.clearance = stated["length_m"], stated["clearance_m"]
        self.roughness, self.thickness = stated.get("roughness_m"), stated.get("ring_thickness_m")
        self.load = operation["radial_load_N"]
        self.young, self.poisson = material["modulus_Pa"], material["poisson"]
        self.modulus = self.young / (1 - self.poisson**2)  # E' of two equal bodies
        gamma = self.D / self.d_m
        speed = operation["speed_rpm"] * 2 * pi / 60
        inner, outer = (speed, 0.0) if stated["rotating"] == "inner" else (0.0, speed)
        cage = (inner * (1 - gamma) + outer * (1 + gamma)) / 2
        mass = stated["density_kg_per_m3"] * pi * self.D**2 / 4 * self.length
        self.centrifugal = mass * self.d_m / 2 * cage**2
        self.turn = abs(inner - outer)  # of the rings against each other
        self.speed_sum = self.d_m / 2 * (1 - gamma**2) * self.turn
        self.raceway_radius = {"inner": (self.d_m - self.D) / 2, "outer": (self.d_m + self.D) / 2}
        self.radius = {"inner": 1 / (2 / self.D + 1 / self.raceway_radius["inner"]),
                       "outer": 1 / (2 / self.D - 1 / self.raceway_radius["outer"])}

    def azimuths(self):
        """In (-180, 180]."""
        first = self.case["bearing"].get("first_azimuth_deg", 0.0)
        turned = [(first + 360 * j / self.Z) % 360 for j in range(self.Z)]
        return [psi - 360 if psi > 180 else psi for psi in turned]

    def gap(self, x, y, azimuth):
        """The approach that the ring's place leaves to both contacts of a roller."""
        psi = math.radians(azimuth)
        return x * math.cos(psi) + y * math.sin(psi) - self.clearance / 2

    def half_width(self, raceway, force):
        return math.sqrt(8 * force / self.length * self.radius[raceway] / (pi * self.modulus))

    def dry_approach(self, law, raceway, force):
        return DRY_LAWS[law](self, raceway, force) if force > 0 else 0.0

    def compliance(self, law, raceway, force):
        """d(delta)/df by a central difference: its error is below 1e-9."""
        step = 1e-5 * force
        rise = self.dry_approach(law, raceway, force + step) - self.dry_approach(law, raceway, force - step)
        return rise / (2 * step)


def power_law_mm(factor):
    """f = factor l^(8/9) delta^(10/9) in N and mm, solved for delta [m]."""
    return lambda of, raceway, f: 1e-3 * (f / (factor * (1e3 * of.length) ** (8 / 9))) ** 0.9


def lundberg(of, raceway, f):
    """(2f/(pi l)) Sum((1-nu^2)/E) (2 ln 2 + 1/2 + ln(l/2b)), the sum over two equal bodies."""
    bodies = 2 * (1 - of.poisson**2) / of.young
    logarithm = 2 * math.log(2) + 0.5 + math.log(of.length / (2 * of.half_width(raceway, f)))
    return 2 * f / (pi * of.length) * bodies * logarithm


def tripp(of, raceway, f):
    """Each body its own length: 2R for a cylinder about its centre, the thickness for a ring on a rigid seat."""
    b = of.half_width(raceway, f)
    cylinder = math.log(4 * (of.D / 2) / b) - 0.5
    if raceway == "inner":
        other = math.log(4 * of.raceway_radius["inner"] / b) - 0.5
    else:
        other = math.log(2 * of.thickness / b) - of.poisson / (2 * (1 - of.poisson))
    return 2 * f / (pi * of.length) * (1 - of.poisson**2) / of.young * (cylinder + other)


def houpert(of, raceway, f):
    """f = 0.2723 d_m^-0.074 E l/(1-nu^2) delta^1.074 (inner), 0.27835 (t/(1+gamma))^-0.078 ... delta^1.078; mm, MPa."""
    stiffness = 1e-6 * of.young * 1e3 * of.length / (1 - of.poisson**2)
    if raceway == "inner":
        return 1e-3 * (f / (0.2723 * (1e3 * of.d_m) ** -0.074 * stiffness)) ** (1 / 1.074)
    ring = 1e3 * of.thickness / (1 + of.D / of.d_m)
    return 1e-3 * (f / (0.27835 * ring**-0.078 * stiffness)) ** (1 / 1.078)


DRY_LAWS = {
    "hertz": power_law_mm(8.06e4),
    "iso": power_law_mm(35948 * 2 ** (10 / 9)),
    "lundberg": lundberg,
    "tripp": tripp,
    "houpert": houpert,
}


def straight_line(x, y):
    """Least squares of y over x, by the normal equations about the means."""
    n = len(x)
    mean_x, mean_y = math.fsum(x) / n, math.fsum(y) / n
    squares = math.fsum((a - mean_x) ** 2 for a in x)
    slope = math.fsum((a - mean_x) * (b - mean_y) for a, b in zip(x, y, strict=True)) / squares
    start = mean_y - slope * mean_x
    residuals = [b - start - slope * a for a, b in zip(x, y, strict=True)]
    deviation = math.sqrt(math.fsum(r * r for r in residuals) / (n - 2))
    start_deviation = deviation * math.sqrt(1 / n + mean_x**2 / squares)
    return {"K_N_per_m": slope, "dF_N": start, "residual_N": max(map(abs, residuals)),
            "standard_deviation_N": deviation, "K_standard_deviation_N_per_m": deviation / math.sqrt(squares),
            "dF_standard_deviation_N": start_deviation,
            "correlation": -mean_x / math.sqrt(squares) * deviation / start_deviation}
