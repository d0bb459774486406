# SPDX-License-Identifier: MIT
"""A cluster of two nodes on this machine: Slurm of the Debian packages (scripts/setup cluster), on the loopback address,
in a folder of its own, with a key of its own. Nothing of the system's own Slurm is touched.

Its nodes have no tasks in common: each has `slots` of them. proctrack/linuxproc and task/none need no control groups.
"""

import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
import time

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol", "sinfo")

CONFIGURATION = """\
ClusterName=regista
SlurmctldHost=localhost(127.0.0.1)
SlurmctldPort={ports[0]}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool.%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1,batch_sched_delay=0,sched_min_interval=0
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SlurmdParameters=config_overrides
JobRequeue=1
KillWait=5
MinJobAge=600
SlurmctldTimeout=60
SlurmdTimeout=60
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why no Slurm can be started here; empty: it can."""
    paths = os.environ.get("PATH", "") + ":/usr/sbin:/sbin"
    missing = [name for name in PROGRAMS if not shutil.which(name, path=paths)]
    return f"{', '.join(missing)} not installed; scripts/setup cluster does it" if missing else ""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def stand_ins(folder):
    """Programs in a new folder that stand for those of Slurm: every job is taken, and none plays."""
    folder.mkdir(parents=True)
    for name, says in (("sbatch", "echo 1"), ("squeue", "true"), ("scancel", "true")):
        (folder / name).write_text(f"#!/bin/sh\n{says}\n")
        (folder / name).chmod(0o755)


class CannotStart(Exception):
    pass


class Slurm:
    """Runs from start() to stop(). environment: what commands of Slurm need to find it."""

    def __init__(self, slots=2, nodes=2):
        self.slots, self.nodes = slots, [f"node{i + 1}" for i in range(nodes)]
        self.temporary = tempfile.TemporaryDirectory(prefix="regista-slurm-")
        self.folder = pathlib.Path(self.temporary.name)
        self.environment = {"SLURM_CONF": str(self.folder / "slurm.conf"),
                            "PATH": os.environ.get("PATH", "") + ":/usr/sbin:/sbin"}
        self.processes = []

    def run(self, *words, check=True):
        done = subprocess.run(words, env={**os.environ, **self.environment}, capture_output=True, text=True, timeout=120)
        if check and done.returncode != 0:
            raise CannotStart(f"{words[0]}: {done.stderr.strip()}")
        return done.stdout

    def begin(self, *words):
        with open(self.folder / f"{words[0]}.out", "a") as log:
            self.processes.append(subprocess.Popen(words, env={**os.environ, **self.environment}, stdout=log, stderr=log,
                                                   stdin=subprocess.DEVNULL))

    def start(self):
        os.chmod(self.folder, 0o755)
        (self.folder / "state").mkdir()
        ports = free_ports(1 + len(self.nodes))
        lines = "\n".join(f"NodeName={name} NodeHostname=localhost NodeAddr=127.0.0.1 Port={port} CPUs={self.slots} "
                          "RealMemory=2000 State=UNKNOWN" for name, port in zip(self.nodes, ports[1:]))
        (self.folder / "slurm.conf").write_text(CONFIGURATION.format(
            ports=ports, folder=self.folder, user=pwd.getpwuid(os.getuid()).pw_name, nodes=lines))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        self.begin("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                   f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                   f"--seed-file={self.folder}/munge.seed")
        self.wait(lambda: (self.folder / "munge.socket").exists(), "munged")
        self.begin("slurmctld", "-D")
        for name in self.nodes:
            self.begin("slurmd", "-D", "-N", name)
        self.wait(lambda: self.run("sinfo", "--noheader", "--format=%D %t", check=False).split() ==
                  [str(len(self.nodes)), "idle"], "slurmd")

    def wait(self, condition, who):
        end = time.monotonic() + 60
        while not condition():
            if time.monotonic() > end:
                raise CannotStart(f"{who} does not come up: {self.logs()}")
            time.sleep(0.1)

    def logs(self):
        return "\n".join(f"{file.name}: {file.read_text(errors='replace')[-600:]}"
                         for file in sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out")))

    def jobs(self):
        return self.run("squeue", "--noheader", "--format=%i %T").splitlines()

    def stop(self):
        self.run("scancel", "--quiet", f"--user={os.getuid()}", check=False)
        for each in reversed(self.processes):
            each.send_signal(signal.SIGTERM)
        for each in reversed(self.processes):
            try:
                each.wait(timeout=10)
            except subprocess.TimeoutExpired:
                each.kill()
                each.wait()
        self.temporary.cleanup()
