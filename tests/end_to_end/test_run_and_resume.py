# SPDX-License-Identifier: MIT
"""`regista run` plays whatever study a document is, `regista resume` goes on with a file of results alone, with more pairs
if that may be, and `regista results` lists what lies in a folder."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import unittest

import program
import tournament

DOCUMENT = """tournament: small_one
question: Which is better?
teams:
  - {team: small.yaml}
  - {team: other.yaml}
pairs: PAIRS
limit: 5
set: {rules.durations.ready: 1, rules.durations.set: 1}
"""


EXPERIMENT = """experiment: arms
arms:
  - {name: one, team: small.yaml}
  - {name: two, team: other.yaml}
opponent: worse.yaml
matches: 2
limit: 5
set: {rules.durations.ready: 1, rules.durations.set: 1}
measures: [switches]
"""


class RunAndResume(tournament.Tournament):
    def document(self, pairs):
        self.write("study.yaml", DOCUMENT.replace("PAIRS", str(pairs)))

    def test_a_tournament_is_run_and_gone_on_with_from_another_folder(self):
        self.document(4)
        whole = self.succeed("run", "study.yaml", "--quiet", "--results", "whole.db")
        self.assertIn("small vs other (4 pairs", whole)
        self.document(2)
        self.succeed("run", "study.yaml", "--quiet", "--no-page")
        os.makedirs(self.folder / "elsewhere")
        done = subprocess.run([self.program, "resume", "../small_one.db", "--pairs", "4", "--quiet", "--json"], text=True,
                              cwd=self.folder / "elsewhere", capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = json.loads(done.stdout)
        self.assertEqual((report["pairs"], report["pairs_before"]), (4, "2"))
        self.assertEqual(self.rows("small_one.db"), self.rows("whole.db"))
        self.assertTrue((self.folder / "small_one.html").exists())
        text = self.succeed("report", "small_one.db")
        self.assertIn("Before it was given more it had so many pairs: 2.", text)
        # Nothing is left to be played.
        self.assertEqual(self.succeed("resume", "small_one.db", "--quiet", "--pairs", 4), text)

    def test_an_interrupted_one_is_gone_on_with(self):
        self.document(40)
        running = self.start("run", "study.yaml", "--quiet", "--workers", 1)
        self.wait_for(lambda: self.count("small_one.db") > 0)
        running.send_signal(signal.SIGINT)
        running.communicate()
        self.assertEqual(running.returncode, 130)
        self.assertLess(self.count("small_one.db"), 80)
        self.document(1)  # what stands there now is not asked
        self.succeed("resume", "small_one.db", "--quiet", "--no-page")
        self.assertEqual(self.count("small_one.db"), 80)

    def test_results_of_several_places_are_reported_as_one(self):
        self.document(4)
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--results", "whole.db")
        for name, keep in (("here", "row % 3 = 1"), ("there", "row % 3 <> 1")):
            shutil.copy(self.folder / "whole.db", self.folder / f"{name}.db")
            self.change(f"DELETE FROM metrics WHERE NOT ({keep})", f"{name}.db", mend=False)
            self.change(f"DELETE FROM matches WHERE NOT ({keep})", f"{name}.db", mend=False)
        for form in ((), ("--json",), ("--csv",), ("--csv", "--metrics")):
            self.assertEqual(self.succeed("report", "here.db", "there.db", *form), self.succeed("report", "whole.db", *form))
        # In whatever order, and what stands in both stands there once.
        self.assertEqual(self.succeed("report", "there.db", "whole.db", "here.db"), self.succeed("report", "whole.db"))
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--results", "other.db", "--set", "seed=7")
        refused = self.refused("report", "here.db", "other.db")
        self.assertIn("here.db and other.db are not of one study: seed", refused)
        self.change("UPDATE matches SET hash = 'ff' WHERE row = 1", "there.db")
        self.change("UPDATE matches SET hash = '00' WHERE row = 2", "whole.db")
        self.assertIn("match 2: the same match has the hash 00 there and", self.refused("report", "there.db", "whole.db"))

    def test_one_team_alone_is_disturbed(self):
        self.write("deaf.yaml", "disturbance: deaf\nradio: {loss: 1}\n")
        self.write("study.yaml", """tournament: disturbed
teams:
  - {team: small.yaml}
  - {team: small.yaml, disturbance: deaf.yaml}
