#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Counts the instructions (Ir) of three fixed solves under callgrind, function by function, and names what moved by more
# than 2 % since the counts that are kept in counts.txt. A count does not know how busy the machine is, so that it sees
# changes that no clock would.
#
#   count.sh PROGRAM          compare; exit code 1 where something moved
#   count.sh --keep PROGRAM   replace counts.txt
#
# PROGRAM is built without this machine's vector instructions, since valgrind does not know all of them (make callgrind
# does that). Functions of this project stand alone, everything else is summed up by library.
set -eu
export LC_ALL=C

keep=no
if [ "${1:-}" = --keep ]; then keep=yes; shift; fi
if [ $# -ne 1 ]; then echo "usage: count.sh [--keep] PROGRAM" >&2; exit 2; fi
program=$1
here=$(dirname "$0")
kept=$here/counts.txt
[ -x "$program" ] || { echo "count.sh: $program: is no program; required is a built ehd" >&2; exit 2; }
for tool in valgrind callgrind_annotate; do
  command -v "$tool" > /dev/null 2>&1 || { echo "count.sh: $tool is missing: apt-get install valgrind" >&2; exit 2; }
done

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT INT TERM

# The name of a solve, then the arguments of `ehd solve`.
solves="fast	own-moes-20-10 --solver fast --tolerance 1e-3
fast.uniform	own-moes-1000-10 --solver fast.uniform --nodes 4096
reference	own-moes-5-5 --solver reference --tolerance 1e-6"

# callgrind_annotate prints "IR (SHARE) FILE:FUNCTION [OBJECT]". Below a thousandth of a solve a function is not listed.
by_function() {  # NAME
  awk -v name="$1" '
    function amount(text) { gsub(",", "", text); return text + 0 }
    / PROGRAM TOTALS$/ { total = amount($1); next }
    total > 0 && $1 ~ /^[0-9,]+$/ {
      ir = amount($1)
      rest = $0
      sub(/^ *[0-9,]+ *(\( *[0-9.]+%\))? */, "", rest)
      object = "?"
      if (match(rest, / \[[^]]*\]$/)) {
        object = substr(rest, RSTART + 2, RLENGTH - 3)
        rest = substr(rest, 1, RSTART - 1)
        sub(/.*\//, "", object)
        sub(/\.so.*$/, "", object)
      }
      sub(/^[^ :]*:/, "", rest)      # the file
      sub(/\x27[0-9]+$/, "", rest)   # the depth of a recursion
      own = rest ~ /^(non-virtual thunk to )?ehd::/ || rest ~ /^[^(]* ehd::/
      sum[own ? rest : "(" object ")"] += ir
    }
    END {
      if (total == 0) exit 1
      printf "%s\ttotal\t%.0f\n", name, total
      for (f in sum) if (sum[f] >= total / 1000) printf "%s\t%s\t%.0f\n", name, f, sum[f]
    }'
}

{
  echo "# Instructions (Ir) counted by verification/bench/callgrind/count.sh; columns: solve, function, count."
  fftw=$(pkg-config --modversion fftw3 2> /dev/null || echo unknown)
  echo "# $(valgrind --version), $(${CXX:-c++} --version | sed -n 1p), FFTW $fftw"
} > "$folder/head"

: > "$folder/counts"
printf '%s\n' "$solves" > "$folder/solves"
while IFS='	' read -r name arguments; do
  echo "counting: ehd solve $arguments" >&2
  # shellcheck disable=SC2086  # a list of words
  if ! valgrind --quiet --tool=callgrind --callgrind-out-file="$folder/out" \
    "$program" solve $arguments > "$folder/log" 2>&1; then
    cat "$folder/log" >&2
    echo "count.sh: ehd solve $arguments: failed under valgrind" >&2
    exit 1
  fi
  callgrind_annotate --threshold=100 --auto=no "$folder/out" | by_function "$name" > "$folder/one" \
    || { echo "count.sh: ehd solve $arguments: callgrind_annotate gives no total" >&2; exit 1; }
  sort -t '	' -k 3,3nr -k 2,2 "$folder/one" >> "$folder/counts"
done < "$folder/solves"
cat "$folder/head" "$folder/counts" > "$folder/new"

if [ "$keep" = yes ]; then
  cp "$folder/new" "$kept"
  echo "kept in $kept"
  grep '	total	' "$folder/counts"
  exit 0
fi
[ -f "$kept" ] || { echo "count.sh: $kept is missing; --keep makes it" >&2; exit 2; }

if [ "$(sed -n 2p "$kept")" != "$(sed -n 2p "$folder/new")" ]; then
  echo "other tools than those of the kept counts, which may explain a difference:"
  sed -n 's/^# /  kept /p' "$kept" | sed -n 2p
  sed -n 's/^# /  now  /p' "$folder/new" | sed -n 2p
fi
awk -F '\t' '
  /^#/ { next }
  NR == FNR { before[$1 FS $2] = $3; next }
  { after[$1 FS $2] = $3; order[++count] = $1 FS $2 }
  $2 == "total" { whole[$1] = $3 }
  END {
    for (key in before) if (!(key in after)) order[++count] = key
    for (i = 1; i <= count; ++i) {
      key = order[i]; split(key, part, FS)
      b = before[key] + 0; a = after[key] + 0
      ratio = 0
      if (b) ratio = a / b
      if (part[2] == "total") printf "%-14s total %15.0f -> %15.0f  x %.4f\n", part[1], b, a, ratio
      # A function that falls just below the list has not vanished: what counts is the change against the whole.
      change = a > b ? a - b : b - a
      if (change <= 0.02 * b || change < whole[part[1]] / 1000) continue
      moved = 1
      if (b == 0) line = sprintf("%15s -> %15.0f", "-", a)
      else if (a == 0) line = sprintf("%15.0f -> %15s", b, "-")
      else line = sprintf("%15.0f -> %15.0f  x %.4f", b, a, ratio)
      lines = lines sprintf("%-14s %s  %s\n", part[1], line, part[2])
    }
    if (moved) { print "moved by more than 2 %:"; printf "%s", lines }
    else print "nothing moved by more than 2 %"
    exit moved
  }' "$kept" "$folder/new"
