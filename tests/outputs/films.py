# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of `ehd export films --format json`: its coefficients from `ehd solve` at the nodes of its polynomials, its
errors from solves elsewhere."""

import functools
import json
import math

import textbook
from judge import ROUND_OFF, Objections
from program import TOP, read_case, side_by_side, to_toml

CASE = "own-moes-20-10"
M_RANGE, L_RANGE, BENDS = (5.0, 20.0), (5.0, 10.0), (1.0, 7.0)  # M is split at the bends
TOLERANCE, SHARE = 1e-2, 0.2  # each solve is asked for this share of the tolerance
DEGREE, MOST_DEGREE = 4, 60
# Coefficients of a logarithm, from the same solves: what the linear systems leave.
COEFFICIENTS_KNOWN = 1e-12
FILMS = {"film.minimum": 0.0, "film.central": 0.0, "film.couette": 0.0, "film.offset": textbook.DRY_OFFSET}
ELSEWHERE = [(-0.8, 0.3), (-0.3, -0.75), (0.15, 0.6), (0.7, -0.2)]  # in every panel


def leja(count, among):
    """1, -1, 0 and so on: each time the candidate whose product of distances to all before is largest. Of x and -x
    either would do: rounding decides, and so the sums are added up in the order of the points."""
    cells = 20 * among
    candidates = [math.sin(math.pi * (0.5 - k / cells)) for k in range(cells + 1)]
    logarithms, points = [0.0] * len(candidates), [1.0]
    while len(points) < count:
        for k, x in enumerate(candidates):
            logarithms[k] += math.log(abs(x - points[-1])) if x != points[-1] else -math.inf
        points.append(candidates[logarithms.index(max(logarithms))])
    return points


def solved(matrix, right):
    """x of matrix x = right, by Gauss with pivots; `right` a list of rows."""
    n = len(matrix)
    rows = [list(matrix[i]) + list(right[i]) for i in range(n)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(n):
            if i != k:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    return [[value / rows[i][i] for value in rows[i][n:]] for i in range(n)]


def transposed(rows):
    return [list(column) for column in zip(*rows, strict=True)]


def basis(degree, t):
    values = [1.0, t]
    while len(values) <= degree:
        values.append(2 * t * values[-1] - values[-2])
    return values[:degree + 1]


class Solves:
    """Contacts of the case's oil over M and L: the four films with their errors."""

    def __init__(self, program, case):
        self.program, self.case, self.known = program, case, {}

    def ask(self, M, L):
        name = f"films-{M!r}-{L!r}"
        path = self.program.write(f"{name}.toml", to_toml(self.case | {"id": name, "moes": {"M": M, "L": L}}))
        these = (word for name in FILMS for word in ("--quantity", name))
        films = self.program.json("solve", path, "--tolerance", SHARE * TOLERANCE, *these)["film"]
        return {f"film.{key}": (film["hertz"], film["error"]) for key, film in films.items()}

    def at(self, places):
        new = [place for place in dict.fromkeys(places) if place not in self.known]
        answers = side_by_side([functools.partial(self.ask, *place) for place in new])
        self.known |= dict(zip(new, answers, strict=True))
        return [self.known[place] for place in places]


def place(panel_M, x, y):
    """M and L at a place of the square."""
    a, b = math.log(panel_M[0]), math.log(panel_M[1])
    c, d = math.log1p(L_RANGE[0]), math.log1p(L_RANGE[1])
    M, L = math.exp(a + (b - a) * (x + 1) / 2), math.expm1(c + (d - c) * (y + 1) / 2)
    return min(max(M, panel_M[0]), panel_M[1]), min(max(L, L_RANGE[0]), L_RANGE[1])


def panel_ranges():
    ends = [M_RANGE[0], *(M for M in BENDS if M_RANGE[0] < M < M_RANGE[1]), M_RANGE[1]]
    return list(zip(ends, ends[1:], strict=False))


def true_coefficients(panel_M, nodes, solves):
    """c_ij of each film, by V C V^T = ln(film - shift) at the nodes."""
    V = [basis(DEGREE, x) for x in nodes]
    films = solves.at([place(panel_M, x, y) for x in nodes for y in nodes])
    n = len(nodes)
    return {name: transposed(solved(V, transposed(solved(V, [
        [math.log(films[i * n + j][name][0] - shift) for j in range(n)] for i in range(n)]))))
        for name, shift in FILMS.items()}


