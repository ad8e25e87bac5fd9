#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the apt packages that the build needs and that are missing; touches nothing else. Without root it names
# them and ends with exit code 2. On a system without dpkg it leaves the search to CMake.
set -eu

required="g++ cmake pkg-config libeigen3-dev libfftw3-dev libgsl-dev libboost-test-dev libtomlplusplus-dev \
nlohmann-json3-dev libcli11-dev libfmt-dev libxxhash-dev python3"
# Ninja builds faster, make kernels needs the benchmark library, the test of the Python package NumPy and pytest,
# --plot FILE.png rsvg-convert. Everything else works without these.
optional="ninja-build libbenchmark-dev python3-numpy python3-pytest librsvg2-bin"

command -v dpkg-query > /dev/null 2>&1 || exit 0

is_installed() {
  case "$1" in  # a tool counts wherever it comes from
    g++ | cmake | pkg-config | valgrind | python3 | clang-format | clang-tidy | npm)
      command -v "$1" > /dev/null 2>&1 && return 0 ;;
    clang) command -v clang++ > /dev/null 2>&1 && return 0 ;;
    libclang-rt-dev)
      ls "$(clang++ -print-runtime-dir 2> /dev/null)"/libclang_rt.fuzzer-*.a > /dev/null 2>&1 && return 0 ;;
    ninja-build) command -v ninja > /dev/null 2>&1 && return 0 ;;
  esac
  dpkg-query -W -f '${db:Status-Status}\n' "$1" 2> /dev/null | grep -q '^installed$'
}

missing=""
# What a target needs beside the build: sh cmake/setup.sh valgrind
for package in $required "$@"; do
  is_installed "$package" || missing="$missing $package"
done
is_root=$([ "$(id -u)" -eq 0 ] && echo yes || echo no)
missing_optional=""
for package in $optional; do
  is_installed "$package" || missing_optional="$missing_optional $package"
done
[ -z "$missing$missing_optional" ] && exit 0
[ -z "$missing" ] && [ "$is_root" = no ] && exit 0

if [ "$is_root" = no ]; then
  echo "These packages are missing; install them as root with:" >&2
  echo "  apt-get install --no-install-recommends$missing$missing_optional" >&2
  exit 2
fi

echo "Installing$missing$missing_optional" >&2
log=$(mktemp)
trap 'rm -f "$log"' EXIT
export DEBIAN_FRONTEND=noninteractive
install() { apt-get -qq install -y --no-install-recommends "$@" >> "$log" 2>&1; }
apt-get -qq update > "$log" 2>&1 || true  # an old list may still do
# shellcheck disable=SC2086  # lists of words
if [ -n "$missing" ] && ! install $missing; then
  cat "$log" >&2
  echo "apt-get could not install:$missing" >&2
  exit 2
fi
# shellcheck disable=SC2086
[ -z "$missing_optional" ] || install $missing_optional || echo "going on without$missing_optional" >&2
