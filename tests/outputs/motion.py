# SPDX-License-Identifier: GPL-3.0-or-later
"""A bearing in small motion, `ehd bearing --dynamic --json`: from the response of each contact, the mass of a roller,
and the directions of the rollers."""

import functools
import math

import bearing
import textbook
from judge import ROUND_OFF, Objections
from program import read_case, side_by_side, to_toml
from textbook_bearing import DRY_LAWS, RACEWAYS, Bearing

FAST_HZ = 5000.0  # Omega near 0.2: the contacts answer with a kappa of their own, not with that of slow motion
LAWS = ["hertz", "ehd-linear", "ehd"]
# A response is asked for 1e-4, and here too. Below the lightest contact whose response was solved, the program leads
# over to the rigid roller: the table of contacts in motion states about 1 % there.
CONTACT_KNOWN, LIGHT_CONTACT_KNOWN = 2e-3, 1e-2
OWN_ERROR = 2e-4  # of the responses that are asked for here
# Responses beside those of a curve: further looks at light contacts, a few a raceway.
EXTRA = 8
# Largest error of a ring that `ehd bearing` accepts.
RING_KNOWN = 0.02


class Responses:
    """kappa of the contacts of one raceway over the force: the answer of `ehd response` to one force at a time."""

    def __init__(self, program, of, raceway, forces, frequency_Hz=None):
        self.program, self.of, self.raceway, self.frequency_Hz = program, of, raceway, frequency_Hz
        forces = sorted(forces)
        self.known = dict(zip(forces, side_by_side([functools.partial(self.ask, f) for f in forces]), strict=True))

    def ask(self, force):
        name, lubricant = f"motion-{self.raceway}-{force!r}", dict(self.of.case["lubricant"])
        path = self.program.write(f"{name}.toml", to_toml({
            "id": name, "version": 1, "title": "A contact of the bearing", "source": "own",
            "conditions": {"load_N_per_m": force / self.of.length, "reduced_radius_m": self.of.radius[self.raceway],
                           "reduced_modulus_Pa": self.of.modulus, "speed_sum_m_per_s": self.of.speed_sum,
                           "viscosity_Pa_s": lubricant.pop("viscosity_Pa_s")},
            "lubricant": lubricant, "domain": {"inlet": "flooded"}}))
        asked = ["--frequency", self.frequency_Hz] if self.frequency_Hz else []
        return self.program.json("response", path, "--tolerance", "1e-4", *asked)

    def half_width(self, force):
        return textbook.half_width(force / self.of.length, self.of.radius[self.raceway], self.of.modulus)

    def slow(self, force, datum):
        """kappa_0 and kappa_1 with the datum x_0, a compliance in series: 1/kappa + ln(x_0/b)/pi."""
        slow = self.known[force]["slow"]
        kappa_0, kappa_1 = slow["kappa_0"]["value"], slow["kappa_1"]["value"]
        series = 1 / (1 / kappa_0 + math.log(datum / self.half_width(force)) / math.pi)
        return series, kappa_1 * (series / kappa_0) ** 2

    def stiffness_damping(self, force, datum):
        """Of the contact in slow motion, N/m and N s/m: l E'/4 (kappa_0 + i Omega kappa_1), Omega = omega b/u_m."""
        unit = self.of.length * self.of.modulus / 4
        kappa_0, kappa_1 = self.slow(force, datum)
        return unit * kappa_0, unit * kappa_1 * self.half_width(force) / (self.of.speed_sum / 2)

    def complex_stiffness(self, force, datum):
        """Of the contact at the frequency."""
        at = self.known[force]["response"][0]["kappa"]
        chi = 1 / complex(at["real"], at["imag"]) + math.log(datum / self.half_width(force)) / math.pi
        return self.of.length * self.of.modulus / 4 / chi


