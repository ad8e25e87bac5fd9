# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program and reads what it wrote."""

import concurrent.futures
import csv
import json
import os
import pathlib
import subprocess
import tomllib

TOP = pathlib.Path(__file__).resolve().parents[2]


class Program:
    """The built `ehd`, and a folder for its files. Both processors of a small machine are used by `side_by_side`."""

    def __init__(self, path, folder):
        self.path = str(path)
        self.folder = pathlib.Path(folder)

    def run(self, *arguments, allowed=(0,), cases=None):
        """Standard output of `ehd arguments`, with the folder `cases` in place of the benchmark's. Any other exit code
        ends the audit."""
        command = [self.path, *map(str, arguments)]
        environment = {**os.environ, "EHD_CASES": str(cases)} if cases else None
        done = subprocess.run(command, cwd=TOP, capture_output=True, text=True, timeout=600,  # under a sanitizer
                              env=environment)
        if done.returncode not in allowed:
            raise SystemExit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
        return done.stdout

    def json(self, *arguments, allowed=(0,)):
        return without_null(json.loads(self.run(*arguments, "--json", "-", allowed=allowed)))

    @staticmethod
    def read_json(path):
        return without_null(json.loads(path.read_text()), path.name)

    def write(self, name, text):
        """A file in the folder; its path."""
        path = self.folder / name
        path.write_text(text)
        return path


def without_null(value, place="standard output"):
    """The value; ends the audit where it holds a null: what is not known is absent."""
    if value is None:
        raise SystemExit(f"{place}: is null; required is a value, or no key")
    if isinstance(value, (dict, list)):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            without_null(inner, f"{place}/{key}")
    return value


def side_by_side(calls):
    """The results of functions without arguments, two at a time, in their order."""
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        return [one.result() for one in [pool.submit(call) for call in calls]]


def read_case(path):
    with open(path, "rb") as file:
        return tomllib.load(file)


def to_toml(tables):
    """A case as text: keys of the top first, then one table after the other. Expectations are left out."""
    tables = {key: value for key, value in tables.items() if key != "expect"}
    def entry(key, value):
        return f"{key} = {json.dumps(value)}\n"
    text = "".join(entry(key, value) for key, value in tables.items() if not isinstance(value, dict))
    for name, table in tables.items():
        if isinstance(table, dict):
            text += f"\n[{name}]\n" + "".join(entry(key, value) for key, value in table.items())
    return text


def read_csv(path):
    """Rows as dictionaries, without the unit in brackets behind a column's name, comments and empty cells."""
    with open(path, newline="") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        names = [name.split(" [")[0] for name in next(rows)]
        return [{name: number(cell) for name, cell in zip(names, row, strict=True) if cell} for row in rows]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text
