#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# hardened.sh PROGRAM: the program, or library, has what cmake/hardening.cmake asks for; names what is missing.
set -eu
program=$1
missing=""
has() {  # WHAT PATTERN READELF-OPTIONS
  readelf "$3" "$program" | grep -q "$2" || missing="$missing $1"
}
has PIE 'Type: *DYN' -hW
has relro GNU_RELRO -lW
has now BIND_NOW -dW
has stack-protector __stack_chk_fail -sW
has _FORTIFY_SOURCE '_chk@' -sW
[ -z "$missing" ] || { echo "hardened.sh: $program: is without$missing"; exit 1; }
