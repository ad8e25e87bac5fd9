# SPDX-License-Identifier: GPL-3.0-or-later
"""The package's types, the page's commands, the examples and the notebooks. Examples in docstrings run as doctests."""

import json
import os
import re
import subprocess
import sys

import pytest
from conftest import COMPLETE, SOURCE, needs

PAGE = SOURCE / "docs" / "python.md"
NOTEBOOKS = sorted((SOURCE / "examples" / "notebooks").glob("*.ipynb"))


def test_types(tmp_path):
    needs("mypy", "python3-mypy")
    done = subprocess.run([sys.executable, "-m", "mypy", "--config-file", SOURCE / "bindings/python/mypy.ini",
                           "--cache-dir", tmp_path, SOURCE / "bindings/python/ehd"], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stdout


def commands_of(page):
    """The lines of its blocks of shell commands."""
    blocks = re.findall(r"^```sh\n(.*?)^```", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    return [line for block in blocks for line in block.splitlines() if line]


def test_the_page_has_commands():
    assert len(commands_of(PAGE)) >= 3


@pytest.mark.parametrize("command", commands_of(PAGE))
def test_a_command_of_the_page(command, tmp_path):
    if "dask" in command:
        needs("distributed", "python3-distributed")
        assert "--contacts 40" in command
        command = command.replace("--contacts 40", "--contacts 10000") if COMPLETE else command  # 40 s on two cores
    environment = {**os.environ, "PATH": f"{os.path.dirname(sys.executable)}:{os.environ['PATH']}"}
    environment.pop("PYTHONPATH")  # the command says itself where the package is
    done = subprocess.run(["sh", "-ec", command], cwd=SOURCE, env=environment, capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0 and done.stdout, done.stderr


def test_the_notebooks_print_what_they_show(tmp_path):
    """They run again; the text of every output is that in the file."""
    needs("matplotlib", "python3-matplotlib")
    needs("nbconvert", "python3-nbconvert")
    needs("ipykernel", "python3-ipykernel")
    environment = {**os.environ, "HOME": str(tmp_path), "IPYTHONDIR": str(tmp_path / "ipython")}
    environment.pop("MPLBACKEND")  # the notebook's own
    done = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", tmp_path,
                           *NOTEBOOKS], capture_output=True, text=True, check=False, env=environment)
    assert done.returncode == 0, done.stderr
    for notebook in NOTEBOOKS:
        shown, printed = (texts_of(json.loads(path.read_text(encoding="utf-8"))) for path in
                          (notebook, tmp_path / notebook.name))
        assert shown == printed and any(shown)


def texts_of(notebook):
    return [["".join(output.get("text", output.get("data", {}).get("text/plain", ""))) for output in cell["outputs"]]
            for cell in notebook["cells"] if cell["cell_type"] == "code"]


def test_there_are_notebooks_and_they_are_small():
    assert [path.stem for path in NOTEBOOKS] == ["contact", "your-bearing"]
    assert all(path.stat().st_size < 150_000 for path in NOTEBOOKS)
