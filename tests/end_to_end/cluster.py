# SPDX-License-Identifier: MIT
"""Studies on the Slurm of slurm.py: how they are begun, awaited and harmed. A test file that plays there takes
setUpModule and tearDownModule from here; it is skipped where Slurm cannot be started."""

import errno
import json
import os
import random
import signal
import time
import unittest

import slurm
import tournament

CLUSTER = None


def cluster():
    return CLUSTER


def setUpModule():
    global CLUSTER
    why = slurm.why_not()
    if why:
        raise unittest.SkipTest(why)
    CLUSTER = slurm.Slurm()
    try:
        CLUSTER.start()
    except slurm.CannotStart as error:
        CLUSTER.stop()
        CLUSTER = None
        raise unittest.SkipTest(f"Slurm cannot be started here: {error}") from error


def tearDownModule():
    if CLUSTER:
        CLUSTER.stop()


class OnCluster(tournament.Tournament):
    """Commands find the cluster; the study's folder is study.cluster."""

    def tearDown(self):
        CLUSTER.run("scancel", "--quiet", f"--user={os.getuid()}", check=False)
        self.wait_for(lambda: not CLUSTER.jobs())
        super().tearDown()

    def environment(self, changes=None):
        return super().environment({**CLUSTER.environment, **(changes or {})})

    def on_slurm(self, document, *more):
        return ["run", document, "--on", "slurm", "--folder", "study.cluster", "--quiet", *more]

    def begin(self, document, *more):
        self.succeed(*self.on_slurm(document, "--detach", *more))

    def progress(self):
        for tries_left in reversed(range(100)):
            try:
                return json.loads((self.folder / "study.cluster" / "cluster.json").read_text())["progress"]
            except OSError as error:
                if error.errno != errno.ESTALE or not tries_left:  # it was replaced just now, on a network file system
                    raise
            time.sleep(0.05)

    def wait_for_end(self):
        self.wait_for(lambda: self.progress()["state"] != "running")
        self.assertEqual(self.progress()["state"], "complete", self.progress()["message"])
        self.wait_for(lambda: not CLUSTER.jobs())

    def logs(self):
        return "\n".join(f"{each.name}: {each.read_text()}"
                         for each in sorted((self.folder / "study.cluster" / "log").iterdir()))

    def assert_same_reports(self, ours, theirs):
        for form in ((), ("--json",), ("--csv",)):
            self.assertEqual(self.succeed("report", ours, *form), self.succeed("report", theirs, *form))

    def tasks(self):
        """Processes of tasks of this study."""
        found = []
        for name in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{name}/cmdline", "rb") as file:
                    words = file.read().split(b"\0")
            except OSError:
                continue
            if len(words) > 2 and words[1] == b"cluster-task" and words[2] == str(self.folder / "study.cluster").encode():
                found.append(int(name))
        return found

    def harm(self, most, seed, least_wait=0.1, longest_wait=0.8):
        """While the study is played, at random moments: a task is killed, by us or by Slurm, or it is requeued. How often
        each was done."""
        chance = random.Random(seed)
        done = {"killed": 0, "cancelled": 0, "requeued": 0}
        while self.progress()["state"] == "running" and sum(done.values()) < most:
            time.sleep(chance.uniform(least_wait, longest_wait))
            tasks = self.tasks()
            jobs = [line.split()[0] for line in CLUSTER.jobs() if "RUNNING" in line and "_" in line.split()[0]]
            what = chance.choice(list(done))
            if not tasks or not jobs:
                continue
            if what == "killed":
                try:
                    os.kill(chance.choice(tasks), signal.SIGKILL)
                    done[what] += 1
                except ProcessLookupError:
                    pass
                continue
            words = ("scancel", "--signal=KILL", "--full") if what == "cancelled" else ("scontrol", "requeue")
            try:
                CLUSTER.run(*words, chance.choice(jobs))
                done[what] += 1
            except slurm.CannotStart:
                pass  # the job has ended
        return done
