#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# abidiff.sh [--keep] LIBRARY HEADER: libabigail finds the functions, types and sizes of the interface as they are kept
# in libehd.so.0.abi. LIBRARY has debug information (make abi). What HEADER does not declare, the inside of the opaque
# result, is left out. --keep: keeps those of LIBRARY instead.
set -eu
keep=
if [ "$1" = --keep ]; then
  keep=1
  shift
fi
library=$1
header=$2
kept=$(dirname "$0")/libehd.so.0.abi
made=$(mktemp)
trap 'rm -f "$made"' EXIT
abidw --exported-interfaces-only --header-file "$header" --drop-private-types --no-show-locs --no-elf-needed \
  --no-corpus-path --no-comp-dir-path "$library" | sed "s| path='[^']*/| path='|" > "$made"
if [ "$keep" ]; then
  cp "$made" "$kept"
  echo "kept in $kept"
else
  abidiff "$kept" "$made" || { echo "abidiff.sh: the interface is not that of $kept"; exit 1; }
  echo "abidiff: no change of $(grep -c '<function-decl' "$made") functions"
fi
