# SPDX-License-Identifier: MIT
"""Reports say what was played, and a stored study is played again from the folder that it is written to."""

import contextlib
import json
import os
import pathlib
import re
import shutil
import sqlite3
import unittest

import program
import tournament

STUDIES = program.SOURCE / "configs" / "studies"


LIMIT = os.environ.get("REGISTA_LIMIT", "5")  # seconds of a match; 60 takes minutes


def hashes(results):
    with contextlib.closing(sqlite3.connect(results)) as database:
        return database.execute("SELECT row, hash FROM matches ORDER BY row").fetchall()


class Again(tournament.Tournament):
    def write_again(self, results, more=()):
        """The folder; what it plays is the same, match for match."""
        folder = self.folder / f"again_{results}"
        self.succeed("report", results, "--study", folder.name)
        study = (folder / "study.yaml").read_text()
        self.assertNotIn(str(self.folder), study)
        done = self.run_program("run", "study.yaml", "--results", "again.db", "--quiet", "--no-page", *more, cwd=folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(hashes(folder / "again.db"), hashes(self.folder / results))
        return folder, done.stdout

    def test_a_tournament_with_a_disturbance_of_one_team(self):
        self.write("wind.yaml", "disturbance: wind\nradio: {loss: 0.5}\n")
        self.write("night.yaml", "tournament: night\nteams: [{team: small.yaml}, {team: small.yaml, disturbance: wind.yaml}]\n"
                                 "pairs: 1\nlimit: 10\nset: {b.utility.terms.near.params.scale: 2, rules.durations.set: 3}\n"
                                 "isolation: always\n")
        text = self.succeed("tournament", "night.yaml", "--quiet")
        self.assertRegex(text, r"\nsmall \(a\)  small\.yaml  \w{8}  none \(built in\)\n"
                               r"small \(b\)  small\.yaml  \w{8}  wind \(wind\.yaml\), set utility\.terms\.near\.params\.scale=2\n")
        self.assertIn("\n  set rules.durations.set=3\n", text)
        played = json.loads(self.succeed("report", "night.db", "--json"))["played"]
        self.assertEqual([each["disturbance"] for each in played["teams"]],
                         [{"name": "none", "file": None}, {"name": "wind", "file": "wind.yaml"}])
        page = (self.folder / "night.html").read_text()
        self.assertIn("<code class=\"path\">disturbance</code></td><td><code>none</code></td>"
                      "<td><code>wind (wind.yaml)</code>", page)
        self.assertIn("regista report night.db --study again", page)
        (self.folder / "wind.yaml").unlink()  # the results know it
        self.write_again("night.db")

    def test_an_experiment_with_a_sweep(self):
        self.write("e.yaml", "experiment: e\narms: [{name: one, team: small.yaml}, {name: two, team: other.yaml, set: "
                             "{utility.terms.near.params.scale: 2}}]\nopponent: small.yaml\nmatches: 2\nlimit: 5\n"
                             "sweep: {path: rules.durations.set, values: [2, 3]}\nprimary: {measure: packets}\n"
                             "allow_shared_memory: true\n")
        self.succeed("experiment", "e.yaml", "--quiet", "--no-page", "--seed", "4", "--seeds", "consecutive")
        folder, text = self.write_again("e.db")
        self.assertIn("at each of 2 values of rules.durations.set, seeds from 4", text)
        self.assertIn("robots of a team may share memory", text)

    def test_what_is_another_now_is_reported_before_play(self):
        self.play()
        self.succeed("report", "tournament.db", "--study", "again")
        study = self.folder / "again" / "study.yaml"
        text = study.read_text()
        study.write_text(re.sub(r'"plugin (\S+) \w{32}"', r'"plugin \1 00000000000000000000000000000000"', text, 1))
        done = self.run_program("run", "study.yaml", "--quiet", "--no-page", cwd=study.parent)
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"plugin \S+ is not what this study was played with before\n")

    def test_a_resumed_study_is_reported_as_it_was_begun(self):
        self.play()
        before = json.loads(self.succeed("report", "tournament.db", "--json"))["played"]
        done = self.run_program(*self.arguments("--resume", "--json", "--quiet", "--isolation", "always"))
        self.assertEqual(done.returncode, 0)
        self.assertIn("tournament.db goes on as it was begun", done.stderr)
        self.assertEqual(json.loads(done.stdout)["played"], before)

    def test_what_cannot_be_written(self):
        self.play()
        self.assertIn("exists already", self.refused("report", "tournament.db", "--study", "."))
        self.assertIn("--study writes the study, and nothing else",
                      self.refused("report", "tournament.db", "--study", "again", "--json"))
        self.assertIn("there is no folder", self.refused("report", "tournament.db", "--study", "no/again"))


