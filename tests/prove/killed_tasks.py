# SPDX-License-Identifier: MIT
"""A tournament, an experiment and a tuning on a Slurm of two nodes whose tasks are killed, cancelled and requeued at random
moments: what they say is byte for byte what one undisturbed local worker says.

    REGISTA_KILLS   of each study; default 40
    REGISTA_SEED    of the moments; default: a new one, which is printed
"""

import os
import random
import unittest

import experiment
import test_tune
from cluster import OnCluster, cluster, setUpModule, tearDownModule  # noqa: F401
import test_cluster

KILLS = int(os.environ.get("REGISTA_KILLS", "40"))
SEED = int(os.environ.get("REGISTA_SEED") or random.randrange(1_000_000))


class Harmed:
    def harm_to_the_end(self):
        """Where so much harm was done that several batches in a row brought no match, the study is gone on with."""
        lately = self.harm(KILLS, SEED)
        done, resumed = lately, 0
        while True:
            self.wait_for(lambda: self.progress()["state"] != "running")
            if self.progress()["state"] == "complete":
                break
            message = self.progress()["message"]
            self.assertIn("batches in a row brought no match", message)
            self.assertGreater(sum(lately.values()), 4, message)  # else it failed by itself
            resumed += 1
            self.succeed("resume", "study.cluster", "--quiet")
            lately = self.harm(KILLS - sum(done.values()), SEED + resumed)
            done = {each: count + lately[each] for each, count in done.items()}
        self.wait_for_end()
        return {**done, "resumed": resumed}

    def harm_until_done(self, document, *more):
        local = self.succeed("run", document, "--quiet", "--no-page", "--workers", 1, "--results", "local.db")
        self.begin(document, *more)
        done = self.harm_to_the_end()
        self.assertGreater(min(count for each, count in done.items() if each != "resumed"), 0,
                           "it ended before it was harmed in every way")
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))
        self.assert_same_reports("study.cluster/results.db", "local.db")
        batches = self.progress()["batches"]
        print(f"\nof {self.id().split('.')[-1]}: {', '.join(f'{each} {count}' for each, count in done.items())}; "
              f"{len(batches)} batches, {sum(each['tasks'] for each in batches)} tasks, {self.count('local.db')} matches",
              flush=True)
        return local


class Tournament(Harmed, OnCluster):
    def test_tournament(self):
        self.write("study.yaml", test_cluster.DOCUMENT.replace("PAIRS", "60"))
        self.harm_until_done("study.yaml", "--array", 4, "--per-task", 45)

    def test_sequential(self):
        self.write("study.yaml", test_cluster.TEST.replace("worse", "other").replace("pairs: 60", "pairs: 100"))
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--workers", 1, "--results", "local.db")
        self.begin("study.yaml", "--array", 4, "--per-task", 8)
        done = self.harm_to_the_end()
        self.assertGreater(sum(done.values()), 0, "it ended before it was harmed")
        self.assert_same_reports("study.cluster/results.db", "local.db")
        beyond = self.count("study.cluster/results.db") - self.count("local.db")
        print(f"\nof test_sequential: {', '.join(f'{each} {count}' for each, count in done.items())}; "
              f"{beyond} matches beyond the test's end of {self.count('local.db')}", flush=True)


class Experiment(Harmed, OnCluster, experiment.Experiment):
    def test_experiment(self):
        self.document(changes=(("matches: 4", "matches: 60"),))
        self.harm_until_done("e.yaml", "--array", 4, "--per-task", 30)


class Tuning(Harmed, OnCluster, test_tune.Tuning):
    def tune_harmed(self, algorithm):
        self.document(algorithm=algorithm, matches=200)
        self.harm_until_done("t.yaml", "--array", 4, "--per-task", 10)
        teams = [(self.folder / file).read_text() for file in ("study.cluster/results.tuned.yaml", "local.tuned.yaml")]
        self.assertEqual(*(each[each.index("\nutility:"):] for each in teams))  # what stands before it is called by the file

    def test_sep_cma_es(self):
        self.tune_harmed("sep_cma_es")

    def test_spsa(self):
        self.tune_harmed("spsa")


if __name__ == "__main__":
    print(f"REGISTA_SEED={SEED}, up to {KILLS} of each study", flush=True)
    unittest.main()
