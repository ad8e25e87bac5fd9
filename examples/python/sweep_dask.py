#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The films of many contacts over the processes of a Dask cluster: the same bits as in this process.

    python3 examples/python/sweep_dask.py [--contacts 10000] [--workers 2]

Here the cluster is this machine; Client("scheduler:8786") takes another one. Packages: python3-distributed.
"""

import argparse

import ehd
import numpy as np
from dask.distributed import Client, LocalCluster


def some_films(M, L):
    """What one task does: contacts enough that sending them costs nothing, in one thread."""
    return ehd.films(M, L, tolerance=1e-4, threads=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--contacts", type=int, default=10_000)
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()

    random = np.random.default_rng(seed=1)
    M = np.exp(random.uniform(np.log(2), np.log(1000), options.contacts))
    L = random.uniform(2, 15, options.contacts)
    tasks = 4 * options.workers

    with LocalCluster(n_workers=options.workers, threads_per_worker=1, dashboard_address=None) as cluster, \
         Client(cluster) as client:
        parts = client.gather(client.map(some_films, np.array_split(M, tasks), np.array_split(L, tasks)))
        # One contact, as a whole result with its fields.
        far = client.submit(ehd.solve, M=20, L=10).result()

    here = ehd.films(M, L, tolerance=1e-4)
    for name in ("minimum", "minimum_error", "central", "central_error", "status"):
        there = np.concatenate([getattr(part, name) for part in parts])
        assert there.tobytes() == getattr(here, name).tobytes(), name
    assert far.P.tobytes() == ehd.solve(M=20, L=10).P.tobytes()
    print(f"{options.contacts} contacts over {options.workers} processes: the same bits; "
          f"{np.count_nonzero(here.status == 'converged')} converged")


if __name__ == "__main__":
    main()
