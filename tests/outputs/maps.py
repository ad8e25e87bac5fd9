# SPDX-License-Identifier: GPL-3.0-or-later
"""The maps over M and L, `ehd maps --output` and those of results.json: from the table of the atlas, the formulas of
textbook.py, and `ehd solve`."""

import functools
import math
import shutil

import textbook
from judge import ROUND_OFF, Objections
from program import TOP, read_csv, side_by_side

ATLAS = TOP / "cases" / "atlas" / "atlas.csv"
LOADS, LUBRICANTS = (1, 20, 1000), (0, 5, 30)  # a few points of every law set
FILM = {"film.minimum": "H_min", "film.central": "H_cen", "film.couette": "H_couette"}
MOES = ("Moes (Venner 1991)", "film.couette")
ALPHA = 2.2e-8  # of the atlas
SIX_DIGITS, TWO_DIGITS = 5.01e-6, 5.01e-2  # what printing leaves
TOLERANCE = 1e-4  # of fast in the report


class Atlas:
    """The rows of the atlas by laws, M, L and inlet, and the files that the program is given: these points alone."""

    def __init__(self, program):
        self.folder = program.folder / "few-cases"
        (self.folder / "atlas").mkdir(parents=True)
        for name in ("references.bib", "dry-steel.toml"):
            shutil.copy(TOP / "cases" / name, self.folder)
        self.rows = {}
        for row in read_csv(ATLAS):
            if row["M"] in LOADS and row["L"] in LUBRICANTS:
                self.rows[row["laws"], row["M"], row["L"], row["inlet"]] = row
        ids = {row["id"] for row in self.rows.values()}
        lines = ATLAS.read_text().splitlines(keepends=True)
        (self.folder / "atlas" / "atlas.csv").write_text(
            "".join(line for k, line in enumerate(lines) if k < 2 or line.split(",")[0] in ids))

    def film(self, of, quantity, inlet="flooded"):
        """(Hertz units, relative error), or None where it is not known."""
        row = self.rows.get((*of, inlet), {})
        name = FILM[quantity]
        return (row[name], row[f"{name}_error"]) if name in row else None

    def cost(self, of, quantity):
        """cut/flooded - 1 and its absolute error, or None."""
        cut, flooded = self.film(of, quantity, -4.0), self.film(of, quantity)
        if not cut or not flooded:
            return None
        return cut[0] / flooded[0] - 1, cut[0] / flooded[0] * (cut[1] + flooded[1])


def point_of(row):
    return row["laws"], row["M"], row["L"]


def hertz_pressure(M, L):
    return L * math.sqrt(M / (2 * math.pi)) / ALPHA


def formula_at(name, quantity, M, L):
    return textbook.moes_film(M, L) if (name, quantity) == MOES else textbook.power_law_film((name, quantity), M, L)


def audit_pressure(said, value, M, L, relative, unit=1.0):
    said.equal("has a pressure", value is not None, L > 0)
    if value is not None:
        said.near("p_H", value * unit, hertz_pressure(M, L), relative=relative)


def audit_formula_row(row, atlas):
    said, (laws, M, L) = Objections(), point_of(row)
    film = atlas.film((laws, M, L), row["quantity"])
    if film is None:
        return ["is no point of the atlas"]
    certified = film[0] * textbook.film_per_hertz_film(M)
    audit_pressure(said, row.get("p_H_GPa"), M, L, SIX_DIGITS, 1e9)
    said.equal("numerical_test", row["numerical_test"], "yes" if hertz_pressure(M, L) > 4e9 else "no")
    said.near("certified_moes", row["certified_moes"], certified, relative=1e-14)
    said.equal("certified_error", row["certified_error"], film[1])
    by_formula = formula_at(row["formula"], row["quantity"], M, L)
    said.near("formula_moes", row["formula_moes"], by_formula, relative=SIX_DIGITS)
    said.near("deviation", row["deviation"], by_formula / certified - 1, relative=SIX_DIGITS, absolute=ROUND_OFF)
    return said


def audit_inlet_row(row, atlas):
    said, (laws, M, L) = Objections(), point_of(row)
    film, cost = (known((laws, M, L), row["quantity"]) for known in (atlas.film, atlas.cost))
    if film is None or cost is None:
        return ["is no point of the atlas"]
    audit_pressure(said, row.get("p_H_GPa"), M, L, SIX_DIGITS, 1e9)
    said.near("flooded_moes", row["flooded_moes"], film[0] * textbook.film_per_hertz_film(M), relative=1e-14)
    said.near("cost", row["cost"], cost[0], relative=SIX_DIGITS, absolute=ROUND_OFF)
    said.near("cost_error", row["cost_error"], cost[1], relative=TWO_DIGITS)
    return said


