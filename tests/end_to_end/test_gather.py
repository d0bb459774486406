# SPDX-License-Identifier: MIT
"""Studies on a cluster on which nothing plays by itself: small programs stand for those of Slurm. Tasks are run by hand."""

import json
import os

import slurm
import tournament

DOCUMENT = """tournament: small_one
teams:
  - {team: small.yaml}
  - {team: other.yaml}
pairs: 4
openings: scenes
"""


class Gather(tournament.Tournament):
    def setUp(self):
        super().setUp()
        slurm.stand_ins(self.folder / "path")
        self.write("study.yaml", DOCUMENT)
        self.succeed("run", "study.yaml", "--on", "slurm", "--folder", "study.cluster", "--quiet", "--detach", "--array", 1,
                     "--per-task", 6)

    def environment(self, changes=None):
        return super().environment({"PATH": f"{self.folder / 'path'}:{os.environ['PATH']}", **(changes or {})})

    def description(self):
        return json.loads((self.folder / "study.cluster" / "cluster.json").read_text())

    def progress(self):
        return self.description()["progress"]

    def gather(self):
        self.succeed("gather", "study.cluster", "--quiet", "--no-page")

    def test_five_batches_that_bring_nothing_fail(self):
        for batches in (2, 3, 4, 5):
            self.gather()
            self.assertEqual(len(self.progress()["batches"]), batches)
        said = self.refused("gather", "study.cluster", "--quiet")
        self.assertIn("5 batches in a row brought no match; what their tasks wrote stands in", said)
        self.assertIn("to go on: regista resume", said)
        self.assertEqual(self.progress()["state"], "failed")
        self.assertEqual(len(self.progress()["batches"]), 5)
        # Who goes on begins to count anew, and so does a study that got a match.
        self.succeed("resume", "study.cluster", "--quiet")
        self.assertEqual((self.progress()["state"], self.progress()["fruitless"]), ("running", 0))
        self.gather()
        self.assertEqual(self.progress()["fruitless"], 1)
        self.succeed("cluster-task", "study.cluster", len(self.progress()["batches"]), 0)
        self.gather()
        self.assertEqual(self.progress()["fruitless"], 0)
        self.assertGreater(self.progress()["rows"], 0)

    def test_tasks_by_hand_bring_the_study_to_its_end(self):
        local = self.succeed("run", "study.yaml", "--quiet", "--no-page", "--results", "local.db")
        while self.progress()["state"] == "running":
            self.succeed("cluster-task", "study.cluster", len(self.progress()["batches"]), 0)
            self.gather()
        self.assertEqual(self.succeed("report", "study.cluster/results.db"), local)
        self.assertEqual(self.rows("study.cluster/results.db"), self.rows("local.db"))

    def test_a_description_that_is_none_submits_nothing(self):
        file = self.folder / "study.cluster" / "cluster.json"
        before = file.read_text()
        for harm, said in ((lambda all: all.update(study_folder=2), "cluster.json was written by another version of Regista"),
                           (lambda all: all["progress"].update(state="resting"), "cluster.json is damaged"),
                           (lambda all: all["progress"].pop("rows"), "cluster.json is damaged")):
            description = json.loads(before)
            harm(description)
            file.write_text(json.dumps(description))
            self.assertIn(said, self.refused("gather", "study.cluster", "--quiet"))
        file.write_text(before)
        self.gather()