class Files(program.ShippedCase):
    """Teams below a/, the study elsewhere."""

    def setUp(self):
        super().setUp()
        shutil.copytree(program.SOURCE / "configs", self.folder / "a")

    def write_again(self, results, *more):
        """What `--study` remarks, and the hashes of what its folder plays."""
        done = self.run_program("report", f"{results}.db", "--study", f"{results}_again/")
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        folder = self.folder / f"{results}_again"
        played = self.run_program("run", "study.yaml", "--results", "again.db", "--quiet", "--no-page", *more, cwd=folder)
        self.assertEqual(played.returncode, 0, played.stderr)
        return done.stderr, played.stderr, hashes(folder / "again.db")

    def test_files_in_settings_of_arms_and_in_a_sweep(self):
        shutil.copy(self.folder / "a/formations/open_play.conf", self.folder / "a/formations/other.conf")
        file = "positioner.params.file"
        for name, arms, more in (
                ("arms", f"{{name: one, team: a/teams/formation.yaml}}, {{name: two, team: a/teams/formation.yaml, "
                         f"set: {{{file}: a/formations/other.conf}}}}", ""),
                ("sweep", "{name: one, team: a/teams/formation.yaml}, {name: two, team: a/teams/formation.yaml, "
                          "set: {tasks.offset.at_most: 10}}",
                 f"sweep: {{path: {file}, values: [a/formations/open_play.conf, a/formations/other.conf]}}\n")):
            self.write(f"{name}.yaml", f"experiment: {name}\narms: [{arms}]\nopponent: a/teams/scram.yaml\nmatches: 2\n"
                                       f"limit: 4\n{more}")
            self.succeed("experiment", f"{name}.yaml", "--quiet", "--no-page", "--play-once")
            expected = hashes(self.folder / f"{name}.db")
            shutil.move(self.folder / "a", self.folder / "away")  # nothing of it is read again
            self.assertEqual(self.write_again(name), ("", "", expected))
            shutil.move(self.folder / "away", self.folder / "a")

    def test_a_team_called_study(self):
        self.write("a/teams/study.yaml", "extends: paper.yaml\nteam: study\n")
        self.succeed("tournament", "--team", "a/teams/study.yaml", "--team", "a/teams/paper.yaml", "--pairs", 1,
                     "--limit", 4, "--quiet", "--no-page", "--results", "t.db")
        self.assertEqual(self.write_again("t"), ("", "", hashes(self.folder / "t.db")))

    def test_what_does_not_come_along_is_reported(self):
        self.write("a/teams/far.yaml", f"extends: {self.folder}/a/teams/paper.yaml\nteam: far\n")
        (self.folder / "more").mkdir()
        self.succeed("tournament", "--team", "a/teams/far.yaml", "--team", "a/teams/paper.yaml", "--pairs", 1,
                     "--limit", 4, "--quiet", "--no-page", "--results", "t.db", "--plugins", "more")
        self.assertIn("\n  plugins of more first\n", self.succeed("report", "t.db"))
        remarks, _, played = self.write_again("t", "--plugins", self.folder / "more")
        self.assertRegex(remarks, r"a/teams/far\.yaml names \S+/a/teams/paper\.yaml from the root")
        self.assertIn(f"needs --plugins {self.folder}/more\n", remarks)
        self.assertEqual(played, hashes(self.folder / "t.db"))

    def test_a_study_whose_plugins_are_gone(self):
        (self.folder / "mine").mkdir()
        shutil.copy(pathlib.Path(os.environ["REGISTA_TEST_PLUGINS"]) / "bids" / "bids.so", self.folder / "mine")
        self.write("a/teams/bids.yaml", "extends: paper.yaml\nteam: bids\nassigner: {plugin: bids}\n")
        self.succeed("tournament", "--team", "a/teams/bids.yaml", "--team", "a/teams/paper.yaml", "--pairs", 1,
                     "--limit", 4, "--quiet", "--no-page", "--results", "t.db", "--plugins", "mine")
        self.assertIn(f"needs --plugins {self.folder}/mine\n", self.run_program("report", "t.db", "--study", "again").stderr)
        shutil.move(self.folder / "mine", self.folder / "yours")
        for words in (("resume", "t.db"), ("match", "--from", "t.db", "--row", "1")):
            line = self.refused(*words, "--quiet")
            self.assertIn(f"t.db: it was played with the plugins of {self.folder}/mine, which is no folder any more", line)
            self.assertIn("regista report t.db --study again, then regista run again/study.yaml --plugins DIR", line)
        missing = self.run_program("run", "again/study.yaml", "--quiet", "--no-page")
        self.assertEqual(missing.returncode, 2)
        self.assertRegex(missing.stderr, r"study\.yaml:\d+:\d+: it was played with the plugin bids, which none of the folders "
                                         r"has; name its folder: --plugins DIR\n.*unknown assigner \"bids\"")
        self.succeed("run", "again/study.yaml", "--quiet", "--no-page", "--plugins", "yours", "--results", "new.db")
        self.assertEqual(hashes(self.folder / "new.db"), hashes(self.folder / "t.db"))

    def test_a_file_with_the_name_of_a_built_in_profile(self):
        rules = (self.folder / "a/rules/spl2023.yaml").read_text()
        self.write("spl2023", re.sub(r"(?m)^rules: spl2023", "rules: ours", rules).replace("half: 600", "half: 300"))
        self.succeed("tournament", "--team", "a/teams/scram.yaml", "--team", "a/teams/paper.yaml", "--pairs", 1,
                     "--limit", 4, "--rules", "spl2023", "--quiet", "--no-page", "--results", "t.db")
        self.assertIn("  rules ours (spl2023)", self.succeed("report", "t.db"))
        self.assertEqual(self.write_again("t"), ("", "", hashes(self.folder / "t.db")))