def contact_motion(law, raceway, force, result, of, responses, frequency_Hz):
    """Stiffness and damping of a contact; damping is None where the law knows none."""
    if force <= 0:
        return 0.0, None
    if law in DRY_LAWS:
        return 1 / of.compliance(law, raceway, force), None
    if law == bearing.LINE:
        return result["fit"][raceway]["K_N_per_m"], None
    datum = result["datum"][f"{raceway}_x0_m"]
    if frequency_Hz == 0:
        return responses[raceway].stiffness_damping(force, datum)
    K = responses[raceway].complex_stiffness(force, datum)
    return K.real, K.imag / (2 * math.pi * frequency_Hz)


def through_roller(inner, outer, mass, frequency_Hz):
    """What a roller between two contacts transmits: stiffness, and damping where both contacts have one."""
    if not inner[0] or not outer[0]:
        return 0.0, 0.0
    omega = 2 * math.pi * frequency_Hz
    if omega == 0:
        share = outer[0] / (inner[0] + outer[0])  # of the approach that is the inner contact's
        stiffness = share * inner[0]
        return stiffness, share**2 * (inner[1] or 0) + (1 - share) ** 2 * (outer[1] or 0)
    K_i, K_o = (complex(one[0], omega * (one[1] or 0)) for one in (inner, outer))
    transmitted = K_i * (K_o - mass * omega**2) / (K_i + K_o - mass * omega**2)
    return transmitted.real, transmitted.imag / omega


def ring_of(parts, azimuths):
    """Sum k [cos^2, cos sin; cos sin, sin^2]."""
    matrix = [[0.0, 0.0], [0.0, 0.0]]
    for part, psi in zip(parts, azimuths, strict=True):
        n = (math.cos(math.radians(psi)), math.sin(math.radians(psi)))
        for i in (0, 1):
            for k in (0, 1):
                matrix[i][k] += part * n[i] * n[k]
    return matrix


def contact_known(result, raceway, roller):
    """How well the program knows a contact in motion."""
    light = roller[raceway]["force_N"] < result["curve"][raceway]["load_N"][0]
    return LIGHT_CONTACT_KNOWN if light else CONTACT_KNOWN


def audit_error_of_line(said, name, row, full, result):
    """Of the trace: the distance from the law ehd, what that may be off, and the deviation of K."""
    K, other = row["stiffness_N_per_m"], full["stiffness_N_per_m"]
    away = max(abs(K[i][k] - other[i][k]) for i in (0, 1) for k in (0, 1))
    least = (away + full["error"] * (other[0][0] + other[1][1])) / (K[0][0] + K[1][1])
    deviation = max(line["K_standard_deviation_N_per_m"] / line["K_N_per_m"] for line in result["fit"].values())
    said.within(name, row["error"], least, least + 1.1 * deviation)


def audit_row(said, row, law, result, of, responses, full):
    """One frequency. `full`: the same by the law ehd."""
    frequency, film = row["frequency_Hz"], law == "ehd"
    mass = of.case["bearing"]["density_kg_per_m3"] * math.pi * of.D**2 / 4 * of.length
    parts = []
    for j, (one, still) in enumerate(zip(row["rollers"], result["rollers"], strict=True)):
        said.equal(f"{frequency} Hz: rollers[{j}].azimuth_deg", one["azimuth_deg"], still["azimuth_deg"])
        contacts = {raceway: contact_motion(law, raceway, still[raceway]["force_N"], result, of, responses, frequency)
                    for raceway in RACEWAYS}
        for raceway, (stiffness, damping) in contacts.items():
            name, written = f"{frequency} Hz: rollers[{j}].{raceway}", one[raceway]
            known = contact_known(result, raceway, still) if film else 1e-8
            said.near(f"{name}.stiffness_N_per_m", written["stiffness_N_per_m"], stiffness, relative=known)
            said.equal(f"{name} has damping", "damping_N_s_per_m" in written, film)
            if film:
                said.near(f"{name}.damping_N_s_per_m", written["damping_N_s_per_m"], damping, relative=5 * known)
        parts.append(through_roller(contacts["inner"], contacts["outer"], mass, frequency))
    azimuths = [one["azimuth_deg"] for one in result["rollers"]]
    for key, which, error in (("stiffness_N_per_m", 0, "error"), ("damping_N_s_per_m", 1, "damping_error")):
        if which == 1 and not film:
            said.equal(f"{frequency} Hz: damping of a law without one", key in row, False)
            continue
        expected = ring_of([part[which] for part in parts], azimuths)
        trace = abs(expected[0][0] + expected[1][1])
        if law == bearing.LINE:
            audit_error_of_line(said, f"{frequency} Hz: {error}", row, full, result)
        else:
            said.within(f"{frequency} Hz: {error}", row[error], 0, RING_KNOWN)
        for i in (0, 1):
            for k in (0, 1):
                # For a line, the error has its distance from the law ehd; the derivation is that of the line.
                said.near(f"{frequency} Hz: {key}[{i}][{k}]", row[key][i][k], expected[i][k],
                          absolute=(row[error] if film else 1e-8) * trace)


