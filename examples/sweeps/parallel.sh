#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep in N processes by GNU parallel, on this machine or (with --sshlogin and a shared folder) on several:
#   examples/sweeps/parallel.sh FILE FOLDER N
# An interrupted one goes on where it was with the same command. EHD names the program, else it is looked up.
set -eu
file=$1 folder=$2 shards=$3
ehd=${EHD:-ehd}
# A row that does not converge ends its shard with 1, and the merge below says which; 2 and more is a fault.
seq "$shards" \
  | parallel --halt soon,fail=100% "$ehd" sweep "$file" --output "$folder" --shard "{}/$shards" --threads 1 || true
exec "$ehd" sweep "$file" --output "$folder" --merge
