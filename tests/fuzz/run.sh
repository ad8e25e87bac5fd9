#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/fuzz/run.sh PROGRAM SECONDS [FOLDER]: fuzzes from the kept inputs and the benchmark cases. FOLDER (out/fuzz)
# keeps what reached new code, for the next run, and what was found. Exit code 0: no promise was broken; 1: one was.
set -eu
cd "$(dirname "$0")/../.."
program=$1
seconds=$2
folder=${3:-out/fuzz}
mkdir -p "$folder/corpus"
log="$folder/fuzz.log"

# A fixed seed: two runs of as many inputs from the same corpus are the same. 4 KiB hold every case; no input needs 5 s.
status=0
"$program" -seed=20261121 -max_total_time="$seconds" -timeout=5 -max_len=4096 -dict=tests/fuzz/toml.dict \
  -artifact_prefix="$folder/" "$folder/corpus" tests/fuzz/corpus tests/fuzz/found cases > "$log" 2>&1 || status=$?
if [ "$status" -ne 0 ]; then
  grep -E "^broken promise|ERROR|SUMMARY|Test unit written" "$log" >&2 || tail -n 20 "$log" >&2
  echo "fuzzing found an input, kept in $folder (log: $log); docs/fuzzing.md says what to do with it" >&2
  exit 1
fi
echo "fuzz: $(grep '^Done ' "$log" | tail -n 1 | sed 's/^Done //'), no promise broken"
