# SPDX-License-Identifier: GPL-3.0-or-later
"""Objections of an audit, and the wrong documents that an audit has to object to."""

import math

# A few operations on numbers that the JSON gives to their last bit.
ROUND_OFF = 1e-12


class Objections(list):
    """What an audit has to say against a document: one line an objection."""

    def near(self, name, value, expected, relative=0.0, absolute=0.0):
        """Objects unless |value - expected| <= absolute + relative |expected|. NaN is objected to."""
        allowed = absolute + relative * abs(expected)
        if not abs(value - expected) <= allowed:
            self.append(f"{name} = {value!r}: expected {expected!r} to {allowed:.2g}")

    def equal(self, name, value, expected):
        if value != expected:
            self.append(f"{name} = {value!r}: expected {expected!r}")

    def same(self, name, document, other, apart=()):
        """Every entry the same but those with the keys `apart`."""
        if isinstance(document, (dict, list)):
            entries = document if isinstance(document, dict) else dict(enumerate(document))
            others = other if isinstance(other, dict) else dict(enumerate(other))
            if set(entries) - set(apart) != set(others) - set(apart):
                self.append(f"{name}: {sorted(entries)}: expected {sorted(others)}")
                return
            for key, value in entries.items():
                if key not in apart:
                    self.same(f"{name}/{key}", value, others[key], apart)
        elif document != other:
            self.append(f"{name} = {document!r}: expected {other!r}")

    def within(self, name, value, low=-math.inf, high=math.inf):
        if not low <= value <= high:
            self.append(f"{name} = {value!r}: expected between {low!r} and {high!r}")


def numbers_in(document, path=()):
    """Every number of a document: (the object or list that holds it, its key there, its path)."""
    entries = document.items() if isinstance(document, dict) else enumerate(document)
    for key, value in list(entries):
        if isinstance(value, (dict, list)):
            yield from numbers_in(value, (*path, str(key)))
        elif isinstance(value, (int, float)) and not isinstance(value, bool):
            yield document, key, (*path, str(key))


def changes_of(value):
    """Wrong values in place of a number, each with its name."""
    if value != 0:
        yield "doubled", 2 * value
        yield "sign turned", -value
    if isinstance(value, int) or value == 0:
        yield "one more", value + 1


def objects(audit):
    """True if the audit objects. A value on which its formulas break, or beside which one is missing, counts too."""
    try:
        return bool(audit())
    except (ArithmeticError, LookupError, ValueError):
        return True
