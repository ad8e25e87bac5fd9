#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The functions of bindings/octave, and the lines of their page, by octave-cli:  run.sh PROGRAM. Exit code 77: there is
# no Octave.
set -eu
EHD_PROGRAM=$(realpath "$1")
source=$(realpath "$(dirname "$0")/../../..")
export EHD_PROGRAM EHD_CASES="$source/cases"
if ! command -v octave-cli > /dev/null; then
  echo "left out: apt-get install octave (219 MB)" >&2
  exit 77
fi
octave-cli --norc --no-history --path "$source/bindings/octave" "$source/tests/bindings/octave/functions_test.m"
cd "$source"
exec octave-cli --norc --no-history tests/bindings/octave/page_test.m
