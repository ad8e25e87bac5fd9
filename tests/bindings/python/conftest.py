# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python package share: the program to compare with, and the packages that may be missing."""

import importlib.util
import json
import os
import pathlib
import subprocess

import pytest

SOURCE = pathlib.Path(__file__).resolve().parents[3]
# `make python` sets it: no test may be skipped.
COMPLETE = os.environ.get("EHD_PYTHON_COMPLETE") == "1"


def needs(module, package):
    """The module; where it is missing the test is skipped, with the name of the package that has it."""
    try:
        return importlib.import_module(module)
    except ImportError:
        if COMPLETE:
            raise
        pytest.skip(f"{module} is missing: apt-get install {package}", allow_module_level=True)


def pytest_collection_modifyitems(items):
    """The examples in the docstrings of ehd.plot need what the functions need."""
    if COMPLETE or importlib.util.find_spec("matplotlib"):
        return
    for item in items:
        if item.name.startswith("ehd.plot"):
            item.add_marker(pytest.mark.skip("matplotlib is missing: apt-get install python3-matplotlib"))


@pytest.fixture(scope="session")
def program():
    """Runs the program `ehd`, and returns the process that has ended."""
    def run(*arguments):
        return subprocess.run([os.environ["EHD_PROGRAM"], *arguments], capture_output=True, text=True, check=False)
    return run


@pytest.fixture(scope="session")
def program_json(program):
    """The object that the program writes as JSON."""
    def run(*arguments):
        return json.loads(program(*arguments, "--json", "-").stdout)
    return run


def without_times(data):
    """The same JSON without what depends on the machine's load."""
    if isinstance(data, dict):
        return {key: without_times(value) for key, value in data.items()
                if key not in ("wall_s", "planning_s", "total_s", "stage_s", "provenance")}
    return data
