# SPDX-License-Identifier: GPL-3.0-or-later
"""The package's own table of the C interface against ehd/ehd.h."""

import re

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
