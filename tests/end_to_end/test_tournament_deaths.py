# SPDX-License-Identifier: MIT
"""Tournaments with plugins that die: each is blamed, none ends the tournament, and the command that is printed
reproduces it."""

import json
import re
import shlex
import signal
import subprocess
import unittest

import program
import tournament

FOLDER = program.TEST_PLUGINS / "deaths"
# What a match may take, as little as can be asked for.
LIMITS = ("--processor-seconds", "1", "--memory", "512")
# A sanitizer looks at fatal signals itself.
ABORTED = "Aborted" if program.SANITIZED else "Aborted, in deaths.so"
# Plays that two matches of a pairing take when nothing goes wrong: the first is played twice.
FIRST_TWICE = [(2,), (1,)]


class Deaths(tournament.Tournament):
    def setUp(self):
        super().setUp()
        self.assertTrue((FOLDER / "deaths.so").exists(), "deaths.so is not built")

    def bad_team(self, old, new):
        text = program.TEAM.format(name="bad").replace("robot: 1, ", "")
        self.assertIn(old, text)
        self.write("bad.yaml", text.replace(old, new))

    def forfeits_of(self, call="holds", pairs=2):
        report = self.only("--plugins", FOLDER, *LIMITS, teams=("bad.yaml", "small.yaml"), pairs=pairs)
        matches = 2 * pairs
        self.assertEqual((report["games"], report["losses"]), (matches, matches))
        self.assertEqual((report["goals"], report["pentanomial"]), ([0, 10 * matches], [pairs, 0, 0, 0, 0]))
        self.assertEqual(len(report["forfeits"]), 1)
        forfeit = report["forfeits"][0]
        self.assertEqual((forfeit["team"], forfeit["call"], forfeit["matches"]), ("bad", call, matches))
        self.assertEqual([team["failures"] for team in report["teams"]], [matches, 0])
        self.assertEqual(report["set_aside"], [])
        rows = self.stored("SELECT home_goals, away_goals, ended, hash, failure FROM matches ORDER BY row")
        sides = [0, 1] * pairs
        self.assertEqual([json.loads(row[4])["side"] for row in rows], sides)
        for side, row in zip(sides, rows):
            self.assertEqual(row[:4], (0, 10, "forfeit", None) if side == 0 else (10, 0, "forfeit", None))
        self.assertEqual(self.stored("SELECT count(*) FROM metrics"), [(0,)])
        return forfeit

    def blamed(self, name, plays=2, named=True, **options):
        """Each of its matches is played again with each team in a process of its own, which tells whose fault it is."""
        self.bad_team("plugin: ball_seen", f"plugin: {name}")
        forfeit = self.forfeits_of("holds" if named else "", **options)
        self.assertEqual(forfeit["plugin"], name if named else "")
        for failure, in self.stored("SELECT failure FROM matches"):
            failure = json.loads(failure)
            self.assertEqual(failure["tick"], 19)
            self.assertIn(failure["robot"], range(1, 8))
        self.assertEqual(self.stored("SELECT DISTINCT attempts FROM matches"), [(plays,)])
        return forfeit

    def test_crash(self):
        forfeit = self.blamed("crashes")
        # A sanitizer looks at the fault itself and then ends the process.
        what = "ended the process (exit code 1)" if program.SANITIZED else "Segmentation fault, in deaths.so"
        self.assertEqual(forfeit["what"], what)
        words = shlex.split(forfeit["again"])
        self.assertEqual(words[0], str(self.program))
        done = self.run_program(*words[1:], "--quiet")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertRegex(done.stderr, rf"(?m)^regista: plugin crashes of home \(bad\.yaml\), robot \d, tick 19: holds: "
                                      rf"{re.escape(what)}$")
        again = self.succeed("match", "--from", "tournament.db", "--row", "1")
        self.assertRegex(again, rf"^row 1, again: was forfeited: home, plugin crashes, holds: {re.escape(what)}\n$")
        # For a debugger it is played where it dies.
        done = self.run_program("match", "--from", "tournament.db", "--row", "1", "--in-process")
        self.assertEqual((done.returncode, done.stdout), (1 if program.SANITIZED else -signal.SIGSEGV, ""))
        self.assertEqual(done.stderr.splitlines()[0],
                         f"regista: row 1 was forfeited: home, plugin crashes, holds: {what}; "
                         "it is played in this process now, without limits")
        # So it is though the team was edited.
        self.with_context("ball_seen")
        edited = self.succeed("match", "--from", "tournament.db", "--row", "1", "--quiet", "--record", "again.mcap")
        self.assertEqual(edited, again)
        self.assertNotIn(b"regista-", (self.folder / "again.mcap").read_bytes().replace(bytes(self.folder), b""))

    def test_abort(self):
        self.assertEqual(self.blamed("aborts")["what"], ABORTED)

    def test_exit(self):
        self.assertEqual(self.blamed("exits")["what"], "ended the process (exit code 0), in deaths.so")

    def test_hang(self):
        self.assertEqual(self.blamed("spins", pairs=1)["what"], "used more than 1 s of processor time")

    @unittest.skipIf(program.SANITIZED, "sanitizers need more stack and memory than a match may have")
    def test_stack(self):
        self.assertEqual(self.blamed("overflows_stack")["what"], "Segmentation fault, in deaths.so")

    def test_its_own_kill(self):
        # People and systems send this signal too: it is believed when it comes in three isolated plays.
        # Who sent it is not known, so it is the team's.
        self.assertEqual(self.blamed("kills_itself", plays=4, named=program.SANITIZED)["what"], "Killed")

    @unittest.skipIf(program.SANITIZED, "sanitizers need more stack and memory than a match may have")
    def test_memory(self):
        self.bad_team("plugin: ball_seen", "plugin: takes_memory")
        forfeit = self.forfeits_of()
        self.assertEqual((forfeit["plugin"], forfeit["what"]), ("takes_memory", "std::bad_alloc"))

    def test_a_crash_when_all_is_over(self):
        self.bad_team("plugin: ball_seen", "plugin: dies_at_the_end")
        forfeit = self.forfeits_of(call="destroy")
        self.assertEqual((forfeit["plugin"], forfeit["what"]), ("dies_at_the_end", ABORTED))

    def test_an_answer_that_is_none(self):
        self.bad_team("plugin: ball_seen", "plugin: corrupts_answer")
        report = self.only("--plugins", FOLDER, *LIMITS, teams=("bad.yaml", "small.yaml"), pairs=1)
        # What a plugin writes where the answer goes is not taken for it: the match is played like any other.
        self.assertEqual((report["games"], report["forfeits"]), (2, []))
        self.assertEqual(self.stored("SELECT attempts FROM matches ORDER BY row"), FIRST_TWICE)

    def failed(self, old, new, folder):
        """A plugin that says so or breaks a promise: even that may be the work of the other team, in its memory."""
        self.bad_team(old, new)
        report = self.only("--plugins", program.TEST_PLUGINS / folder, *LIMITS, teams=("bad.yaml", "small.yaml"),
                           pairs=1)
        self.assertEqual((report["goals"], report["pentanomial"]), ([0, 20], [1, 0, 0, 0, 0]))
        self.assertEqual([team["failures"] for team in report["teams"]], [2, 0])
        self.assertEqual(self.stored("SELECT DISTINCT attempts FROM matches"), [(2,)])
        self.assertTrue(all(forfeit["team"] == "bad" for forfeit in report["forfeits"]))
        return report["forfeits"]

    def test_throws(self):
        forfeits = self.failed("assigner: {plugin: first_free}", "assigner: {plugin: throws}", "throws")
        self.assertEqual([(f["plugin"], f["call"], f["what"], f["matches"]) for f in forfeits],
                         [("throws", "assign", "fell in assign", 2)])

    def test_no_number(self):
        forfeits = self.failed("{plugin: nearness, weight: 1, params: {scale: 2}}", "{plugin: scores_nan, weight: 1}",
                               "bad_values")
        self.assertEqual({(f["plugin"], f["call"]) for f in forfeits}, {("scores_nan", "score")})

    def test_a_task_given_twice(self):
        forfeits = self.failed("assigner: {plugin: first_free}", "assigner: {plugin: assigns_twice}", "assigns_twice")
        self.assertEqual({(f["plugin"], f["call"]) for f in forfeits}, {("assigns_twice", "assign")})

    def refused_at_once(self, name):
        """A plugin that is found out before the first match: nothing is written."""
        folder = program.TEST_PLUGINS / name
        self.assertTrue((folder / f"{name}.so").exists(), f"{name}.so is not built")
        self.bad_team("assigner: {plugin: first_free}", f"assigner: {{plugin: {name}}}")
        line = self.refused(*self.arguments("--plugins", folder, teams=("bad.yaml", "small.yaml")))
        self.assertEqual(list(self.folder.glob("tournament.db*")), [])
        return line

    def test_another_interface(self):
        self.assertRegex(self.refused_at_once("wrong_major"), r"wrong_major\.so: built for Regista plugin interface")

    def test_a_missing_symbol(self):
        self.assertRegex(self.refused_at_once("missing_library"), r"missing_library\.so: .*defined_nowhere")

    def test_no_plugin_at_all(self):
        self.assertRegex(self.refused_at_once("no_entry"), r"no_entry\.so: ")

    def test_set_aside(self):
        self.bad_team("plugin: ball_seen", "plugin: aborts")
        words = ("--plugins", FOLDER, *LIMITS, "--failures-in-a-row", "3")
        teams = ("bad.yaml", "small.yaml")
        text = self.play(*words, teams=teams, pairs=50)
        self.assertTrue(text.startswith("Tournament: bad vs small (2 pairs of 50, seeds from 1, 2 scenes of about 10 s)\n"), text)
        self.assertIn("\nGames: 4, Wins: 0, Losses: 4, Draws: 0, ", text)
        self.assertIn("\nbad was set aside after pair 2: its plugin aborts failed 4 times in a row.\n", text)
        self.assertIn(f"\n  4 matches forfeited by bad: plugin aborts, holds: {ABORTED}; the first again: ", text)
        self.assertEqual(self.succeed("report", "tournament.db"), text)
        self.assertEqual(self.play(*words, "--resume", teams=teams, pairs=50), text)
        report = self.only(*words, "--resume", teams=teams, pairs=50)
        self.assertEqual((report["matches"], [team["failures"] for team in report["teams"]]), (4, [4, 0]))
        self.assertEqual(report["set_aside"], [{"team": "bad", "plugin": "aborts", "failures": 4, "after_pair": 2}])
        self.assertEqual(len(self.table()), 4)
        self.assertIn("failures_in_a_row: was 3, now 0", self.refused(
            *self.arguments(*words[:-1], "0", "--resume", teams=teams, pairs=50)))

    def test_without_the_team_that_was_set_aside_the_others_play_on(self):
        self.bad_team("plugin: ball_seen", "plugin: aborts")
        teams = ("small.yaml", "bad.yaml", "other.yaml")
        words = ("--plugins", FOLDER, *LIMITS, "--failures-in-a-row", "2")
        said = set()
        for workers in ("1", "4"):
            report = self.report(*words, "--workers", workers, "--results", f"{workers}.db", teams=teams, pairs=3)
            said.add(json.dumps(report).replace(f"{workers}.db", ""))
        self.assertEqual(len(said), 1)
        self.assertEqual([pairing["games"] for pairing in report["pairings"]], [2, 6, 0])
        self.assertEqual(report["pairings"][0]["pentanomial"], [0, 0, 0, 0, 1])
        self.assertEqual((report["matches"], [team["failures"] for team in report["teams"]]), (8, [0, 2, 0]))
        self.assertEqual([each["team"] for each in report["set_aside"]], ["bad"])
        # What others had in hand when it was set aside is stored, and does not count.
        for file in ("1.db", "4.db"):
            self.assertEqual(json.loads(self.succeed("report", file, "--json")), report)
            self.assertEqual(len(self.table(file=file)), 8)

    def test_what_does_not_happen_again_is_nobodys_fault(self):
        self.bad_team("plugin: ball_seen", "plugin: dies_once")
        done = self.run_program(*self.arguments("--json", "--workers", "1", "--play-once", "--plugins", FOLDER,
                                                teams=("bad.yaml", "small.yaml"), pairs=2))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["forfeits"], [])
        # It died as the file says, and then in none of three plays with each team in a process of its own.
        self.assertEqual(self.stored("SELECT attempts, ended FROM matches ORDER BY row"),
                         [(4, "set_aside"), (1, "limit"), (1, "limit"), (1, "limit")])
        self.assertRegex(self.stored("SELECT text FROM remarks")[0][0],
                         r"^(Aborted.*|ended the process.*); the present call was holds of plugin dies_once \(home, "
                         r"robot \d, tick 19\); it did not come back in 3 isolated plays$")
        again = "match", "--from", "tournament.db", "--row", "1"
        done = self.run_program(*again)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, r"^regista: row 1 could not be played: .*; this time it was played to its end\n$")
        (self.folder / "died").unlink()
        self.assertRegex(self.succeed(*again), r"^row 1, again: could not be played: .* in 3 isolated plays\n$")

    def test_no_worker_outlives_its_coordinator(self):
        self.bad_team("plugin: ball_seen", "plugin: spins")
        words = self.arguments("--processor-seconds", "60", "--workers", "2", "--plugins", FOLDER,
                               teams=("bad.yaml", "small.yaml"))
        with self.start(*words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            self.wait_for(lambda: len(self.workers()) == 2)
            process.kill()
            process.wait()
        self.wait_for(lambda: not self.workers())

    def test_ctrl_c_while_plugins_hang(self):
        self.bad_team("plugin: ball_seen", "plugin: spins")
        words = self.arguments("--processor-seconds", "60", "--workers", "2", "--plugins", FOLDER,
                               teams=("bad.yaml", "small.yaml"))
        with self.start(*words, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: len(self.workers()) == 2)
            process.send_signal(2)
            _, err = process.communicate(timeout=2.0)
        self.assertEqual(process.returncode, 130)
        self.assertIn("interrupted after 0 of 6 matches", err)
        self.wait_for(lambda: not self.workers())


if __name__ == "__main__":
    unittest.main()