pairs: 3
limit: 20
set: {rules.durations.ready: 1, rules.durations.set: 1}
""")
        self.succeed("run", "study.yaml", "--quiet", "--no-page")
        jobs = [json.loads(job) for (job,) in self.stored("SELECT job FROM fixtures ORDER BY id", "disturbed.db")]
        self.assertEqual([(job["home_disturbance"], job["away_disturbance"]) for job in jobs],
                         [("", "deaf.yaml"), ("deaf.yaml", "")])
        hashes = [row[0] for row in self.stored("SELECT hash FROM matches ORDER BY row", "disturbed.db")]
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--results", "both.db", "--set",
                     "teams.0.disturbance=deaf.yaml")
        self.assertFalse(set(hashes) & {row[0] for row in self.stored("SELECT hash FROM matches", "both.db")})
        # The same by itself, hash for hash; and it is gone on with.
        self.succeed("match", "--from", "disturbed.db", "--row", 2, "--quiet")
        text = self.succeed("resume", "disturbed.db", "--pairs", 4, "--quiet", "--no-page")
        self.assertIn("small (a) vs small (b) (4 pairs", text)
        self.write("deaf.yaml", "disturbance: deaf\nradio: {loss: 0.5}\n")
        self.assertIn("away disturbance deaf has changed", self.refused("resume", "disturbed.db", "--pairs", 5))

    def test_more_pairs_are_refused_where_a_test_was_fixed(self):
        self.document(2)
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--set", "test={metric: goals}")
        refused = self.refused("resume", "small_one.db", "--pairs", 9)
        self.assertIn("it has a sequential test, whose error rates hold for the number of pairs", refused)
        self.document(3)
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--results", "fixed.db")
        self.assertIn("it has 3 pairs already", self.refused("resume", "fixed.db", "--pairs", 2))
        self.assertEqual(len(self.rows("fixed.db")), 6)

    def test_what_has_changed_is_named(self):
        self.document(2)
        self.succeed("run", "study.yaml", "--quiet", "--no-page")
        text = (self.folder / "small.yaml").read_text()
        self.write("small.yaml", text + "\nteammates_forgotten_after: 20\n")
        before = self.rows("small_one.db"), self.succeed("report", "small_one.db")
        self.assertIn("was begun with something else: ", self.refused("resume", "small_one.db", "--pairs", 3))
        self.assertEqual((self.rows("small_one.db"), self.succeed("report", "small_one.db")), before)

    def test_another_program_does_not_go_on(self):
        self.document(2)
        self.succeed("run", "study.yaml", "--quiet", "--no-page")
        with open(self.program, "ab") as program_file:
            program_file.write(b"\0")
        self.assertIn("was begun with something else: program has changed; its matches would be mixed with others; to play it "
                      "anew: regista report small_one.db --study FOLDER", self.refused("resume", "small_one.db"))
        self.succeed("report", "small_one.db", "--study", "folder")
        anew = self.run_program("run", "folder/study.yaml", "--quiet", "--no-page", "--results", "anew.db")
        self.assertEqual(anew.returncode, 0, anew.stderr)

    def test_how_it_was_played_is_kept(self):
        self.document(1)
        self.succeed("run", "study.yaml", "--quiet", "--no-page", "--isolation", "always", "--play-once")
        plan = json.loads(self.stored("SELECT value FROM meta WHERE name = 'schedule'", "small_one.db")[0][0])
        self.assertIn("\nisolation: always\nplay_twice: false\n", plan["document"])
        self.succeed("resume", "small_one.db", "--quiet", "--no-page", "--pairs", 2)
        self.assertEqual(self.count("small_one.db"), 4)

    def test_an_experiment(self):
        self.write("arms.yaml", EXPERIMENT)
        text = self.succeed("run", "arms.yaml", "--quiet", "--no-page")
        self.assertEqual(self.succeed("resume", "arms.db", "--quiet", "--no-page"), text)
        more = json.loads(self.succeed("resume", "arms.db", "--quiet", "--no-page", "--json", "--pairs", 2))
        self.assertEqual((more["pairs"], more["pairs_before"], more["matches"]), (2, "1", 8))
        self.assertIn("it has 2 pairs already", self.refused("resume", "arms.db", "--pairs", 1))
        self.assertEqual(json.loads(self.succeed("results", "--json"))["results"][0]["teams"][:2], ["one", "two"])

    def test_bad_input(self):
        self.assertIn("which study?", self.refused("run"))
        self.assertIn("small.yaml is no study but of the kind team", self.refused("run", "small.yaml"))
        self.assertIn("which results?", self.refused("resume"))
        self.assertIn("cannot read nothing.db: No such file or directory", self.refused("resume", "nothing.db"))
        self.assertIn("--pairs", self.refused("resume", "nothing.db", "--pairs", "many"))
        self.assertIn("No such file or directory", self.refused("results", "nowhere"))

    def test_results_are_listed(self):
        self.document(2)
        self.succeed("run", "study.yaml", "--quiet", "--no-page")
        (self.folder / "notes.db").write_text("no results")
        pathlib.Path(self.folder / "broken.db").write_bytes((self.folder / "small_one.db").read_bytes()[:4096])
        text = self.succeed("results")
        first = next(line for line in text.splitlines() if line.startswith("small_one.db"))
        self.assertRegex(first, r"^small_one.db: tournament, finished, last written 20\d\d-\d\d-\d\d \d\d:\d\d UTC$")
        self.assertIn("  Which is better?\n", text)
        self.assertIn("broken.db", text)
        self.assertNotIn("notes.db", text)
        found = {each["file"]: each for each in json.loads(self.succeed("results", ".", "--json"))["results"]}
        self.assertTrue(found["small_one.db"]["finished"])
        self.assertIn("unreadable", found["broken.db"])
        os.makedirs(self.folder / "empty")
        nothing = self.run_program("results", "empty")
        self.assertEqual((nothing.returncode, nothing.stdout), (0, ""))
        self.assertEqual(nothing.stderr, "regista: no results in empty\n")


if __name__ == "__main__":
    unittest.main()
