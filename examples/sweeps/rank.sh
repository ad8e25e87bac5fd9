#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The shard of one process of a launcher that numbers its processes from 0; in a folder that all of them see:
#   srun -n 16 examples/sweeps/rank.sh FILE FOLDER              Slurm
#   mpirun -n 16 examples/sweeps/rank.sh FILE FOLDER            Open MPI, MPICH, Intel MPI
#   ehd sweep FILE --output FOLDER --merge                      when all have ended
# No MPI is linked: rows need not talk to each other. EHD names the program, else it is looked up.
set -eu
file=$1 folder=$2
rank=${OMPI_COMM_WORLD_RANK:-${PMI_RANK:-${SLURM_PROCID:-}}}
ranks=${OMPI_COMM_WORLD_SIZE:-${PMI_SIZE:-${SLURM_NTASKS:-}}}
if [ -z "$rank" ] || [ -z "$ranks" ]; then
  echo "rank.sh: no launcher says which process this is; start it by srun or mpirun" >&2
  exit 2
fi
exec "${EHD:-ehd}" sweep "$file" --output "$folder" --shard "$((rank + 1))/$ranks" --threads 1
