# SPDX-License-Identifier: GPL-3.0-or-later
"""Case files and sweep files with each key wrong in each way: type, range, not a number, missing, twice, unknown."""

TITLE = "cases: each key wrong in each way"

# key = value, a line each. "?" before a key: the file may do without it.
CONTACT = """
id = "c"
version = 1
title = "A contact"
source = "own"
[moes]
M = 20.0
L = 10.0
[lubricant]
viscosity = "roelands"
density = "dowson-higginson"
alpha_per_Pa = 2.2e-8
z = 0.68
?p0_Pa = 1.96e8
[domain]
inlet = -4.0
[[expect]]
quantity = "film.minimum"
value = "0.074142675"
scaling = "hertz"
?uncertainty = 1e-8
kind = "computed"
"""

CONDITIONS = """
id = "c"
version = 1
title = "A contact in SI"
source = "own"
[conditions]
load_N_per_m = 1.0e5
reduced_radius_m = 1.0e-2
reduced_modulus_Pa = 2.2e11
speed_sum_m_per_s = 3.0
viscosity_Pa_s = 0.02
[lubricant]
viscosity = "barus"
density = "incompressible"
alpha_per_Pa = 2.0e-8
[domain]
inlet = "flooded"
"""

HERTZ = """
id = "c"
version = 1
title = "A contact by its groups"
source = "own"
[hertz]
lambda = 1.51425
alpha_p_H = 2.832
[lubricant]
viscosity = "barus"
density = "incompressible"
[domain]
inlet = -4.0
"""

BEARING = """
id = "c"
version = 1
title = "A bearing"
source = "own"
[bearing]
rollers = 22
pitch_diameter_m = 0.053
roller_diameter_m = 0.005
length_m = 0.122
clearance_m = 0.0
rotating = "inner"
density_kg_per_m3 = 7850.0
?first_azimuth_deg = 0.0
?ring_thickness_m = 0.003
?roughness_m = 1.0e-7
[operation]
speed_rpm = 5000.0
radial_load_N = 50.0e3
[material]
modulus_Pa = 2.06e11
poisson = 0.3
[lubricant]
viscosity = "roelands"
density = "dowson-higginson"
?alpha_per_Pa = 2.2e-8
?z = 0.68
?p0_Pa = 1.96e8
viscosity_Pa_s = 0.02
[datum]
law = "palmgren"
?load_N = 9289.0
[fit]
?load_N = [2000.0, 12000.0]
?points = 6
"""

SWEEP = """
case = "na4908"
?laws = ["hertz"]
combine = "product"
[keys]
?"operation.radial_load_N" = [1e3, 2e3]
?"bearing.clearance_m" = { from = 0.0, to = 1e-5, points = 3, spacing = "linear" }
"""

OTHER_TYPES = ["true", "1979-05-27", "{ a = 1 }", "[[]]"]
WRONG = {  # by what the right value is
    "real": ["nan", "inf", "-inf", "1e300", "-1e300", "1e400", "-1e400", "1e-400", "0x", '"1"', *OTHER_TYPES],
    "integer": ["1.5", "0", "-1", "99999999999", "99999999999999999999", "nan", '"1"', *OTHER_TYPES],
    "text": ['"xyz"', '""', "1", "2.5", "nan", '"not closed', *OTHER_TYPES],
    "line": ['""', "1", '"two\\nlines"', "nan", *OTHER_TYPES],  # any text is right, but one line
    "array": ["[]", "[true]", "[[1.0]]", "[nan]", "[1e-400]", "[1e3, -1e300]", "1", '"1"', "true"],
    "range": ["{}", "{ from = 0.0 }", "{ from = 0.0, to = 1e-5, points = 0, spacing = \"linear\" }",
              "{ from = 0.0, to = 1e-400, points = 3, spacing = \"linear\" }",
              "{ from = 0.0, to = 1e-5, points = 3, spacing = \"logarithmic\" }", "1", "true"],
}


def kind_of(key, value):
    if key in ("title", "source"):
        return "line"
    if value.startswith('"'):
        return "text"
    if value.startswith("["):
        return "array"
    if value.startswith("{"):
        return "range"
    return "real" if any(c in value for c in ".e") else "integer"


def refusal(command, lines):
    def attack(room):
        room.write("c.toml", "\n".join(line.removeprefix("?") for line in lines) + "\n")
        return room.refused(command, "c.toml", says=["c.toml"])
    return attack


def of_file(name, command, text):
    lines = text.strip().split("\n")
    for i, line in enumerate(lines):
        table = next((above for above in reversed(lines[:i]) if above.startswith("[")), "the heading")
        before, after = lines[:i], lines[i + 1:]

        def at(what, *instead):
            return f"{name}: {table}: {line}: {what}", refusal(command, [*before, *instead, *after])

        if line.startswith("["):
            yield at("an unknown key", line, "frobnicate = 1")
            yield at("another name", line.replace("[", "[frobnicate_", 1))
            continue
        key, value = (part.strip() for part in line.split("=", 1))
        for wrong in WRONG[kind_of(key.removeprefix("?"), value)]:
            yield at(wrong, f"{key} = {wrong}")
        yield at("twice", line, line)
        yield at("without a value", f"{key} =")
        if not key.startswith("?"):
            yield at("missing")


def bad_id(name):
    def attack(room):
        room.write(name + ".toml", CONDITIONS.replace('id = "c"', f'id = "{name}"'))
        return room.refused("plan", f"./{name}.toml", says=["allowed is letters, digits"])
    return attack


def bad_sweep_id(name):
    def attack(room):
        room.write(name + ".toml", SWEEP.replace("?", ""))
        return room.refused("sweep", f"./{name}.toml", says=["allowed is letters, digits"])
    return attack


IDS = ["a b", " a", "-a", ".a", "_a", "a;b", "$(a)", "=1+1", "+a", "@a", "a,b", "a'b", "ä", "a*b", "a:b", "a%b", "~a"]


def inputs():
    yield from of_file("contact", "plan", CONTACT)
    yield from of_file("conditions", "plan", CONDITIONS)
    yield from of_file("hertz", "plan", HERTZ)
    yield from of_file("bearing", "plan", BEARING)
    yield from of_file("sweep", "sweep", SWEEP)
    for name in IDS:
        yield f"the id {name!r}", bad_id(name)
        yield f"the sweep {name!r}", bad_sweep_id(name)