def audit_fast(said, fast, atlas_films, alone):
    """`alone`: `ehd solve` of the same contact."""
    said.equal("fast: tolerance", fast["tolerance"], TOLERANCE)
    for count in ("newton_iterations", "krylov_iterations", "work_units", "nodes"):
        said.equal(f"fast: {count}", fast[count], alone["cost"][count])
    said.within("fast: wall_s", fast["wall_s"], 0)
    for name in ("minimum", "central"):
        film = alone["film"][name]
        said.near(f"fast: deviation_{name}", fast[f"deviation_{name}"],
                  film["hertz"] / atlas_films[f"film.{name}"][0] - 1, absolute=ROUND_OFF)
        said.equal(f"fast: deviation_{name}_stated", fast[f"deviation_{name}_stated"], film["error"])


def audit_figure(maps, atlas, alone):
    said = Objections()
    points = list(dict.fromkeys(key[:3] for key in atlas.rows))
    said.equal("M", maps["M"], sorted({M for _, M, _ in points}))
    said.equal("L", maps["L"], sorted({L for *_, L in points}))
    said.equal("points", [(point["laws"], point["M"], point["L"]) for point in maps["points"]], points)
    for point, of in zip(maps["points"], points, strict=True):
        _, M, L = of
        audit_pressure(said, point.get("p_H_Pa"), M, L, ROUND_OFF)
        films = {quantity: atlas.film(of, quantity) for quantity in FILM}
        for quantity, film in films.items():
            name = quantity.replace(".", "_")
            said.equal(f"{of}: {quantity} is there", f"{name}_moes" in point, film is not None)
            if film:
                said.near(f"{of}: {quantity}", point[f"{name}_moes"], film[0] * textbook.film_per_hertz_film(M),
                          relative=ROUND_OFF)
                said.equal(f"{of}: {quantity}: error", point[f"{name}_error"], film[1])
        for name in ("minimum", "central"):
            cost = atlas.cost(of, f"film.{name}")
            said.equal(f"{of}: cost is there", f"inlet_cost_{name}" in point, cost is not None)
            if cost:
                said.near(f"{of}: inlet_cost_{name}", point[f"inlet_cost_{name}"], cost[0], absolute=ROUND_OFF)
        known = {law for law in (MOES, *(textbook.POWER_LAWS if L else ())) if films[law[1]]}
        said.equal(f"{of}: formulas", {(one["name"], one["quantity"]) for one in point["formulas"]}, known)
        for one in point["formulas"]:
            moes = formula_at(one["name"], one["quantity"], M, L)
            said.near(f"{of}: {one['name']}", one["moes"], moes, relative=1e-10)
            certified = films[one["quantity"]][0] * textbook.film_per_hertz_film(M)
            said.near(f"{of}: {one['name']}: deviation", one["deviation"], moes / certified - 1, absolute=1e-10)
        if "fast" in point:
            audit_fast(said, point["fast"], films, alone[of])
    return said


def case_of(of):
    laws, M, L = of
    return f"atlas-{laws}-m{M:g}-l{L:g}-flooded"


def solves(program, points):
    """`ehd solve` of points of the atlas, as the report asks for them."""
    calls = [functools.partial(program.json, "solve", TOP / "cases" / "atlas" / f"{case_of(of)}.toml", "--tolerance",
                               TOLERANCE, "--quantity", "film.minimum", "--quantity", "film.central")
             for of in points]
    return dict(zip(points, side_by_side(calls), strict=True))


def documents(program):
    atlas, folder = Atlas(program), program.folder / "maps"
    program.run("maps", "--output", folder, cases=atlas.folder)
    for table, kind, audit in (("formula_maps.csv", "formula-map", audit_formula_row),
                               ("inlet_maps.csv", "inlet-map", audit_inlet_row)):
        for k, row in enumerate(read_csv(folder / table)):
            yield f"{table}, row {k}", kind, row, functools.partial(audit, row, atlas)
    # Other topics of the rung miss the files that are not there: exit code 1.
    program.run("verify", "--quick", "--rung", "10", "--output", folder, cases=atlas.folder, allowed=(0, 1))
    maps = program.read_json(folder / "results.json")["figures"]["maps"]
    fast = [point_of(point) for point in maps["points"] if "fast" in point]
    yield "maps of the report", "map-figure", maps, functools.partial(audit_figure, maps, atlas, solves(program, fast))
