#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A deliberately simple solver of the line contact, to start your own from: finite differences on an equal grid and
Newton's method with a dense matrix (NumPy).

    line_contact.py CASE.json OUT.json TOLERANCE      for ehd compare --external, {case} {out} {tolerance}

CASE.json is what `ehd cases ID --json` has under "problem". Second-order upwind differences; the film stated is that of
the finest grid; its stated error is the change from the grid with half the nodes. A flooded inlet is cut at X = -8, and
the change from a cut at X = -5.7 is added to the error. Exit code: 0 the tolerance is met, 1 it is not."""
import json
import sys
import time

import numpy as np


def laws(problem):
    """ln(eta/eta_0) and rho/rho_0 with their slopes, for an oil whose alpha p_H is `share` of the case's."""
    v, d = problem["viscosity"], problem["density"]
    if v["law"] not in ("isoviscous", "barus", "roelands"):
        sys.exit("line_contact: the viscosity law is unknown; required is isoviscous, barus or roelands")

    def log_viscosity(P, share):
        if v["law"] == "isoviscous":
            return 0 * P, 0 * P
        a = share * v["alpha_p_H"]
        if v["law"] == "barus":
            return a * P, a + 0 * P
        p0, z = v["p0_over_p_H"], v["z"]
        return a * p0 / z * ((1 + P / p0) ** z - 1), a * (1 + P / p0) ** (z - 1)

    def density(P):
        if d["law"] == "incompressible":
            return 1 + 0 * P, 0 * P
        a, c = d["density_a"], d["density_c"]
        return 1 + a * P / (1 + c * P), a / (1 + c * P) ** 2

    return log_viscosity, density


def elastic_matrix(n, h):
    """-(1/pi) Int ln|X_i - S| dS over the cell of each node j."""
    edge = (np.arange(-n, n + 2) - 0.5) * h
    integral = np.diff(edge * np.log(np.abs(edge)) - edge)
    i = np.arange(n + 1)
    return -integral[i[:, None] - i[None, :] + n] / np.pi


def upwind(v):
    """On the faces: 1.5 v_i - 0.5 v_(i-1), the mean of two nodes on the first."""
    on_faces = 1.5 * v[:-1]
    on_faces[1:] -= 0.5 * v[:-2]
    on_faces[0] = (v[0] + v[1]) / 2
    return on_faces


def newton(X, P, H_0, lam, share, problem):
    """Pressure and offset H_0 on the grid X, from a start. P is 0 behind the exit, whose node Newton's method moves."""
    log_viscosity, density = laws(problem)
    n, h = len(X) - 1, X[1] - X[0]
    K = elastic_matrix(n, h)
    inside, faces = P > 0, np.arange(n)
    for _ in range(60):
        eta, eta_P = log_viscosity(P, share)
        rho, rho_P = density(P)
        H = H_0 + X ** 2 / 2 + K @ P
        f = rho * H  # the flow by the wedge, and its derivatives to P (a matrix) and H_0
        f_P = rho[:, None] * K + np.diag(rho_P * H)
        e = rho * H ** 3 * np.exp(-eta) / lam  # epsilon = rho H^3/(eta lambda)
        e_P = (3 * e / H)[:, None] * K + np.diag(e * (rho_P / rho - eta_P))
        slope = np.diff(P) / h
        mean = (e[1:] + e[:-1]) / 2  # on the n faces
        q_P = slope[:, None] * (e_P[1:] + e_P[:-1]) / 2
        q_P[faces, faces + 1] += mean / h
        q_P[faces, faces] -= mean / h
        q_0 = slope * (3 * e[1:] / H[1:] + 3 * e[:-1] / H[:-1]) / 2
        F, F_P, F_0 = mean * slope - upwind(f), q_P - upwind(f_P), q_0 - upwind(rho)
        R, R_P, R_0 = np.diff(F), np.diff(F_P, axis=0), np.diff(F_0)  # mass balance of nodes 1 ... n-1
        # The film ruptures at the first node without pressure behind the centre; one more node joins if flow enters it.
        last = n - 1
        while last > 1 and not inside[last]:
            last -= 1
        if last + 1 < n and R[last] > 0:
            last += 1
        free = np.arange(1, last + 1)
        A = np.zeros((last + 1, last + 1))
        A[:last, :last], A[:last, last] = R_P[:last][:, free], R_0[:last]
        A[last, :last] = h
        b = -np.append(R[:last], h * P.sum() - np.pi / 2)
        step = np.linalg.solve(A, b)
        size = np.abs(step[:last]).max()
        damping = min(1.0, 0.3 / size)
        P = P.copy()
        P[free] += damping * step[:last]
        H_0 += damping * step[last]
        P[last + 1:] = 0
        behind = np.flatnonzero((P < 0) & (X > 0))
        if len(behind):
            P[behind[0]:] = 0
        P = np.maximum(P, 0)
        inside = P > 0
        if size < 1e-9:
            return P, H_0, H_0 + X ** 2 / 2 + K @ P
    raise ArithmeticError("Newton's method did not converge")


def first_start(X, lam, problem):
    """From a thick film of an oil without pressure dependence to the case, step by step."""
    P, H_0 = np.sqrt(np.maximum(1 - X ** 2, 0)), 1.0
    first = max(lam, 0.5)
    for share in np.linspace(0, 1, 12):
        P, H_0, H = newton(X, P, H_0, first * (lam / first) ** share, share, problem)
    return P, H_0, H


def solve(problem, begin, n, start=None):
    X = np.linspace(begin, 1.6, n + 1)
    lam = problem["groups"]["lambda"]
    if start is None:
        return (X, *first_start(X, lam, problem))
    old, P, H_0 = start[0], start[1], start[2]
    return (X, *newton(X, np.interp(X, old, P), H_0, lam, 1.0, problem))


def films(X, P, H_0, H):
    at = H[np.abs(X) < 1.3].argmin() + np.flatnonzero(np.abs(X) < 1.3)[0]
    a, b, c = H[at - 1], H[at], H[at + 1]
    near = np.abs(X).argsort()[:4]
    return b - (a - c) ** 2 / (8 * (a - 2 * b + c)), np.polyval(np.polyfit(X[near], H[near], 3), 0.0)


def main(case_file, out_file, tolerance):
    problem = json.load(open(case_file))
    began = time.perf_counter()
    flooded = problem["inlet"] == "flooded"
    begin = -8.0 if flooded else problem["inlet"]
    n, result, error, last = 128, None, np.inf, None
    while n <= 1024 and error > tolerance:
        result = solve(problem, begin, n, result)
        now = np.array(films(*result))
        if last is not None:
            error = np.abs(now / last - 1).max()
        n, last = 2 * n, now
    if flooded:
        shorter = np.array(films(*solve(problem, begin / np.sqrt(2), n // 2)))
        error += np.abs(now / shorter - 1).max()
    profile = out_file.rsplit(".", 1)[0] + ".csv"
    np.savetxt(profile, np.column_stack((result[0], result[1], result[3])), delimiter=",", header="X,P,H", comments="")
    json.dump({"schema": "ehd-submission-1", "solver": {"name": "line_contact.py", "version": "1"}, "results": [
        {"case": problem["case"], "version": problem["version"], "scaling": "hertz", "film.minimum": now[0],
         "film.central": now[1], "film.offset": result[2], "stated_error": min(error, 1.0),
         "wall_s": time.perf_counter() - began, "profile": profile.rsplit("/", 1)[-1]}]}, open(out_file, "w"), indent=2)
    return 0 if error <= tolerance else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2], float(sys.argv[3])))
