# SPDX-License-Identifier: GPL-3.0-or-later
"""Formulas of the literature, written down here once more: nothing is shared with the program.

Units are SI. w: load per length; R, E: reduced radius and modulus (2/E' = (1-nu_1^2)/E_1 + (1-nu_2^2)/E_2).
"""

import math
from math import pi

DRY_OFFSET = -(0.25 + math.log(2) / 2)  # H_0 of Hertz' contact


def half_width(w, R, E):
    return math.sqrt(8 * w * R / (pi * E))


def hertz_pressure(w, R, E):
    return 2 * w / (pi * half_width(w, R, E))


def moes_groups(w, R, E, speed_sum, viscosity, alpha):
    """M and L with the SUM of the surface speeds."""
    U = viscosity * speed_sum / (E * R)
    return w / (E * R) / math.sqrt(U), alpha * E * U**0.25


def lambda_of(M):
    return 3 * pi**2 / (8 * M**2)


def alpha_p_hertz(M, L):
    return L * math.sqrt(M / (2 * pi))


def film_per_hertz_film(M):
    """Moes' film over Hertz': H_Moes = 8M/pi H."""
    return 8 * M / pi


def moes_film(M, L):
    """The central film after Moes, four asymptotes joined (Venner 1991), in his units."""
    rigid, elastic = 3 / M, 2.621 * M**-0.2
    s = (7 + 8 * math.exp(-2 * elastic / rigid)) / 5
    isoviscous = (rigid ** (7 / 3) + elastic ** (7 / 3)) ** (3 * s / 7)
    if L == 0:
        return isoviscous ** (1 / s)
    viscous, both = 1.287 * L ** (2 / 3), 1.311 * M**-0.125 * L**0.75
    return (isoviscous + (viscous**-3.5 + both**-3.5) ** (-2 * s / 7)) ** (1 / s)


# h/R = c G^a U^u W^w with the mean speed in U; which film.
POWER_LAWS = {
    ("Dowson & Higginson 1966", "film.minimum"): (1.6, 0.6, 0.7, -0.13),
    ("Dowson & Higginson 1977", "film.minimum"): (2.65, 0.54, 0.7, -0.13),
    ("Hamrock & Jacobson 1984", "film.minimum"): (3.07, 0.57, 0.71, -0.11),
    ("Pan & Hamrock 1989", "film.minimum"): (1.714, 0.568, 0.694, -0.128),
    ("Dowson & Toyoda 1978", "film.central"): (3.06, 0.56, 0.69, -0.1),
    ("Pan & Hamrock 1989", "film.central"): (2.922, 0.47, 0.692, -0.166)}


def power_law_film(law, M, L, G=5000.0):
    """A power law's film in Moes' units, (h/R) (2U)^(-1/2)."""
    c, a, u, w = POWER_LAWS[law]
    U = (L / G) ** 4 / 2
    return c * G**a * U**u * (M * math.sqrt(2 * U)) ** w / math.sqrt(2 * U)


def approach(w, R, E, offset, datum):
    return 4 * w / (pi * E) * (math.log(datum / half_width(w, R, E)) - 2 * offset)


def ln_roelands(p, alpha, z, p0):
    """ln(eta/eta_0) from Roelands' exponent z and alpha = z (ln eta_0 + 9.67)/p_0."""
    return alpha * p0 / z * ((1 + p / p0) ** z - 1)


def dowson_higginson(p):
    """rho/rho_0."""
    return (5.9e8 + 1.34 * p) / (5.9e8 + p)


def deflection(X, P, at):
    """-(1/pi) Int P(X') ln|at - X'| dX' of the pressure that is linear between its nodes."""
    def first(s):  # antiderivative of ln|s|
        return s * math.log(abs(s)) - s if s else 0.0

    def second(s):  # antiderivative of s ln|s|
        return s * s / 2 * math.log(abs(s)) - s * s / 4 if s else 0.0
    total = 0.0
    for x0, x1, p0, p1 in zip(X, X[1:], P, P[1:], strict=False):
        slope = (p1 - p0) / (x1 - x0)
        total += (p0 + slope * (at - x0)) * (first(x1 - at) - first(x0 - at))
        total += slope * (second(x1 - at) - second(x0 - at))
    return -total / pi


def trapezoid(x, y):
    return sum((b - a) * (c + d) / 2 for a, b, c, d in zip(x, x[1:], y, y[1:], strict=False))


def walther(cold, hot, T):
    """Kinematic viscosity [mm2/s] at T degrees C by those at 40 and 100 (ASTM D341), found by bisection."""
    def Z(v):
        return v + 0.7 + math.exp(-1.47 - 1.84 * v - 0.51 * v * v)
    def y(v):
        return math.log10(math.log10(Z(v)))
    x, x1, x2 = (math.log10(t + 273.15) for t in (T, 40, 100))
    wanted = 10 ** 10 ** (y(cold) + (y(hot) - y(cold)) * (x - x1) / (x2 - x1))
    low, high = 0.2, 1e8
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if Z(middle) < wanted else (low, middle)
    return high


# ASTM D2270: ranges of the viscosity at 100 degrees C with the coefficients of L and H. Those that the audit meets.
D2270 = [(2.0, 3.8, (1.14673, 1.7576, -0.109), (0.84155, 1.5521, -0.077)),
         (7.7, 9.0, (0.41858, 16.1558, -56.04), (0.05794, 10.5156, -28.24))]


def viscosity_index(cold, hot):
    L, H = next(((L, H) for low, high, L, H in D2270 if low <= hot < high), (None, None))
    if L is None:
        raise ValueError(f"no coefficients for {hot} mm2/s")
    L, H = ((a * hot + b) * hot + c for a, b, c in (L, H))
    if cold >= H:
        return 100 * (L - cold) / (L - H)
    return 100 + (10 ** (math.log10(H / cold) / math.log10(hot)) - 1) / 0.00715
