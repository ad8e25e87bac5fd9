# SPDX-License-Identifier: GPL-3.0-or-later
"""The package's own table of the C interface against ehd/ehd.h; its docstrings against its functions."""

import inspect
import re

import ehd
import pytest
from conftest import SOURCE
from ehd import _library

HEADER = (SOURCE / "bindings" / "c" / "ehd" / "ehd.h").read_text(encoding="utf-8")
DECLARATIONS = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.DOTALL)


def test_every_function_takes_what_the_header_says():
    declared = {}
    for name, arguments in re.findall(r"EHD_API [^;]*?(ehd_\w+)\((.*?)\);", DECLARATIONS, re.DOTALL):
        arguments = re.sub(r"\(\*callback\)\(.*?\)", "callback", arguments)
        declared[name] = 0 if arguments == "void" else arguments.count(",") + 1
    assert len(declared) >= 12
    for name, (_, takes) in _library._SIGNATURES.items():
        assert declared[name] == len(takes), name


def test_the_words_of_a_status_stand_in_the_order_of_their_numbers():
    numbers = dict(re.findall(r"\bEHD_(\w+) = (\d)", DECLARATIONS))
    for number, word in enumerate(_library.STATUS):
        assert numbers[word.upper().replace("-", "_")] == str(number)
    assert (numbers["OK"], numbers["BAD_INPUT"]) == (str(_library.CONVERGED), str(_library.BAD_INPUT))


def public_functions():
    """(name, function): those of ehd.__all__, and the methods of its classes."""
    for name in ehd.__all__:
        thing = getattr(ehd, name)
        members = [("", thing)] if inspect.isfunction(thing) else inspect.getmembers(thing, inspect.isfunction)
        yield from ((f"{name}.{member}".strip("."), function) for member, function in members
                    if function.__module__.startswith("ehd") and not member.startswith("_"))


@pytest.mark.parametrize("name, function", public_functions())
def test_a_docstring_says_what_a_function_takes_and_returns(name, function):
    signature = inspect.signature(function)
    text = inspect.getdoc(function)
    assert "Returns\n-------\n" in text or signature.return_annotation in (None, "None"), name
    assert "Parameters\n----------\n" in text or not set(signature.parameters) - {"self"}, name
    assert all(re.search(rf"^(\w+, )*\**{taken}\b", text, re.MULTILINE)
               for taken in signature.parameters if taken not in ("self", "statement")), name


def test_the_functions_are_found():
    assert {"solve", "Law.force", "Bearing.law", "plot.contact", "judge"} <= {name for name, _ in public_functions()}


def test_the_version_is_that_of_the_library(program):
    assert re.fullmatch(r"\d+\.\d+\.\d+", ehd.__version__)
    assert ehd.version().startswith(f"{ehd.__version__} (")
    assert program("--version").stdout.startswith(f"ehd {ehd.__version__} ")
    with pytest.raises(AttributeError, match="slove"):
        ehd.slove
