#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# tests/fuzz/run.sh BUILD SECONDS TARGET...: fuzzes BUILD/ehd_fuzz_TARGET, each for SECONDS, JOBS (1) of them side by
# side, from the kept inputs. out/fuzz/TARGET keeps what reached new code, for the next run, the log, and what was
# found.
# Exit code 0: no promise was broken; 1: one was.
set -eu
cd "$(dirname "$0")/../.."

fuzz() {
  target=$3
  folder=out/fuzz/$target
  log=$folder/fuzz.log
  mkdir -p "$folder/corpus"
  seeds="tests/fuzz/corpus/$target"
  [ ! -d "tests/fuzz/found/$target" ] || seeds="$seeds tests/fuzz/found/$target"
  dictionary=tests/fuzz/$target.dict
  longest=4096  # holds every case
  case $target in
    case) seeds="$seeds cases" ;;
    sweep) seeds="$seeds examples/sweeps"; dictionary=tests/fuzz/case.dict ;;
    results) longest=16384 ;;  # a page with every section
  esac
  words=""
  [ ! -e "$dictionary" ] || words=-dict=$dictionary
  # shellcheck disable=SC2086  # lists of folders
  # A fixed seed: two runs of as many inputs from the same corpus are the same. No input needs 5 s.
  if "$1/ehd_fuzz_$target" -seed=20261121 -max_total_time="$2" -timeout=5 -max_len=$longest $words \
    -artifact_prefix="$folder/" "$folder/corpus" $seeds > "$log" 2>&1; then
    echo "fuzz, $target: $(grep '^Done ' "$log" | tail -n 1 | sed 's/^Done //'), no promise broken"
    return 0
  fi
  grep -E "^broken promise|ERROR|SUMMARY|Test unit written" "$log" >&2 || tail -n 20 "$log" >&2
  echo "fuzz, $target: found an input, kept in $folder (log: $log); docs/fuzzing.md says what to do with it" >&2
  return 1
}

if [ "${FUZZ_ONE:-}" = yes ]; then
  fuzz "$@"
  exit
fi
build=$1
seconds=$2
shift 2
export FUZZ_ONE=yes
printf '%s\n' "$@" | xargs -P "${JOBS:-1}" -n 1 "$0" "$build" "$seconds" || exit 1
