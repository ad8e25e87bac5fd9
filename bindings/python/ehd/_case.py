# SPDX-License-Identifier: GPL-3.0-or-later
"""From what a user states to the text of a case. The library reads the text; nothing is checked here."""

from __future__ import annotations

import difflib
import json
import numbers
import os
import pathlib
import re
from typing import Iterable, Mapping, NamedTuple, Optional, Union

import numpy as np

from ._library import prefix
from .errors import InputError

CaseName = Union[str, "os.PathLike[str]"]
Value = Union[float, int, str]

# The keys of a contact case by table, as `ehd new contact` explains them. What stands in none of them belongs to
# [lubricant]. "lambda_" is lambda: Python keeps that word for itself.
_TABLES: dict[str, tuple[str, ...]] = {
    "": ("id", "version", "title", "source"),
    "moes": ("M", "L"),
    "conditions": ("load_N_per_m", "reduced_radius_m", "reduced_modulus_Pa", "speed_sum_m_per_s", "viscosity_Pa_s"),
    "hertz": ("lambda_", "alpha_p_H"),
    "domain": ("inlet",),
}
_ARGUMENTS = ("solver", "tolerance", "raise_on_failure")  # of `solve`, beside the keys
_HEADING: dict[str, Value] = {"id": "keywords", "version": 1, "title": "stated by keywords", "source": "own"}
# What `ehd solve --M 20 --L 10` assumes.
PLAIN_OIL: dict[str, Value] = {"viscosity": "barus", "density": "incompressible"}
_MOST_BYTES = 64 * 1024  # of a case: the library refuses a longer text
_LONGEST_ID, _LONGEST_PATH = 60, 400  # in a message
_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,199}")  # of a case


class CaseText(NamedTuple):
    """The text of a case, and the name of its file."""

    text: bytes
    name: Optional[str]  # None: made of keywords; the user has not seen its lines
    keywords: tuple[str, ...] = ()  # of the call, beside the keys of [lubricant]

    def explain(self, error: InputError) -> InputError:
        """The same error with the name of the file. The library says "case:LINE: ", or "ID.toml:LINE: "."""
        place = r"^(?:case|lubricant|[^:\s]+\.toml)(:\d+)?: "
        line = re.sub(place, lambda at: f"{self.name}{at[1] or ''}: " if self.name else "", str(error))
        # A keyword that is no other goes to [lubricant], where the library refuses it.
        unknown = re.match(r"(\w+)\b.*: is unknown in (?:the )?\[lubricant\].*; .*\ballowed is ([\w, ]*\w)"
                           r"(?:.*( \(and \d+ more\)))?", line)
        if self.name or not unknown:
            return InputError(line)
        known = list(dict.fromkeys((*self.keywords, *unknown[2].split(", "))))
        return InputError(f"{unknown[1]}: is an unknown keyword; {did_you_mean(unknown[1], known)}"
                          f"allowed is {', '.join(known)}{unknown[3] or ''}")


def did_you_mean(word: str, names: Iterable[str]) -> str:
    """``did you mean NAME? ``, the nearest of the names, or nothing. Capital letters are small ones."""
    known = {name.lower(): name for name in names}
    meant = difflib.get_close_matches(word.lower(), known, n=1)
    return f"did you mean {known[meant[0]]}? " if meant else ""


def shown(value: object) -> str:
    """A wrong argument, in one line."""
    return " ".join(repr(value).split())


# The kinds of NumPy's types that a double would take in silence, with a loss or a guess. Of the others "i", "u" and "f"
# are numbers, and "O" is known by its elements.
_NO_NUMBERS = {"b": "truth values", "c": "complex numbers", "U": "texts", "S": "texts", "M": "dates", "m": "durations"}


def no_numbers(values: object) -> str:
    """What a number, an array or a sequence has that is no number: "texts"; empty where there is nothing of it."""
    if type(values) in (int, float):  # most elements of a list
        return ""
    if isinstance(values, (list, tuple)):
        return next(filter(None, map(no_numbers, values)), "")
    if isinstance(values, np.ma.MaskedArray) and np.any(values.mask):
        return "masked values"
    array = np.asarray(values)
    if array.dtype.kind == "O" and array.ndim > 0:
        return no_numbers(array.ravel().tolist())
    return _NO_NUMBERS.get(array.dtype.kind, "")


def number(name: str, value: object) -> float:
    """An argument that has to be a number."""
    if not isinstance(value, numbers.Real) or isinstance(value, bool):
        raise InputError(f"{name} = {value!r}: is no number; allowed is one number")
    try:
        return float(value)
    except OverflowError:
        raise _too_large(name) from None


def whole(name: str, value: object) -> int:
    """An argument that has to be an integer."""
    if not isinstance(value, numbers.Integral) or isinstance(value, bool):
        raise InputError(f"{name} = {value!r}: is no whole number; allowed is an integer")
    result = int(value)
    if abs(result) >= 2**31:  # ctypes would cut it
        digits = f" = {value}" if abs(result) < 2**64 else ""  # Python writes no integer of many thousand digits
        raise InputError(f"{name}{digits}: is out of range; allowed is an integer below 2^31")
    return result


def word(name: str, value: object) -> bytes:
    """An argument that has to be a name."""
    if not isinstance(value, str):
        raise InputError(f"{name} = {value!r}: is no name; allowed is a text")
    if "\0" in value:  # a text in C ends there
        raise InputError(f"{name} = {value!r}: is no name; allowed is a text without a null character")
    return utf8(value, name)


