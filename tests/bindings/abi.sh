#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# abi.sh HEADER KEPT: functions, arguments and constants of ehd/ehd.h are those of KEPT, so that a program that was
# linked with libehd.so.0 goes on to run. A line of KEPT never changes and never goes while the library is called
# libehd.so.0; a new function gets a line. It needs no package; the library itself is read by abidiff.sh.
set -eu
header=$1
kept=$2
made=$(mktemp)
trap 'rm -f "$made"' EXIT
# A declaration a line, single spaces, without what the system's headers declare.
${CC:-cc} -E -P "$header" | tr '\n' ' ' | sed 's/__attribute__ *((visibility("default")))//g; s/;/;\n/g' \
  | sed -n 's/  */ /g; s/^ //; /ehd_\|EHD_/p' > "$made"
diff "$kept" "$made" || { echo "abi.sh: < $kept, > $header"; exit 1; }
