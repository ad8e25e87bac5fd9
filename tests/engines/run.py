#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the scripts of examples/sweeps under the engines that they are written for, on this machine.

    tests/engines/run.py build/ehd              every engine
    tests/engines/run.py build/ehd mpirun       some: parallel, mpirun, slurm-array, srun

Each engine has to make the rows of one process, bit for bit: at the first start, and when one of its tasks was killed
(kill -9) with rows left and the same line is started again. Slurm runs on one node, this machine, with a configuration
and a munge key of its own (slurm.py). Exit code: 0 every engine did; 1 one did not, or its program is not installed;
2 wrong usage."""

import argparse
import filecmp
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
from slurm import Slurm  # noqa: E402

SCRIPTS = HERE.parents[1] / "examples" / "sweeps"
TASKS = 2  # as many as a small machine has cores
WAIT_S = 240  # for one start of an engine; it takes some 5 s
# Rows with films, so that a task works long enough to be killed with rows left.
SWEEP = """case = "na4908"
laws = ["hertz", "ehd"]
combine = "product"
[keys]
"operation.speed_rpm" = [2000.0, 3000.0, 4000.0, 5000.0, 6000.0, 7000.0, 8000.0, 9000.0]
"operation.radial_load_N" = [20e3, 50e3]
"""


class Wrong(Exception):
    """What an engine did not do."""


class Trial:
    """One engine, one folder: what is started, and what has to come out."""

    def __init__(self, ehd, folder, whole):
        self.ehd, self.folder, self.whole = ehd, folder, whole
        self.file, self.output = whole.parent / "sweep.toml", folder / "out"

    def journal(self, number):
        return self.output / "shards" / f"{number}-of-{TASKS}" / "journal"

    def require_same_rows(self):
        for name in ("rows.csv", "rows.json"):
            if not (self.output / name).exists():
                raise Wrong(f"{name} is not there")
            if not filecmp.cmp(self.output / name, self.whole / name, shallow=False):
                raise Wrong(f"{name} differs from that of one process")

    def task(self):
        """The process of task 1, found by its arguments; None where it does not run (yet)."""
        wanted = [str(self.output), "--shard", f"1/{TASKS}"]
        for entry in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
            try:
                words = entry.read_bytes().decode(errors="replace").split("\0")
            except OSError:
                continue
            if words[0].endswith("ehd") and all(word in words for word in wanted):
                return int(entry.parent.name)
        return None

    def kill_a_task(self, stop):
        """Kills task 1 after its first row; True where it had rows left."""
        while time.monotonic() < stop:
            process = self.task()
            rows = self.journal(1).read_bytes().count(b"\n") - 1 if self.journal(1).exists() else 0
            if process and rows > 0:
                os.kill(process, signal.SIGKILL)
                return True
            time.sleep(0.01)
        return False


def ended(command, seconds=WAIT_S, **how):
    """(exit code, what it said) of a command."""
    run = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False, **how)
    return run.returncode, (run.stdout + run.stderr).strip()


def merge(trial):
    code, said = ended([trial.ehd, "sweep", trial.file, "--output", trial.output, "--merge"])
    if code != 0:
        raise Wrong(f"merge: exit code {code}: {said}")


# ---- engines: each starts all tasks, waits for them, and merges where they have ended well


def parallel(trial, _slurm):
    return [SCRIPTS / "parallel.sh", trial.file, trial.output, str(TASKS)], False


def mpirun(trial, _slurm):
    return ["mpirun", "--oversubscribe", "-n", str(TASKS), SCRIPTS / "rank.sh", trial.file, trial.output], True


def srun(trial, _slurm):
    return ["srun", "-n", str(TASKS), SCRIPTS / "rank.sh", trial.file, trial.output], True


def slurm_array(trial, _slurm):
    return ["sbatch", "--wait", "--output", trial.folder / "task-%a.log", f"--array=1-{TASKS}",
            SCRIPTS / "slurm-array.sh", trial.file, trial.output], True


# Name: how it is started, and the programs that it needs.
ENGINES = {
    "parallel": (parallel, ["parallel"]),
    "mpirun": (mpirun, ["mpirun"]),
    "slurm-array": (slurm_array, ["sbatch", "slurmctld", "slurmd", "munged"]),
    "srun": (srun, ["srun", "slurmctld", "slurmd", "munged"]),
}


def run_engine(start, trial, environment):
    command, merges = start(trial, None)
    code, said = ended(command, env=environment)
    if code != 0:
        raise Wrong(f"exit code {code}: {said[-500:]}")
    if merges:
        merge(trial)
    trial.require_same_rows()


def run_killed_engine(start, trial, environment):
    """The same, with a task killed at its first row."""
    command, _ = start(trial, None)
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    killed = trial.kill_a_task(time.monotonic() + WAIT_S)
    process.wait(WAIT_S)
    if not killed:
        raise Wrong("no task could be killed")
    code, said = ended([trial.ehd, "sweep", trial.file, "--output", trial.output, "--merge"])
    if code != 2 or "--shard 1/" not in said:
        raise Wrong(f"after the kill the merge should name shard 1; exit code {code}: {said}")
    run_engine(start, trial, environment)


def try_engine(name, ehd, folder, environment):
    """What is wrong with the engine; None where nothing is."""
    start, programs = ENGINES[name]
    missing = [program for program in programs if not shutil.which(program, path=environment["PATH"])]
    if missing:
        return f"not installed: {', '.join(missing)}"
    try:
        for number, run in enumerate((run_engine, run_killed_engine)):
            own = folder / f"{name}-{number}"
            own.mkdir()
            run(start, Trial(ehd, own, folder / "whole"), environment)
    except (Wrong, subprocess.TimeoutExpired) as wrong:
        return f"{'killed and started again' if number else 'first start'}: {wrong}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("engines", nargs="*", metavar="ENGINE", help=", ".join(ENGINES))
    arguments = parser.parse_args()
    for name in arguments.engines:
        if name not in ENGINES:
            parser.error(f"{name} is no engine; allowed is {', '.join(ENGINES)}")
    ehd = str(pathlib.Path(arguments.program).resolve())
    # Slurm's daemons stand in /usr/sbin. Open MPI refuses root unless it is told twice.
    environment = {**os.environ, "EHD": ehd, "PATH": os.environ["PATH"] + ":/usr/sbin",
                   "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    names = arguments.engines or list(ENGINES)
    failed = 0
    with tempfile.TemporaryDirectory(prefix="ehd-engines-") as scratch:
        folder = pathlib.Path(scratch)
        (folder / "sweep.toml").write_text(SWEEP)
        code, said = ended([ehd, "sweep", folder / "sweep.toml", "--output", folder / "whole"])
        if code != 0:
            parser.error(f"{ehd}: the sweep does not run: {said}")
        with Slurm(folder / "slurm", environment, any("s" == name[0] for name in names)) as slurm:
            for name in names:
                begin = time.monotonic()
                why = slurm.wrong if name[0] == "s" and slurm.wrong else try_engine(name, ehd, folder, environment)
                failed += bool(why)
                print(f"{name:12} {'FAILED' if why else 'same rows, also after a kill'}  "
                      f"{time.monotonic() - begin:.1f} s{'  ' + why if why else ''}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