def film_at(panel, name, shift, x, y):
    T_x, T_y = basis(DEGREE, x), basis(DEGREE, y)
    return shift + math.exp(math.fsum(c * a * b for row, a in zip(panel["coefficients"][name], T_x, strict=True)
                                      for c, b in zip(row, T_y, strict=True)))


def unit_of(name, value):
    """Of an error: the film, for the offset its rise above the dry contact, at least 1."""
    return max(1.0, value - FILMS[name]) if name == "film.offset" else value


def audit(table, case, solves, truths, nodes):
    said = Objections()
    said.equal("version", table["version"], case["version"])
    said.within("provenance.cores", table["provenance"]["cores"], 1)
    for key in ("alpha_per_Pa", "z", "p0_Pa"):
        said.equal(f"lubricant.{key}", table["lubricant"][key], case["lubricant"][key])
    said.equal("inlet", table["inlet"], case["domain"]["inlet"])
    said.equal("range", table["range"], {"M": list(M_RANGE), "L": list(L_RANGE)})
    said.equal("tolerance", table["tolerance"], TOLERANCE)
    said.equal("panels", len(table["panels"]), len(panel_ranges()))
    for panel, M, truth in zip(table["panels"], panel_ranges(), truths, strict=True):
        said.equal(f"panel {M}: L", panel["L"], list(L_RANGE))
        said.equal(f"panel {M}: map", panel["map"], "even")
        for edge, end in zip(("low", "high"), M, strict=True):
            said.equal(f"panel {M}: coefficients of edge {edge}", len(panel["edges"][edge]), 1)
            said.near(f"panel {M}: edge {edge}", panel["edges"][edge][0], math.log(end), absolute=ROUND_OFF)
        said.equal(f"panel {M}: degrees", panel["degrees"], {"M": DEGREE, "L": DEGREE})
        for name, rows in panel["coefficients"].items():
            for i, row in enumerate(rows):
                for j, c in enumerate(row):
                    said.near(f"panel {M}: {name}[{i}][{j}]", c, truth[name][i][j], absolute=COEFFICIENTS_KNOWN)
    for name, shift in FILMS.items():
        film = table["films"][name]
        said.near(f"{name}: shift", film["shift"], shift, relative=ROUND_OFF)
        said.near(f"{name}: stated_error", film["stated_error"], 3 * film["found_error"] + film["solve_error"],
                  relative=ROUND_OFF)
        said.within(f"{name}: stated_error", film["stated_error"], 0, TOLERANCE)
        worst = max(films[name][1] / (unit_of(name, films[name][0]) if name == "film.offset" else 1)
                    for films in solves.known.values())
        said.within(f"{name}: solve_error", film["solve_error"], (1 - 0.02) * worst, 1.5 * worst)
        for panel, M in zip(table["panels"], panel_ranges(), strict=True):
            for x, y in ELSEWHERE:
                true = solves.at([place(M, x, y)])[0][name][0]
                said.near(f"{name} at {x}, {y} of panel {M}", film_at(panel, name, shift, x, y), true,
                          absolute=3 * film["found_error"] * unit_of(name, true))
    said.equal("cost.solves", table["cost"]["solves"], len(truths) * len(nodes) ** 2)
    said.equal("cost.held_out", table["cost"]["held_out"], len(truths) * 32)  # at once enough, the fewest
    return said


def documents(program):
    path = TOP / "cases" / f"{CASE}.toml"
    case = {key: value for key, value in read_case(path).items() if key != "expect"}
    table = json.loads(program.run("export", "films", path, "--M", "{}:{}".format(*M_RANGE), "--L",
                                   "{}:{}".format(*L_RANGE), "--tolerance", TOLERANCE, "--format", "json"))
    solves, nodes = Solves(program, case), leja(DEGREE + 1, MOST_DEGREE + 1)
    truths = [true_coefficients(M, nodes, solves) for M in panel_ranges()]
    solves.at([place(M, x, y) for M in panel_ranges() for x, y in ELSEWHERE])
    yield "export films", "films", table, functools.partial(audit, table, case, solves, truths, nodes)
