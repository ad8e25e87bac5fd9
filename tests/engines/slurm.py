# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of one node on this machine's loopback, with a munge of its own. Both end with it."""

import getpass
import os
import shutil
import socket
import subprocess
import time

START_S = 60  # until the node is idle; it takes some 5 s
# CPUs and memory are stated, not found (config_overrides): a task of slurm-array.sh asks for 2 CPUs and 2 GB.
CONF = """ClusterName=ehd
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
SlurmctldPort={controller}
SlurmdPort={node}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 RealMemory=8000 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Slurm:
    """`wrong` says why there is none. `environment` gets SLURM_CONF."""

    def __init__(self, folder, environment, wanted):
        self.folder, self.environment, self.daemons, self.wrong = folder, environment, [], None
        if wanted:
            self.wrong = self._start()

    def __enter__(self):
        return self

    def __exit__(self, *error):
        for daemon in reversed(self.daemons):
            daemon.terminate()
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def _start(self):
        missing = [name for name in ("munged", "slurmctld", "slurmd", "sinfo")
                   if not shutil.which(name, path=self.environment["PATH"])]
        if missing:
            return "not installed: " + ", ".join(missing)
        for name in ("", "state", "spool"):
            (self.folder / name).mkdir(mode=0o755)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)
        conf = self.folder / "slurm.conf"
        conf.write_text(CONF.format(host=socket.gethostname().split(".")[0], user=getpass.getuser(),
                                    folder=self.folder, controller=free_port(), node=free_port()))
        self.environment["SLURM_CONF"] = str(conf)
        munge = [f"--{what}={self.folder}/munge.{end}" for what, end in
                 (("key-file", "key"), ("socket", "socket"), ("pid-file", "pid"), ("seed-file", "seed"))]
        # --force: the folder stands in /tmp, which others may write.
        self._daemon("munged", ["--foreground", "--force", *munge])
        self._until(lambda: (self.folder / "munge.socket").exists())
        self._daemon("slurmctld", ["-D"])
        self._daemon("slurmd", ["-D"])
        if not self._until(lambda: "idle" in self._said("sinfo", "--noheader", "--format=%T")):
            return "Slurm does not start: " + " | ".join(self._last_line(name) for name in ("slurmctld", "slurmd"))
        return None

    def _daemon(self, name, arguments):
        with open(self.folder / f"{name}.out", "wb") as log:
            self.daemons.append(subprocess.Popen([name, *arguments], stdout=log, stderr=log, env=self.environment,
                                                 start_new_session=True))

    def _said(self, *command):
        return subprocess.run(command, capture_output=True, text=True, env=self.environment, check=False).stdout

    def _last_line(self, name):
        lines = (self.folder / f"{name}.out").read_text(errors="replace").strip().splitlines()
        return f"{name}: {lines[-1] if lines else 'says nothing'}"

    def _until(self, condition):
        stop = time.monotonic() + START_S
        while time.monotonic() < stop:
            if condition():
                return True
            time.sleep(0.2)
        return False
