#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The tests of the Python package, and every example in its docstrings and on its page.
#
#   tests/bindings/python/run.sh PYTHON LIBRARY PROGRAM [pytest's options]
#
# Exit code 77: pytest or NumPy is missing. With EHD_PYTHON_COMPLETE=1 nothing may be missing.
set -eu
python=$1 EHD_LIBRARY=$(realpath "$2") EHD_PROGRAM=$(realpath "$3")
shift 3
source=$(realpath "$(dirname "$0")/../../..")
export EHD_LIBRARY EHD_PROGRAM EHD_CASES="$source/cases" PYTHONPATH="$source/bindings/python"
export PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg  # the tree stays clean; no display

if ! "$python" -c "import numpy, pytest"; then
  echo "left out: apt-get install python3-numpy python3-pytest" >&2
  [ "${EHD_PYTHON_COMPLETE:-0}" = 1 ] && exit 1
  exit 77
fi
cd "$source"
exec "$python" -m pytest -q -rs -p no:cacheprovider --rootdir "$source" --import-mode=append \
  --doctest-modules --doctest-glob='*.md' "$@" tests/bindings/python bindings/python/ehd docs/python.md
