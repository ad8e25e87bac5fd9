#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# symbols.sh LIBRARY HEADER: the library shows the functions of ehd/ehd.h and nothing else.
set -eu
library=$1
header=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort > "$folder/shown"
sed -n 's/^EHD_API .*[ *]\(ehd_[a-z_]*\)(.*/\1/p' "$header" | sort > "$folder/declared"
[ "$(wc -l < "$folder/declared")" -ge 12 ] || { echo "symbols.sh: $header: too few functions were read"; exit 1; }
diff "$folder/declared" "$folder/shown" || { echo "symbols.sh: < declared, > shown by $library"; exit 1; }