def _too_large(name: str) -> InputError:
    return InputError(f"{name}: is out of range; allowed is a number that a double holds")


def utf8(text: str, name: str) -> bytes:
    """The bytes that the library reads."""
    try:
        return text.encode()
    except UnicodeEncodeError:  # half of a pair of surrogates
        raise InputError(f"{name}: is no Unicode; allowed is a text that UTF-8 holds") from None


def _toml(key: str, value: Value) -> str:
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    try:
        if not no_numbers(value):
            return str(int(value)) if isinstance(value, numbers.Integral) else repr(float(value))
    except OverflowError:
        raise _too_large(key) from None
    except (TypeError, ValueError):
        if isinstance(value, numbers.Integral):  # Python writes no integer of many thousand digits
            raise _too_large(key) from None
    raise InputError(f"{key} = {shown(value)}: is neither a number nor a text; allowed is one of them")


def lines(entries: Mapping[str, Value]) -> str:
    """``key = value`` a line, in TOML."""
    return "".join(f"{key.rstrip('_')} = {_toml(key, value)}\n" for key, value in entries.items())


def case_from_keywords(statement: Mapping[str, Value]) -> CaseText:
    """A contact case. Without any key of the lubricant, and without speed and viscosity, it is dry."""
    table_of = {key: table for table, keys in _TABLES.items() for key in keys}
    tables: dict[str, dict[str, Value]] = {"": dict(_HEADING)}
    for key, value in statement.items():
        tables.setdefault(table_of.get(key, "lubricant"), {})[key] = value
    stated_dry = "conditions" in tables and set(tables).isdisjoint({"lubricant", "domain"})
    if not stated_dry or {"speed_sum_m_per_s", "viscosity_Pa_s"} & set(statement):
        laws = PLAIN_OIL if "moes" in tables else {}
        tables["lubricant"] = {**laws, **tables.get("lubricant", {})}
        tables.setdefault("domain", {"inlet": "flooded"})
    text = lines(tables.pop("")) + "".join(f"[{table}]\n{lines(entries)}" for table, entries in tables.items())
    return CaseText(utf8(text, "the keywords"), None, (*_ARGUMENTS, *table_of))


def cases_folder() -> Optional[pathlib.Path]:
    """The folder of the benchmark cases: EHD_CASES, else that of the installation or of the source tree."""
    named = os.environ.get("EHD_CASES")
    if named:
        return pathlib.Path(named)
    for folder in (prefix() / "share" / "ehd" / "cases", prefix() / "cases"):
        if folder.is_dir():
            return folder
    return None


def _find(name: str) -> pathlib.Path:
    """The file of a case, found as the program finds it: a path, or an id below the folder of cases."""
    path = pathlib.Path(name)
    folder = cases_folder()

    def wrong() -> InputError:
        known = [file.stem for file in folder.glob("*.toml")] if folder and _ID.fullmatch(name) else []
        return InputError(f"{_short(name, _LONGEST_ID)}: there is no such case; {did_you_mean(name, known)}allowed is "
                          "a path to a case file, an id that `ehd cases` or `ehd cases --atlas` lists, or the text of "
                          "a case")

    if not name or "\0" in name:  # no path has a null character
        raise wrong()
    if "/" in name or path.suffix == ".toml":
        return path
    if folder is not None and _ID.fullmatch(name):  # no pattern, such as "*"
        found = [folder / f"{name}.toml", *sorted(folder.glob(f"*/{name}.toml"))]
        for candidate in found:
            if candidate.is_file():
                return candidate
    if os.path.exists(path):
        return path
    raise wrong()


def _short(name: str, longest: int) -> str:
    """A wrong name in a message: its beginning, in printable characters. '' where it is empty."""
    line = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in name[:longest])
    return (line or "''") + ("..." if len(name) > longest else "")


def file_name(name: str, value: object, allowed: str) -> str:
    """An argument that has to be a path, or a text."""
    if not isinstance(value, (str, bytes, os.PathLike)):
        raise InputError(f"{name} = {shown(value)}: is no path; allowed is {allowed}")
    return os.fsdecode(value)


def _bytes_of(file: pathlib.Path) -> bytes:
    """No more than a byte above what a case may have: a pipe would block, and /dev/zero has no end."""
    name, allowed = _short(str(file), _LONGEST_PATH), "allowed is the path of a case file"
    if os.path.exists(file) and not (os.path.isfile(file) or os.path.isdir(file)):
        raise InputError(f"{name}: is not a regular file; {allowed}")
    try:
        with file.open("rb") as stream:
            return stream.read(_MOST_BYTES + 1)
    except OSError as error:
        raise InputError(f"{name}: {error.strerror}; {allowed}") from error


def case_from(case: CaseName) -> CaseText:
    """The text of a case file, by its path or id. A text of more than one line is a case itself."""
    name = file_name("case", case, "the path, the id or the text of a case")
    if "\n" in name:
        return CaseText(_whole(utf8(name, "case"), "case"), "case")
    file = _find(name)
    return CaseText(_whole(_bytes_of(file), str(file)), str(file))


def _whole(text: bytes, name: str) -> bytes:
    if b"\0" in text:  # a text in C ends there
        raise InputError(f"{name}: is binary; allowed is TOML")
    return text
