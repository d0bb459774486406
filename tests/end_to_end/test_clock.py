# SPDX-License-Identifier: MIT
"""--until and --minutes: a study stops after a whole pair, stores where, and is complete; it goes on only if it is asked
to."""

import datetime
import json
import signal
import subprocess

import experiment
import program
import tournament


class Clock(tournament.Tournament):
    # Some matches fit, by far not all.
    NEVER_DONE = 5000
    A_WHILE = 0.5 if program.SANITIZED else 0.04  # min

    def stopped(self, *more, file="tournament.db", minutes=A_WHILE):
        report = json.loads(self.succeed(*self.arguments("--quiet", "--json", "--minutes", minutes, "--results", file, *more,
                                                         pairs=self.NEVER_DONE)))
        self.assertTrue(report["complete"])
        self.assertEqual(report["matches"], 2 * report["ended_after"] * len(report["pairings"]))
        return report

    def test_a_tournament_ends_with_the_pairs_that_are_whole(self):
        report = self.stopped("--workers", 3)
        after = report["ended_after"]
        self.assertEqual(report["pairs"], self.NEVER_DONE)
        self.assertLessEqual(self.count() - 2 * after, 1)
        self.assertIsNotNone(report["pairings"][0]["p"])
        # Read back and gone on with, it says the same, and plays nothing.
        self.assertEqual(json.loads(self.succeed("report", "tournament.db", "--json")), report)
        rows = self.rows()
        again = self.succeed("resume", "tournament.db", "--no-page", "--quiet", "--json")
        self.assertEqual((json.loads(again), self.rows()), (report, rows))
        text = self.succeed("report", "tournament.db")
        self.assertIn(f"The clock stopped it after {after} of {self.NEVER_DONE} pairs, a number that counts as fixed beforehand, "
                      "unless the clock was set anew after a look.", text)
        # A fixed number of as many pairs plays and finds the same.
        fixed = self.report("--results", "fixed.db", pairs=after)
        self.assertEqual(fixed["pairings"], report["pairings"])
        self.assertEqual(self.rows("fixed.db"), rows[:2 * after])
        self.succeed("report", "tournament.db", "--study", "again")
        self.assertIn(f"\npairs: {after}\n", (self.folder / "again/study.yaml").read_text())

    def test_it_goes_on_if_it_is_asked_to(self):
        first = self.stopped()["ended_after"]
        on = json.loads(self.succeed("resume", "tournament.db", "--no-page", "--quiet", "--json", "--minutes", self.A_WHILE))
        second = on["ended_after"]
        self.assertGreater(second, first)
        self.assertEqual(on["pairs_before"], str(first))
        # Its number of pairs does not count as fixed beforehand, and nothing says so.
        text = self.succeed("report", "tournament.db")
        self.assertIn(f"Before it was given more it had so many pairs: {first}.", text)
        self.assertIn(f"The clock stopped it after {second} of {self.NEVER_DONE} pairs.\n", text)
        self.assertNotIn("fixed beforehand, unless", text)
        self.assertIn(f"it has {second} pairs already", self.refused("resume", "tournament.db", "--pairs", second))
        more = json.loads(self.succeed("resume", "tournament.db", "--no-page", "--quiet", "--json", "--pairs", second + 2))
        self.assertEqual((more["pairs"], more["pairs_before"], more["complete"]), (second + 2, f"{first}, {second}", True))
        self.assertNotIn("ended_after", more)
        self.assertIn("Pairs were added after a look.", self.succeed("report", "tournament.db"))

    def test_without_a_number_of_pairs_as_many_as_fit(self):
        words = [each for each in self.arguments("--quiet", "--results", "open.db") if each not in ("--pairs", 3)]
        self.assertIn("pairs: how many are played?", self.refused(*words))
        report = json.loads(self.succeed(*words, "--json", "--minutes", self.A_WHILE))
        self.assertEqual(report["matches"], 2 * report["ended_after"])
        text = self.succeed("report", "open.db")
        self.assertIn(f"after {report['ended_after']} pairs, a number", text)
        self.assertNotIn("0000", text)
        # Interrupted, it must be told how long to go on.
        words[words.index("open.db")] = "more.db"
        with self.start(*words, "--minutes", 9, stderr=subprocess.PIPE) as running:
            self.wait_for(lambda: self.count("more.db") > 0)
            running.send_signal(signal.SIGINT)
            self.assertIn("--minutes 9 --resume", running.communicate()[1])
        self.assertIn("no number of pairs was asked for", self.refused("resume", "more.db"))
        self.assertIn("without a gap: the tournament is not at its end", self.run_program("report", "more.db").stderr)

    def test_a_test_without_a_number_of_pairs(self):
        words = [each for each in self.arguments("--sprt", "0,1") if each not in ("--pairs", 3)]
        with self.start(*words, stderr=subprocess.PIPE, stdout=subprocess.PIPE) as running:
            first = running.stderr.readline()
            running.send_signal(signal.SIGTERM)
            error = running.communicate(timeout=program.PATIENCE)[1]
        self.assertEqual(running.returncode, 143)
        self.assertTrue(first.startswith("match 1, seed "), first)
        self.assertRegex(error, r"interrupted after \d+ matches \(the test ends the study\); to go on: ")
        self.assertNotIn("0000", error)
        said = self.run_program("report", "tournament.db")
        self.assertIn("matches (the test ends the study) without a gap: the tournament is not at its end", said.stderr)
        self.assertIn("; pairs until the test ends the study, seeds from ", said.stdout)
        self.assertNotIn("of 10000000", said.stdout)
        # SIGTERM loses nothing: it goes on, here until the clock stops it.
        rows = self.count()
        self.succeed("resume", "tournament.db", "--no-page", "--quiet", "--minutes", self.A_WHILE)
        self.assertGreater(self.count(), rows)
        self.assertRegex(self.succeed("report", "tournament.db"), r"The clock stopped it after \d+ pairs\.\n")

    def test_which_day_is_meant(self):
        then = datetime.datetime.now() + datetime.timedelta(minutes=2)
        for quiet in ((), ("--quiet",)):
            done = self.run_program(*self.arguments(*quiet, "--until", f"{then:%H:%M}", "--results", f"{len(quiet)}.db", pairs=1))
            self.assertEqual(done.returncode, 0)
            self.assertIn(f"no match begins after {then:%Y-%m-%d %H:%M}; the study ends then, after a whole pair\n", done.stderr)
        with self.start(*self.arguments("--until", f"{then:%H:%M}", "--results", "more.db", pairs=self.NEVER_DONE),
                        stderr=subprocess.PIPE) as running:
            self.wait_for(lambda: self.count("more.db") > 0)
            running.send_signal(signal.SIGINT)
            self.assertIn(f"--until '{then:%Y-%m-%d %H:%M}' --results more.db --resume", running.communicate()[1].replace("\n", " "))

    def test_a_document_that_only_the_clock_can_end_is_sound(self):
        self.write("open.yaml", "tournament: open\nteams: [{team: small.yaml}, {team: other.yaml}]\n")
        done = self.run_program("config", "check", "open.yaml")
        self.assertEqual((done.returncode, done.stdout), (0, "open.yaml: tournament, sound\n"))
        self.assertIn("open.yaml:1:1: warning: pairs: no number of them", done.stderr)

    def test_several_pairings_and_a_sequential_test(self):
        report = self.stopped("--team", "worse.yaml", file="three.db")
        self.assertEqual({each["games"] for each in report["pairings"]}, {2 * report["ended_after"]})
        report = self.stopped("--metric", "silent_seconds", file="test.db")
        self.assertEqual(report["verdict"], "INCONCLUSIVE")
        on = json.loads(self.succeed("resume", "test.db", "--no-page", "--quiet", "--json", "--minutes", self.A_WHILE))
        self.assertNotIn("pairs_before", on)  # its error rates hold at any pair

    def test_no_pair_is_no_result(self):
        done = self.run_program(*self.arguments("--quiet", "--minutes", 0.000001, pairs=50))
        self.assertEqual(done.returncode, 1)
        self.assertIn("the time was over before the first pair of matches was played: nothing can be said; to go on: ",
                      done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertNotIn("ended_after", self.stored("SELECT value FROM meta WHERE name = 'schedule'")[0][0])

    def test_an_experiment_too(self):
        self.write("e.yaml", experiment.EXPERIMENT.format(more=experiment.PRIMARY).replace("matches: 4", "matches: 5000"))
        report = json.loads(self.succeed("run", "e.yaml", "--no-page", "--quiet", "--json", "--minutes", self.A_WHILE))
        after = report["ended_after"]
        self.assertEqual((report["pairs"], report["matches"], report["complete"]), (2500, 4 * after, True))
        self.assertIn(f"after {after} of 2500 pairs", " ".join(report["findings"]))
        self.assertEqual(json.loads(self.succeed("report", "trial.db", "--json")), report)
        on = json.loads(self.succeed("resume", "trial.db", "--no-page", "--quiet", "--json", "--pairs", after + 1))
        self.assertEqual((on["pairs"], on["pairs_before"], on["complete"]), (after + 1, str(after), True))
        self.assertIn("Pairs were added after a look.", on["findings"][0])

    def test_bad_times(self):
        self.assertIn("this time is past", self.refused(*self.arguments("--until", "2020-01-01T08:00")))
        self.assertIn("is no time", self.refused(*self.arguments("--until", "8 o'clock")))
        self.assertIn("expected a number above 0", self.refused(*self.arguments("--minutes", 0)))
        self.assertIn("one of them", self.refused(*self.arguments("--minutes", 1, "--until", "08:00")))
        self.assertFalse((self.folder / "tournament.db").exists())


class TooFewPairs(tournament.Tournament):
    def test_a_tournament_says_so_before_it_plays(self):
        self.assertIn("5 pairs cannot give a verdict: at least 6 are needed\n", self.noted(pairs=5))
        self.assertNotIn("cannot give a verdict", self.noted(pairs=6))
        self.assertIn("6 pairs cannot give a verdict: at least 7 are needed with 3 pairings\n",
                      self.noted(pairs=6, teams=("small.yaml", "other.yaml", "worse.yaml")))

    def noted(self, **options):
        (self.folder / "tournament.db").unlink(missing_ok=True)
        done = self.run_program(*self.arguments(**options))
        self.assertEqual(done.returncode, 0)
        return done.stderr


class Notice(tournament.Tournament):
    """--notify: a command of the shell when a study has ended, however it has."""

    NOTE = 'printf "%s\\n" "$REGISTA_STATUS" "$REGISTA_MESSAGE" "$REGISTA_RESULTS" > note.txt'

    def note(self):
        return (self.folder / "note.txt").read_text().splitlines()

    def test_a_study_that_is_complete(self):
        report = self.succeed(*self.arguments("--quiet", "--results", "r.db", "--notify", self.NOTE))
        status, message, results = self.note()
        self.assertEqual((status, results), ("done", str(self.folder / "r.db")))
        self.assertIn(message, " ".join(report.split()))
        (self.folder / "note.txt").unlink()
        self.succeed("resume", "r.db", "--quiet", "--notify", self.NOTE)
        self.assertEqual(self.note()[0], "done")

    def test_a_study_that_the_clock_stops_before_its_first_pair(self):
        self.run_program(*self.arguments("--quiet", "--minutes", "0.0001", "--results", "none.db", "--notify", self.NOTE, pairs=500))
        self.assertEqual(self.note()[0], "stopped")

    def test_a_study_that_fails(self):
        """Something writes into the file of results while it is played."""
        results = self.folder / "r.db"
        with self.start(*self.arguments("--quiet", "--results", "r.db", "--notify", self.NOTE, pairs=5000),
                        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: self.count("r.db") >= 2)
            results.rename(self.folder / "moved.db")
            error = process.communicate(timeout=program.PATIENCE)[1]
        self.assertEqual(process.returncode, 1, error)
        status, message, file = self.note()
        self.assertEqual((status, file), ("failed", str(results)))
        self.assertIn(f"regista: {message}", " ".join(error.split()))

    def test_a_study_that_is_interrupted(self):
        with self.start(*self.arguments("--quiet", "--results", "r.db", "--notify", self.NOTE, pairs=5000),
                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            self.wait_for(lambda: self.count("r.db") >= 2)
            process.send_signal(signal.SIGINT)
            process.wait(timeout=program.PATIENCE)
        self.assertEqual(process.returncode, 130)
        status, message, file = self.note()
        self.assertEqual((status, file), ("stopped", str(self.folder / "r.db")))
        self.assertNotEqual(message, "")

    def test_a_command_that_fails_changes_no_status(self):
        done = self.run_program(*self.arguments("--quiet", "--results", "r.db", "--notify", "exit 3"))
        self.assertEqual((done.returncode, done.stderr), (0, "regista: the command of --notify failed: exit 3\n"))
