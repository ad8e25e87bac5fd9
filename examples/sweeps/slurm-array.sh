#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# A sweep as a Slurm array, one task a shard, and the merge when all have ended:
#   job=$(sbatch --parsable --array=1-8 examples/sweeps/slurm-array.sh FILE FOLDER)
#   sbatch --dependency="afterany:$job" --wrap "ehd sweep FILE --output FOLDER --merge"
# A task that was stopped is started again with the same line and goes on where it was.
#SBATCH --job-name=ehd-sweep
#SBATCH --cpus-per-task=2
#SBATCH --mem-per-cpu=1G
#SBATCH --time=01:00:00
set -eu
exec "${EHD:-ehd}" sweep "$1" --output "$2" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" \
  --threads "${SLURM_CPUS_PER_TASK:-1}"
