#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# try.sh FOLDER: installs the packages of FOLDER, uses them as an ordinary user does, and removes them. Fails where the
# use fails or a file is left. Needs root, and a machine where none of the packages is installed.
set -eu
packages="ehd libehd0 libehd-dev python3-ehd"
[ "$(id -u)" = 0 ] || { echo "try.sh: the packages were not tried: only root may install them"; exit 0; }
for package in $packages; do
  if dpkg-query -W -f '${Status}' "$package" 2> /dev/null | grep -q 'ok installed'; then
    echo "try.sh: $package is installed already; remove it first"; exit 1
  fi
done
work=$(mktemp -d)
chmod 755 "$work"
trap 'dpkg --purge $packages > /dev/null 2>&1 || true; rm -rf "$work"' EXIT
DEBIAN_FRONTEND=noninteractive apt-get install -y -qq "$(realpath "$1")"/*.deb > "$work/apt.log" 2>&1 \
  || { cat "$work/apt.log"; exit 1; }
for package in $packages; do dpkg -L "$package"; done | sort -u > "$work/listed"

cat > "$work/use.c" << 'END'
#include <ehd/ehd.h>
#include <stdio.h>
int main(void) {
  ehd_result *result = NULL;
  double film = 0;
  int code = ehd_solve_moes(20, 10, NULL, "fast", 1e-3, &result);
  if (code != EHD_OK) return puts(ehd_last_error()), code;
  ehd_get(result, "film.minimum.hertz", &film);
  ehd_free(result);
  return film > 0 ? EHD_OK : EHD_NOT_MET;
}
END
cc "$work/use.c" -o "$work/use" $(pkg-config --cflags --libs ehd)
as_user() {
  setpriv --reuid=nobody --regid=nogroup --clear-groups env HOME="$work" PATH=/usr/bin:/bin sh -ec "cd /; $1"
}
as_user "ehd solve --M 20 --L 10" > /dev/null
as_user "ehd bearing na4908" > /dev/null
as_user "man -w ehd" > /dev/null
as_user "$work/use"
as_user "/usr/bin/python3 -c 'import ehd; assert ehd.solve(M=20, L=10).status == \"converged\"'"

dpkg --purge $packages > "$work/purge.log" 2>&1 || { cat "$work/purge.log"; exit 1; }
left=$(while read -r file; do [ -d "$file" ] || [ ! -e "$file" ] || echo "$file"; done < "$work/listed"
       find / -xdev \( -path /usr/share/ehd -o -path /usr/lib/python3/dist-packages/ehd \) 2> /dev/null)
[ -z "$left" ] || { echo "try.sh: left after the packages were removed:"; echo "$left"; exit 1; }
echo "installed, used by an ordinary user, and removed with nothing left: $packages"
