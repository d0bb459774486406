# SPDX-License-Identifier: MIT
"""A plugin whose answers depend on what is no input of the match is found by playing the first match of each pairing
again, in other processes, elsewhere in memory, in another folder and at another date."""

import json
import re
import unittest

import program
import tournament

FOLDER = program.TEST_PLUGINS / "chance"


class Reproducibility(tournament.Tournament):
    def played(self, *more, teams=("bad.yaml", "small.yaml"), plugin="asks_for_the_process", pairs=2, accident=""):
        """The report as text and as JSON. accident: what standard error begins with."""
        self.with_context(plugin)
        words = self.arguments("--quiet", "--plugins", FOLDER, "--workers", "1", *more, teams=teams, pairs=pairs)
        done = self.run_program(*words)
        self.assertEqual((done.returncode, bool(done.stderr)), (0, bool(accident)), done.stderr)
        self.assertTrue(done.stderr.startswith(accident), done.stderr)
        text = done.stdout
        self.assertEqual(self.succeed("report", "tournament.db"), text)
        report = json.loads(self.succeed("report", "tournament.db", "--json"))
        (self.folder / "tournament.db").unlink()
        return text, report["not_reproducible"]

    def found(self, plugin, side="home", **options):
        text, found = self.played(plugin=plugin, **options)
        line = text.splitlines()[0]
        # It is asked 29 times before chance decides.
        tick, = map(int, re.findall(rf"^not reproducible: match 1: {side}, robot [1-7], tick (\d+) \(\d\.\d\d s\): "
                                    rf"plugin {plugin} answered holds otherwise$", line))
        self.assertGreaterEqual(tick, 29)
        self.assertEqual(found, {"matches": 1, "listed": [{"match": 1, "what": line.split("match 1: ")[1]}]})

    def test_the_number_of_the_process(self):
        self.found("asks_for_the_process")
        self.found("asks_for_the_process", side="away", teams=("small.yaml", "bad.yaml"))

    def test_where_it_lies_in_memory(self):
        self.found("asks_for_an_address")

    def test_in_isolation_too(self):
        self.with_context("asks_for_the_process")
        text, found = self.played("--isolation", "always")
        self.assertRegex(text, r"^not reproducible: match 1: home, robot \d, tick \d+ .*: plugin asks_for_the_process "
                               "answered holds otherwise\n")
        self.assertEqual(found["matches"], 1)

    def test_though_the_second_play_is_killed(self):
        who = "plugin " if program.SANITIZED else "a plugin of the home team: Killed)"
        self.found("asks_for_the_process_and_is_killed", accident=f"regista: a worker died ({who}")

    def test_the_working_folder(self):
        text, found = self.played(plugin="asks_for_the_folder")
        self.assertRegex(text, r"^not reproducible: match 1: home, robot \d, tick 0 \(0\.\d\d s\): plugin "
                               "asks_for_the_folder answered holds otherwise\n")
        self.assertEqual(found["matches"], 1)

    def test_a_second_play_that_fails_costs_nobody_a_match(self):
        """It goes elsewhere, where a file of the plugin is not: that is told, and the first play counts."""
        self.with_context("reads_a_file_here")
        self.write("weights.txt", "1")
        done = self.run_program(*self.arguments("--quiet", "--plugins", program.TEST_PLUGINS / "trespass",
                                                teams=("bad.yaml", "small.yaml"), pairs=2))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        report = json.loads(self.succeed("report", "tournament.db", "--json"))
        self.assertEqual(report["forfeits"], [])
        self.assertEqual(report["unplayed"]["pairs"], 0)
        self.assertEqual([each["match"] for each in report["not_reproducible"]["listed"]], [1])
        self.assertRegex(report["not_reproducible"]["listed"][0]["what"],
                         r"^the second play failed, in another process and folder: .*weights\.txt is not there")

    def test_reading_more_than_it_says(self):
        """At some decisions of the second play what it does not declare to read is not there."""
        text, found = self.played(plugin="reads_more_than_it_says")
        self.assertRegex(text, r"^not reproducible: match 1: home, robot \d, tick \d+ .*: plugin reads_more_than_it_says "
                               "answered holds otherwise, where what it does not declare to read is left out\n")

    def test_each_pairing(self):
        text, found = self.played(teams=("small.yaml", "other.yaml", "bad.yaml"), plugin="asks_for_the_folder",
                                  pairs=1)
        # Pairings: small and other, small and bad, other and bad. Pair after pair, each pairing's two matches.
        self.assertEqual(found["matches"], 2)
        self.assertEqual([each["match"] for each in found["listed"]], [3, 5])
        self.assertEqual(text.count("not reproducible: "), 2)

    def test_who_is_asked_not_to_look_does_not(self):
        text, found = self.played("--play-once")
        self.assertNotIn("reproducible", text)
        self.assertEqual(found, {"matches": 0, "listed": []})

    def test_the_first_play_counts(self):
        """A second play changes no result, whatever it comes to."""
        self.with_context("asks_for_the_folder")
        self.played(plugin="asks_for_the_folder")  # as a check of the test: it is found
        rows = []
        for more in (), ("--play-once",):
            self.play("--plugins", FOLDER, "--results", f"{len(more)}.db", *more, teams=("bad.yaml", "small.yaml"))
            rows.append(self.rows(f"{len(more)}.db"))
        self.assertEqual(*rows)
        self.assertEqual(self.stored("SELECT attempts FROM matches ORDER BY row LIMIT 2", "0.db"), [(4,), (1,)])
        self.assertEqual(self.stored("SELECT attempts FROM matches ORDER BY row LIMIT 2", "1.db"), [(1,), (1,)])


if __name__ == "__main__":
    unittest.main()
