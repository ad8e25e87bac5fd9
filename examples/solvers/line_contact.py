#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A deliberately simple solver of the line contact, to start your own from: finite differences on an equal grid and
Newton's method with a dense matrix (NumPy). Its entries are complex steps: the imaginary part of F(u + i e)/e is F'(u).

    line_contact.py CASE.json OUT.json TOLERANCE      for ehd compare --external, {case} {out} {tolerance}

CASE.json is what `ehd cases ID --json` has under "problem". Second-order upwind differences; the film stated is that of
the finest grid; its stated error is the change from the grid with half the nodes. A flooded inlet is cut at X = -8, and
the change from a cut at X = -5.7 is added to the error. Exit code: 0 the tolerance is met, 1 it is not, 2 the case
cannot be read or is not for this program."""
import json
import sys
import time

import numpy as np

TINY = 1e-30  # the complex step


def refuse(why):
    print("line_contact:", why, file=sys.stderr)  # the last line of standard error is what ehd compare shows
    sys.exit(2)


def laws(problem, P, share):
    """eta_0/eta and rho/rho_0 of an oil whose alpha p_H is `share` of the case's."""
    v, d = problem["viscosity"], problem["density"]
    if v["law"] not in ("isoviscous", "barus", "roelands"):
        refuse("the viscosity law is unknown; required is isoviscous, barus or roelands")
    ln_eta = 0 * P if v["law"] == "isoviscous" else share * v["alpha_p_H"] * P
    if v["law"] == "roelands":
        p0, z = v["p0_over_p_H"], v["z"]
        ln_eta = share * v["alpha_p_H"] * p0 / z * ((1 + P / p0) ** z - 1)
    compressed = 0 * P if d["law"] == "incompressible" else d["density_a"] * P / (1 + d["density_c"] * P)
    return np.exp(-ln_eta), 1 + compressed


def flow(P, H, fluidity, rho, h, lam):
    """rho H^3/(eta lambda) P' - rho H on the faces between the nodes: the film's part at 1.5 f_i - 0.5 f_(i-1)."""
    e, f = fluidity * rho * H * H * H / lam, rho * H
    upwind = 1.5 * f[:-1]
    upwind[1:] -= 0.5 * f[:-2]
    upwind[0] = (f[0] + f[1]) / 2
    return (e[1:] + e[:-1]) / 2 * np.diff(P, axis=0) / h - upwind


def newton(problem, X, P, H_0, lam, share):
    """Pressure and offset H_0 on the grid X, from a start. P is 0 behind the exit, whose node Newton's method moves."""
    n, h = len(X) - 1, X[1] - X[0]
    edge = (np.arange(-n, n + 2) - 0.5) * h  # film = H_0 + X^2/2 + K P: -(1/pi) Int ln|X_i - S| dS over each cell
    cell = np.diff(edge * np.log(np.abs(edge)) - edge)
    K = -cell[np.arange(n + 1)[:, None] - np.arange(n + 1) + n] / np.pi
    for _ in range(60):
        H = H_0 + X ** 2 / 2 + K @ P
        oil = laws(problem, P + 1j * TINY, share)
        balance = np.diff(flow(P, H, oil[0].real, oil[1].real, h, lam))  # of the mass, at nodes 1 ... n-1
        last = np.flatnonzero(P[1:n] > 0)[-1] + 1  # the last node under pressure; the next one joins if flow enters it
        last += last < n - 1 and balance[last] > 0
        free = np.arange(1, last + 1)  # a column for each of these pressures, and one for H_0
        unit = np.eye(n + 1)[:, 1:last + 2] * (np.arange(last + 1) < last)
        changed = [v.real[:, None] + 1j * v.imag[:, None] * unit for v in (P + 1j * TINY, *oil)]
        changed.insert(1, H[:, None] + 1j * TINY * np.column_stack((K[:, free], np.ones(n + 1))))
        A = np.diff(flow(*changed, h, lam), axis=0).imag / TINY
        A = np.vstack((A[:last], np.append(h * np.ones(last), 0)))
        step = np.linalg.solve(A, -np.append(balance[:last], h * P.sum() - np.pi / 2))
        size = np.abs(step[:last]).max()
        step *= min(1.0, 0.3 / size)
        P, H_0 = np.append(0, np.append(P[free] + step[:last], np.zeros(n - last))), H_0 + step[last]
        P[(P < 0).cumsum() * (X > 0) > 0] = 0  # behind the first negative one after the centre
        P = np.maximum(P, 0)
        if size < 1e-9:
            return P, H_0, H_0 + X ** 2 / 2 + K @ P
    raise ArithmeticError("Newton's method did not converge")


def solve(problem, begin, n, coarser=None):
    """On n intervals. Without a coarser result, step by step from a thick film of an isoviscous oil."""
    X, lam = np.linspace(begin, 1.6, n + 1), problem["groups"]["lambda"]
    if coarser:
        return (X, *newton(problem, X, np.interp(X, coarser[0], coarser[1]), coarser[2], lam, 1.0))
    P, H_0, first = np.sqrt(np.maximum(1 - X ** 2, 0)), 1.0, max(lam, 0.5)
    for share in np.linspace(0, 1, 12):
        P, H_0, H = newton(problem, X, P, H_0, first * (lam / first) ** share, share)
    return X, P, H_0, H


def films(X, P, H_0, H):
    """The smallest one, by a parabola, and that at X = 0, by a cubic."""
    at = np.where(np.abs(X) < 1.3, H, np.inf).argmin()
    a, b, c = H[at - 1:at + 2]
    near = np.abs(X).argsort()[:4]
    return np.array((b - (a - c) ** 2 / (8 * (a - 2 * b + c)), np.polyval(np.polyfit(X[near], H[near], 3), 0.0)))


def main(case_file, out_file, tolerance):
    try:
        problem, began = json.load(open(case_file)), time.perf_counter()
    except (OSError, ValueError) as failure:
        refuse(f"the case cannot be read: {failure}")
    flooded = problem["inlet"] == "flooded"
    begin, n, error = -8.0 if flooded else problem["inlet"], 128, np.inf
    result = solve(problem, begin, n)
    while n < 1024 and error > tolerance:
        n, before = 2 * n, films(*result)
        result = solve(problem, begin, n, result)
        error = np.abs(films(*result) / before - 1).max()
    if result[3].min() <= 0:
        raise ArithmeticError("the film is not positive, though it solves the equations")
    smallest, central = films(*result)
    if flooded:
        error += np.abs(films(*result) / films(*solve(problem, begin / np.sqrt(2), n)) - 1).max()
    profile = out_file.rsplit(".", 1)[0] + ".csv"
    np.savetxt(profile, np.column_stack((result[0], result[1], result[3])), delimiter=",", header="X,P,H", comments="")
    json.dump({"schema": "ehd-submission-1", "solver": {"name": "line_contact.py", "version": "1"}, "results": [
        {"case": problem["case"], "version": problem["version"], "scaling": "hertz", "film.minimum": smallest,
         "film.central": central, "film.offset": result[2], "stated_error": min(error, 1.0),
         "wall_s": time.perf_counter() - began, "profile": profile.rsplit("/", 1)[-1]}]}, open(out_file, "w"), indent=2)
    return 0 if error <= tolerance else 1


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1], sys.argv[2], float(sys.argv[3])))
    except ArithmeticError as failure:
        sys.exit(f"line_contact: {failure}")  # exit code 1
