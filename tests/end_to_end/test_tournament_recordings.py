# SPDX-License-Identifier: MIT
"""Recorded matches of a tournament: every N-th, and those that fail."""

import json
import os
import re
import shutil
import unittest

import program
import recorded
import tournament

DEATHS = program.TEST_PLUGINS / "deaths"
BAD_VALUES = program.TEST_PLUGINS / "bad_values"
LIMITS = ("--processor-seconds", "1", "--memory", "512")


class Recordings(tournament.Tournament):
    def names(self, folder="tournament.recordings"):
        return sorted((path.name for path in (self.folder / folder).glob("*")), key=lambda name: int(name.split(".")[0]))

    def recording(self, row, folder="tournament.recordings"):
        return recorded.read(self.folder / folder / f"{row}.mcap")

    def test_every_third_match_is_recorded_and_nothing_else_changes(self):
        self.play("--results", "plain.db")
        self.play("--record-every", "3", "--results", "tournament.db")
        self.assertEqual(self.names(), ["1.mcap", "4.mcap"])
        self.assertFalse((self.folder / "plain.recordings").exists())
        self.assertEqual(self.rows("plain.db"), self.rows())
        for row, match in enumerate(self.table(), 1):
            if row not in (1, 4):
                continue
            file = self.recording(row)
            self.assertTrue(file.whole)
            self.assertEqual(file.about["seed"], match["seed"])
            self.assertEqual([json.loads(file.about[side])["team"] for side in ("home", "away")],
                             [match["home"], match["away"]])
            self.assertEqual(file.of("/game")[-1]["score"], [int(match["home_goals"]), int(match["away_goals"])])

    def test_a_match_of_a_tournament_can_be_recorded_later(self):
        self.play("--record-every", "2")
        done = self.run_program("match", "--from", "tournament.db", "--row", "3", "--quiet", "--record", "later.mcap")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "later.mcap").read_bytes(),
                         (self.folder / "tournament.recordings/3.mcap").read_bytes())

    def test_a_resumed_tournament_records_what_is_still_to_be_played(self):
        self.kill_when(lambda: self.count() >= 3, *self.arguments("--quiet", "--record-every", "1", pairs=50))
        played = self.count()
        self.succeed(*self.arguments("--quiet", "--record-every", "10", "--resume", pairs=50))
        names = self.names()
        self.assertTrue(set(f"{row}.mcap" for row in range(1, played + 1)) <= set(names))
        self.assertTrue(set(f"{row}.mcap" for row in range(played + 20, 101) if row % 10 == 1) <= set(names))
        for row in (1, 91):
            self.assertTrue(self.recording(row).whole)

    def test_the_page_of_a_killed_and_resumed_tournament_is_that_of_an_undisturbed_one(self):
        """Under a test that stops early, so that workers have run ahead, and with a team that dies now and then."""
        self.bad_team("plugin: ball_seen", "plugin: crashes")
        scores = ("--sprt", "0,300", "--record-every", "3")
        for teams, more in ((("small.yaml", "worse.yaml"), scores),
                            (("bad.yaml", "small.yaml"), ("--record-every", "2"))):
            words = self.arguments("--quiet", "--plugins", DEATHS, *LIMITS, *more, teams=teams, pairs=20)
            words = [word for word in words if word != "--no-page"]
            self.succeed(*words)
            page = (self.folder / "tournament.html").read_bytes()
            linked = re.findall(rb'href="\./(tournament\.recordings/\d+\.mcap)"', page)
            self.assertGreaterEqual(len(linked), 2)
            held = {name: (self.folder / os.fsdecode(name)).read_bytes() for name in linked}
            self.forget()
            rows = 0
            for _ in range(3):
                before, resume = rows, ["--resume"] if rows > 0 else []
                self.kill_when(lambda: self.count() > before, *words, *resume)
                rows = self.count()
            # What a killed worker leaves, of a match that was not counted.
            self.write("tournament.recordings/9999.mcap", "")
            shutil.copy(self.folder / os.fsdecode(linked[0]), self.folder / "tournament.recordings/9998.mcap")
            self.succeed(*words, "--resume")
            self.assertEqual((self.folder / "tournament.html").read_bytes(), page)
            for name, content in held.items():
                self.assertEqual((self.folder / os.fsdecode(name)).read_bytes(), content, name)
            self.forget()

    def forget(self):
        for file in self.folder.glob("tournament.*"):
            shutil.rmtree(file) if file.is_dir() else file.unlink()

    def bad_team(self, old, new):
        text = program.TEAM.format(name="bad").replace("robot: 1, ", "")
        self.assertIn(old, text)
        self.write("bad.yaml", text.replace(old, new))

    def bad(self, old, new, folder):
        self.bad_team(old, new)
        return json.loads(self.succeed(*self.arguments("--quiet", "--json", "--plugins", folder, *LIMITS,
                                                       teams=("bad.yaml", "small.yaml"), pairs=1)))

    def test_a_plugin_that_dies_leaves_its_last_seconds(self):
        self.bad("plugin: ball_seen", "plugin: crashes", DEATHS)
        self.assertEqual(self.names(), ["1.mcap", "2.mcap"])
        # The file was never finished; what stands in it ends just before the death.
        file = self.recording(1)
        self.assertFalse(file.whole)
        self.assertGreaterEqual(file.of("/game")[-1]["time"], 1.7)  # it dies at the 19th decision
        self.assertTrue(file.of("/decision/home/3"))
        self.succeed("report", "tournament.db", "-o", "tournament.html")
        page = (self.folder / "tournament.html").read_text()
        for row in (1, 2):
            self.assertIn(f'href="./tournament.recordings/{row}.mcap"', page)
        self.assertEqual(page.count("(forfeit, as far as it was played)"), 2)

    def test_a_plugin_that_breaks_a_promise_leaves_all_of_it(self):
        self.bad("plugin: first_free", "plugin: assigns_beyond", BAD_VALUES)
        self.assertEqual(self.names(), ["1.mcap", "2.mcap"])
        self.assertTrue(self.recording(1).whole)

    def test_a_folder_that_cannot_be_written_costs_the_recording_alone(self):
        self.write("tournament.recordings", "in the way")
        done = self.run_program(*self.arguments("--quiet", "--record-every", "3"))
        self.assertEqual(done.returncode, 0)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 2, done.stderr)
        for line in lines:
            self.assertRegex(line, r"^regista: a match was not recorded: tournament\.recordings/\d\.mcap: .+; it can be "
                                   r"played again with --record: .* match ")
        self.assertEqual(self.count(), 6)

    def test_a_failed_match_that_cannot_be_recorded_is_told(self):
        self.write("tournament.recordings", "in the way")
        for old, new, folder in (("ball_seen", "crashes", DEATHS), ("first_free", "assigns_beyond", BAD_VALUES)):
            text = program.TEAM.format(name="bad").replace("robot: 1, ", "")
            self.write("bad.yaml", text.replace(f"plugin: {old}", f"plugin: {new}"))
            (self.folder / "tournament.db").unlink(missing_ok=True)
            done = self.run_program(*self.arguments("--quiet", "--no-page", "--plugins", folder, *LIMITS,
                                                    teams=("bad.yaml", "small.yaml"), pairs=1))
            self.assertEqual(done.returncode, 0)
            told = [line for line in done.stderr.splitlines() if "a match was not recorded" in line]
            self.assertEqual(len(told), 2, done.stderr)

    def test_numbers_that_are_none(self):
        for value in ("0", "-1", "x", "1.5"):
            self.assertIn("--record-every", self.refused(*self.arguments("--record-every", value)))


if __name__ == "__main__":
    unittest.main()