class ShippedStudies(program.ShippedCase):
    """Each, cut to its fewest pairs or matches and to short games."""

    FEWEST = {
        "tournament": ("--pairs", "1"),
        "experiment": ("--matches", "2"),
        "tuning": ("--matches", "200", "--set", "search.algorithm=random_search", "--set", "selection={finalists: 1, matches: 20}", "--set",
                   "verification={candidates: 1, matches: 200}", "--set", "slices.points=0"),
    }

    def test_each_is_played_again(self):
        played = 0
        for document in sorted(STUDIES.glob("*.yaml")):
            text = document.read_text()
            kind = next((each for each in self.FEWEST if re.search(rf"^{each}:", text, re.M)), None)
            if kind is None:
                continue  # of a predictor
            with self.subTest(document.name):
                command = "tune" if kind == "tuning" else kind
                self.succeed(command, document, "--limit", LIMIT, "--quiet", "--no-page", "--play-once", "--results",
                             f"{document.stem}.db", *self.FEWEST[kind])
                self.succeed("report", f"{document.stem}.db", "--study", document.stem)
                self.succeed("run", "study.yaml", "--results", "again.db", "--quiet", "--no-page",
                             cwd=self.folder / document.stem)
                self.assertEqual(hashes(self.folder / document.stem / "again.db"),
                                 hashes(self.folder / f"{document.stem}.db"))
                played += 1
        self.assertGreater(played, 4)


if __name__ == "__main__":
    unittest.main()