def audit_response(said, raceway, curve, responses):
    """The contacts whose response was solved. Their errors are absolute."""
    said.near(f"{raceway}: datum_m", curve["datum_m"], responses.of.length, relative=ROUND_OFF)
    said.equal(f"{raceway}: force_N increases", curve["force_N"], sorted(set(curve["force_N"])))
    for k, force in enumerate(curve["force_N"]):
        for which, value in enumerate(responses.slow(force, curve["datum_m"])):
            name = f"kappa_{which}"
            said.within(f"{raceway}: {name}_error[{k}]", curve[f"{name}_error"][k], 0, RING_KNOWN * abs(value))
            said.near(f"{raceway}: {name}[{k}]", curve[name][k], value,
                      absolute=curve[f"{name}_error"][k] + OWN_ERROR * abs(value))


def audit(document, result, of, responses, full, differences):
    said = Objections(differences)
    said.equal("frequencies", [row["frequency_Hz"] for row in document["dynamics"]], [0, FAST_HZ])
    for row, by_ehd in zip(document["dynamics"], full, strict=True):
        audit_row(said, row, document["law"], result, of, responses, by_ehd)
    for raceway, curve in document.get("response", {}).items():
        audit_response(said, raceway, curve, responses[raceway])
    if "responses" in document:
        solved = sum(len(curve["force_N"]) for curve in document["response"].values())
        said.within("cost.responses", document["responses"], solved, solved + EXTRA)
    return said


def documents(program):
    """(name, kind, document, audit): the parts of each law's result that motion adds. The rest is as without it."""
    case = read_case(bearing.HERE / "roller-bearing.toml")
    of = Bearing(case)
    still = bearing.run(program, case, laws=LAWS)
    moved = bearing.run(program, case, "--dynamic", "--frequency", 0, "--frequency", FAST_HZ, laws=LAWS)
    forces = {raceway: {one[raceway]["force_N"] for one in moved["ehd"]["rollers"]}
              | set(moved["ehd"]["curve"][raceway]["response"]["force_N"]) for raceway in RACEWAYS}
    responses = {raceway: Responses(program, of, raceway, forces[raceway], FAST_HZ) for raceway in RACEWAYS}
    full = moved["ehd"]["dynamics"]
    for law, result in moved.items():
        document = {"law": law, "dynamics": result.pop("dynamics")}
        if law == "ehd":
            document["response"] = {raceway: result["curve"][raceway].pop("response") for raceway in RACEWAYS}
            document["responses"] = result["cost"].pop("responses")
        differences = Objections()
        differences.same(f"{law} without motion", result, still[law],
                         apart=("wall_s", "plan", "notes", "provenance", "stiffness_error"))
        if law not in DRY_LAWS:  # motion at rest knows the stiffness better
            differences.within(f"{law}: stiffness_error", result["stiffness_error"], 0, still[law]["stiffness_error"])
        yield f"bearing --dynamic, {law}", "bearing-motion", document, \
            functools.partial(audit, document, result, of, responses, full, differences)
