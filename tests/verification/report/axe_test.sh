#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# axe_test.sh EHD MADE_REPORT FOLDER: browser_test.sh with axe-core, which npm installs into FOLDER. Without npm, or
# where its registry cannot be reached, a line says "skipped" and the test goes on without axe-core: .ci/run is red at
# such a line. Exit code: that of browser_test.sh.
set -eu
version=4.14.1
here=$(cd "$(dirname "$0")" && pwd)
axe=$3/node_modules/axe-core/axe.min.js

if ! grep -q "\"version\": \"$version\"" "$3/node_modules/axe-core/package.json" 2> /dev/null; then
  mkdir -p "$3"
  why=
  if ! command -v npm > /dev/null 2>&1; then
    why="npm is not installed"
  elif ! timeout 60 npm install --prefix "$3" --no-save --no-audit --no-fund "axe-core@$version" \
      > "$3/npm.log" 2>&1; then
    why="npm could not install it: $(grep -m 1 -i error "$3/npm.log" || echo "no answer in 60 s")"
  fi
  if [ -n "$why" ]; then
    echo "axe-core: skipped: $why"
    axe=
  fi
fi
exec "$here/browser_test.sh" "$1" "$2" $axe
