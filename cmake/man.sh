#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# man.sh PROGRAM FOLDER: manual pages by help2man from the program's own help, one for the program (ehd.1.gz) and one a
# subcommand (ehd-solve.1.gz).
set -eu
program=$1
folder=$2
name=$(basename "$program")
version=$("$program" --version | sed -n '1s/^[^ ]* \([^ ]*\).*/\1/p')
mkdir -p "$folder"

page() {  # COMMAND SUMMARY NAME
  help2man --no-info --version-string "$3 $version" --name "$2" "$1" > "$folder/$3.1"
  gzip -9nf "$folder/$3.1"
}

list=$(mktemp)
trap 'rm -f "$list"' EXIT
"$program" --help > "$list"
page "$program" "$(head -n 1 "$list")" "$name"
# A summary may go on in the next line, which is indented further.
awk '/^Subcommands:/ { listed = 1; next }
     listed && /^$/ { exit }
     listed && /^  [a-z]/ { if (line) print line; line = $1; $1 = "" }
     listed { sub(/^ */, ""); line = line " " $0 }
     END { if (line) print line }' "$list" | while read -r command summary; do
  page "$program $command" "$summary" "$name-$command"
done
[ -f "$folder/$name-solve.1.gz" ] || { echo "man.sh: no subcommand was found in the help of $program" >&2; exit 1; }
