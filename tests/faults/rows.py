# SPDX-License-Identifier: GPL-3.0-or-later
"""Stored rows of a sweep with a right checksum and a wrong body, in a run that goes on and in a merge."""

import ctypes
import json

from room import Skipped, wrong_with

TITLE = "stored rows: right checksum, wrong body"

SWEEP = """case = "na4908"
laws = ["hertz", "iso"]
combine = "zip"
[keys]
"operation.radial_load_N" = [1e3, 2e3]
"""


class Hash128(ctypes.Structure):
    _fields_ = [("low", ctypes.c_uint64), ("high", ctypes.c_uint64)]


def checksum(content):
    """The first 16 digits of XXH3, as io/store has them."""
    try:
        xxh3 = ctypes.CDLL("libxxhash.so.0").XXH3_128bits
    except OSError as error:
        raise Skipped(f"the library of XXH3 is missing: {error}") from error
    xxh3.restype, xxh3.argtypes = Hash128, [ctypes.c_char_p, ctypes.c_size_t]
    return f"{xxh3(content, len(content)).high:016x}"


def changed(*path, to):
    """A body with another value at a path; `to` None: without it."""
    def change(body):
        at = body
        for step in path[:-1]:
            at = at[step]
        if to is None:
            del at[path[-1]]
        else:
            at[path[-1]] = to
        return json.dumps(body, separators=(",", ":"))
    return change


def text(content):
    return lambda body: content


def spliced(old, new):
    return lambda body: json.dumps(body, separators=(",", ":")).replace(old, new, 1)


ROLLER = ("results", 0, "rollers", 3)
BODIES = {
    "no object": text("[]"),
    "null": text("null"),
    "a number": text("17"),
    "a text": text('"x"'),
    "no JSON": text("results"),
    "an empty object": text("{}"),
    "an empty result": text('{"results":[{}]}'),
    "cut": lambda body: json.dumps(body, separators=(",", ":"))[:-3],
    "two objects": lambda body: json.dumps(body, separators=(",", ":")) * 2,
    "spaces before": lambda body: "  " + json.dumps(body, separators=(",", ":")),
    "deep": text('{"keys":' + "[" * 100000 + "]" * 100000 + "}"),
    "deep and open": text('{"keys":' + "[" * 100000),
    "no keys": changed("keys", to=None),
    "other keys": changed("keys", to={"operation.radial_load_N": 3e3}),
    "a text as keys": changed("keys", to="x"),
    "another hash": changed("hash", to="0" * 32),
    "a number as hash": changed("hash", to=1),
    "no results": changed("results", to=None),
    "results of another type": changed("results", to={}),
    "too few results": changed("results", 1, to=None),
    "a number as result": changed("results", 0, to=1),
    "another law": changed("results", 0, "law", to="ehd"),
    "a number as law": changed("results", 0, "law", to=1),
    "no status": changed("results", 0, "status", to=None),
    "an unknown status": changed("results", 0, "status", to="fine"),
    "a number as status": changed("results", 0, "status", to=1),
    "a text as displacement": changed("results", 0, "displacement_m", to="=1+1"),
    "rollers of another type": changed("results", 0, "rollers", to={}),
    "a number as roller": changed(*ROLLER, to=1),
    "a roller without raceway": changed(*ROLLER, "outer", to=None),
    "a raceway of another type": changed(*ROLLER, "inner", to=[]),
    "a contact without force": changed(*ROLLER, "inner", "force_N", to=None),
    "a text as force": changed(*ROLLER, "inner", "force_N", to="x"),
    "a text as azimuth": changed(*ROLLER, "azimuth_deg", to="x"),
    "a text as pressure": changed(*ROLLER, "outer", "hertz_pressure_Pa", to="x"),
    "a fit of another type": changed("results", 0, "fit", to=1),
    "a fit without range": changed("results", 0, "fit", to={"inner": {}, "outer": {}}),
    "notes of another type": changed("results", 0, "notes", to=1),
    "a number as note": changed("results", 0, "notes", to=[1]),
    "a number as why": changed("results", 0, "why", to=1),
    "a list as cost": changed("results", 0, "cost", to=[]),
    "a number that is too large": spliced('"balance_error":', '"balance_error":1e400,"x":'),
    "null as number": spliced('"balance_error":', '"balance_error":null,"x":'),
    "a key twice": spliced('"status":', '"status":"converged","status":'),
    "another key": changed("frobnicate", to=1),
}


def damaged(line, change):
    _, key, body = line.split(" ", 2)
    content = (key + " " + change(json.loads(body))).encode()
    return checksum(content).encode() + b" " + content + b"\n"


def with_bad_row(room, journal, change):
    """Changes the first row of a journal, which an honest run has left."""
    path = room.path / journal
    header, first, *rest = path.read_text().splitlines(keepends=True)
    path.write_bytes(header.encode() + damaged(first.rstrip("\n"), change) + "".join(rest).encode())


def goes_on(change):
    """The same command again computes the bad row again, and leaves the same tables."""
    def attack(room):
        room.write("s.toml", SWEEP)
        command = ["sweep", "s.toml", "--output", "o", "--threads", "1"]
        if (ended := room.run(*command)).code != 0:
            return f"the honest run fails: {ended.err}"
        before = (room.path / "o/rows.csv").read_text()
        with_bad_row(room, "o/rows/journal", change)
        files = room.files()
        ended = room.run(*command)
        if wrong := [one for one in wrong_with(ended, (0,)) if "lines on standard error" not in one]:
            return f"{'; '.join(wrong)}: {ended.err[:200]!r}"
        if "rows computed 1," not in ended.out:
            return f"the bad row is not computed again: {ended.out!r}"
        if (room.path / "o/rows.csv").read_text() != before:
            return "the tables differ"
        return None if room.files() == files else "leaves files"
    return attack


def merged(change):
    """A merge refuses the shard."""
    def attack(room):
        room.write("s.toml", SWEEP)
        command = ["sweep", "s.toml", "--output", "o"]
        if (ended := room.run(*command, "--shard", "1/1")).code != 0:
            return f"the honest run fails: {ended.err}"
        with_bad_row(room, "o/shards/1-of-1/journal", change)
        return room.refused(*command, "--merge", says=["1-of-1/journal", "run again --shard 1/1"])
    return attack


def inputs():
    for name, change in BODIES.items():
        yield f"run: {name}", goes_on(change)
        yield f"merge: {name}", merged(change)
