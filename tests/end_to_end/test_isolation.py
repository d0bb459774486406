# SPDX-License-Identifier: MIT
"""Teams that think in a process each: the same matches, and whoever dies, stops or sleeps is its team's to answer
for, whatever killed it and whoever's call was under way."""

import ctypes
import errno
import itertools
import json
import platform
import shlex
import struct
import subprocess
import unittest

import experiment
import program
import tournament

THREADS = program.TEST_PLUGINS / "threads"
WAITS = program.TEST_PLUGINS / "waits"
TRESPASS = program.TEST_PLUGINS / "trespass"
OPENING = program.SOURCE / "configs" / "openings" / "counter_two_on_one.yaml"


class Equality(tournament.Tournament):
    def test_an_isolated_match_is_the_ordinary_one(self):
        for more in ((), ("--play-once",)):
            ordinary = self.play("--results", "ordinary.db", *more)
            isolated = self.play("--results", "isolated.db", "--isolation", "always", *more)
            self.assertEqual(isolated, ordinary)
            self.assertEqual(self.rows("isolated.db"), self.rows("ordinary.db"))
            self.assertEqual(len({row[6] for row in self.rows("ordinary.db")}), 6)  # hashes
            for file in self.folder.glob("*.db"):
                file.unlink()

    def test_it_can_be_recorded_and_played_again(self):
        for name, more in (("ordinary", ()), ("isolated", ("--isolation", "always"))):
            self.play("--results", f"{name}.db", "--record-every", "2", *more, pairs=1)
        for row in "1", "2":
            done = self.run_program("match", "--from", "isolated.db", "--row", row)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rf"the same match as row {row}: hash [0-9a-f]{{16}}\n$")
        ordinary, isolated = (sorted((self.folder / f"{name}.recordings").iterdir())
                              for name in ("ordinary", "isolated"))
        self.assertEqual([file.name for file in isolated], ["1.mcap"])
        self.assertEqual([file.read_bytes() for file in isolated], [file.read_bytes() for file in ordinary])

    def test_another_word(self):
        self.assertEqual(self.refused(*self.arguments("--isolation", "allways")),
                         '--isolation allways: isolation: unknown value "allways"; nearest: "always"; known: after-death, always')


class ShippedTeams(program.ShippedCase):
    def test_an_isolated_match_is_the_ordinary_one(self):
        teams = [word for name in ("paper", "fixed_rate")
                 for word in ("--team", program.SOURCE / "configs" / "teams" / f"{name}.yaml")]
        words = ("tournament", *teams, "--pairs", "1", "--openings", OPENING, "--no-page", "--quiet", "--play-once")
        for name, more in (("ordinary", ()), ("isolated", ("--isolation", "always"))):
            self.succeed(*words, "--results", f"{name}.db", *more)
        rows = [self.succeed("report", f"{name}.db", "--csv", "--metrics") for name in ("ordinary", "isolated")]
        self.assertEqual(len(rows[0].splitlines()), 3)
        self.assertEqual(*rows)


class Blame(tournament.Tournament):
    LIMITS = ("--memory", "512")

    def forfeited(self, plugin, folder, *more, teams=("bad.yaml", "small.yaml"), pairs=1):
        """Every match is forfeited by the team of this plugin, for the same reason, which is returned."""
        self.with_context(plugin)
        report = self.only("--plugins", folder, *self.LIMITS, *more, teams=teams, pairs=pairs)
        for team in report["teams"]:
            self.assertEqual(team["failures"], 2 * pairs if team["name"] == "bad" else 0, report["forfeits"])
        self.assertEqual(report["unplayed"]["pairs"], 0)
        rows = self.stored("SELECT home_goals, away_goals, ended, failure FROM matches ORDER BY row")
        bad_at_home = itertools.cycle([teams[0] == "bad.yaml", teams[0] != "bad.yaml"])
        reasons = set()
        for at_home, (home, away, ended, failure) in zip(bad_at_home, rows):
            self.assertEqual((home, away, ended), (0, 10, "forfeit") if at_home else (10, 0, "forfeit"))
            self.assertEqual(json.loads(failure)["side"], 0 if at_home else 1)
            reasons.add(json.loads(failure)["what"])
        return reasons

    def test_a_death_in_a_thread(self):
        for teams in ("bad.yaml", "small.yaml"), ("small.yaml", "bad.yaml"):
            with self.subTest(teams):
                for reason in self.forfeited("crashes_later", THREADS, teams=teams, pairs=2):
                    if not program.SANITIZED:
                        self.assertRegex(reason, r'^Segmentation fault, in thread "\w+", in threads\.so'
                                                 r"(, between two calls)?$")
            (self.folder / "tournament.db").unlink()

    def test_an_exit_in_a_thread(self):
        for reason in self.forfeited("exits_later", THREADS):
            self.assertRegex(reason, r"^ended the process \(exit code 0\)(, between two calls)?$")

    @unittest.skipIf(program.SANITIZED, "sanitizers have handlers of their own")
    def test_a_plugin_is_named_only_for_what_ended_in_its_code(self):
        """Else its team is, with the shared object in which it came: whose call was under way says nothing."""
        for plugin, folder, named, reason in (
                ("aborts", program.TEST_PLUGINS / "deaths", "aborts", r"^Aborted, in deaths\.so$"),
                ("crashes_later", THREADS, "", r'^Segmentation fault, in thread "\w+", in threads\.so'),
                ("exits_later", THREADS, "", r"^ended the process"),
                ("rings_later", THREADS, "", r"^Alarm clock"),
                ("crashes_in_a_handler", THREADS, "", r"^Segmentation fault, in threads\.so"),
                ("frees_twice", THREADS, "", r"^Aborted, in threads\.so")):
            with self.subTest(plugin):
                for found in self.forfeited(plugin, folder):
                    self.assertRegex(found, reason)
                failures = self.stored("SELECT DISTINCT json_extract(failure, '$.plugin') FROM matches")
                self.assertEqual(failures, [(named,)])
                (self.folder / "tournament.db").unlink()

    def test_what_is_left_in_the_process(self):
        for plugin, what in (("leaves_a_child", "left a process running"), ("leaves_an_orphan", "left a process running"),
                             ("blocks_a_signal", "changed which signals are blocked"),
                             ("sets_a_variable", 'changed the environment variable "OF_A_PLUGIN"'),
                             ("changes_the_umask", "changed the mode of new files (umask)")):
            with self.subTest(plugin):
                self.assertEqual(self.forfeited(plugin, program.TEST_PLUGINS / "leaves"), {what})
                (self.folder / "tournament.db").unlink()

    def test_a_thread_that_stays(self):
        self.assertEqual(self.forfeited("stays_later", THREADS), {"left 1 thread running"})

    def test_a_worker_that_is_stopped(self):
        reason, = self.forfeited("stops", WAITS)
        self.assertEqual(reason, "was stopped (Stopped (signal))")

    def test_a_plugin_that_sleeps(self):
        self.assertEqual(self.forfeited("sleeps", WAITS, "--wall-seconds", "1"), {"did not return within 1 s"})
        failure, = set(self.stored("SELECT json_remove(failure, '$.side', '$.robot') FROM matches"))
        failure = json.loads(failure[0])
        self.assertEqual((failure["plugin"], failure["call"], failure["tick"]), ("sleeps", "holds", 19))

    def test_a_plugin_that_takes_its_time(self):
        """No call takes long; the match does."""
        reason, = self.forfeited("dawdles", WAITS, "--match-seconds", "2")
        self.assertRegex(reason, r"^kept the match waiting for 2 s of the 2 s that a match may last$")


    def test_what_is_shared_with_others_is_out_of_reach(self):
        """A thread that wipes all shared memory finds its own team's alone: the other team plays on, or wins."""
        self.with_context("wipes_shared_memory")
        for teams in ("bad.yaml", "small.yaml"), ("small.yaml", "bad.yaml"):
            with self.subTest(teams):
                self.play("--plugins", TRESPASS, "--isolation", "always", *self.LIMITS, teams=teams, pairs=1)
                report = json.loads(self.succeed("report", "tournament.db", "--json"))
                failures = {team["name"]: team["failures"] for team in report["teams"]}
                self.assertEqual(failures["small"], 0, report["forfeits"])
                self.assertGreater(failures["bad"], 0)
            (self.folder / "tournament.db").unlink()

    @unittest.skipUnless(platform.machine() == "x86_64", "it writes code of that processor")
    def test_whose_code_was_written_over_is_not_blamed(self):
        """Neither by a match nor by a tournament, though it is the one that breaks a promise."""
        text = program.TEAM.format(name="bad")
        self.assertIn("plugin: every_second", text)
        self.write("bad.yaml", text.replace("plugin: every_second", "plugin: patches_sound_plugins"))
        line = self.refused("match", "bad.yaml", "small.yaml", "--plugins", TRESPASS, "--limit", 12)
        self.assertRegex(line, r"\bbad\b")
        self.assertNotIn("small", line)
        report = self.only("--plugins", TRESPASS, *self.LIMITS, teams=("bad.yaml", "small.yaml"), pairs=1)
        self.assertEqual({team["name"]: team["failures"] for team in report["teams"]}, {"bad": 2, "small": 0})

    def test_no_process_of_others_is_ended(self):
        """Whatever a plugin writes into the note that its coordinator reads."""
        self.with_context("names_a_stranger")
        with subprocess.Popen(["sleep", "100"], start_new_session=True) as stranger:
            try:
                done = self.run_program(*self.arguments("--quiet", "--plugins", TRESPASS, *self.LIMITS,
                                                        teams=("bad.yaml", "small.yaml"), pairs=1),
                                        environment={"STRANGER": str(stranger.pid)})
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIsNone(stranger.poll())
            finally:
                stranger.kill()

    def test_children_of_a_shell_that_became_the_program_are_not_its_own(self):
        words = [str(self.program), *map(str, self.arguments("--quiet", pairs=1))]
        command = f"exec {shlex.join(words)} > >(sleep 0.5; cat > told.txt)"
        done = subprocess.run(["bash", "-c", command], cwd=self.folder, timeout=120, stderr=subprocess.PIPE, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.wait_for(lambda: (self.folder / "told.txt").exists() and (self.folder / "told.txt").stat().st_size > 0)


def without_seccomp():
    """In a process that is about to run the program: no filter of system calls can be had from now on, as on a system
    without them."""
    library = ctypes.CDLL(None, use_errno=True)
    call_number, errno_eperm = 317, 0x00050000 | errno.EPERM  # SYS_seccomp of x86-64; SECCOMP_RET_ERRNO
    instructions = ((0x20, 0, 0, 0), (0x15, 0, 1, call_number), (0x06, 0, 0, errno_eperm), (0x06, 0, 0, 0x7FFF0000))
    code = ctypes.create_string_buffer(b"".join(struct.pack("HBBI", *each) for each in instructions))
    program_of_filter = ctypes.create_string_buffer(struct.pack("HxxxxxxQ", len(instructions), ctypes.addressof(code)))
    no_new_privileges, set_seccomp, filtered = 38, 22, 2
    if library.prctl(no_new_privileges, 1, 0, 0, 0) or library.prctl(set_seccomp, filtered, program_of_filter, 0, 0):
        raise OSError(ctypes.get_errno(), "this system has no filters either")


class Confinement(tournament.Tournament):
    @unittest.skipUnless(platform.machine() == "x86_64", "it knows the number of a system call of that processor")
    def test_where_processes_cannot_be_confined_nothing_is_proven(self):
        usual = self.report("--results", "usual.db", pairs=1)
        self.assertEqual(usual["not_proven"]["matches"], 0)
        done = self.run_program(*self.arguments("--json", "--quiet", pairs=1), preexec_fn=without_seccomp)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(json.loads(done.stdout)["not_proven"],
                         {"matches": 1, "listed": [{"match": 1, "what": "this system does not confine processes (seccomp)"}]})
        self.assertEqual(self.rows(), self.rows("usual.db"))
        self.assertTrue(self.succeed("report", "tournament.db").startswith(
            "not proven that robots decide alone: match 1: this system does not confine processes (seccomp)\n"))


class Documents(experiment.Experiment):
    """Experiments and tunings say in their documents how their matches are played; an option goes over it."""

    def plays(self, *more):
        """How many plays each of the four matches took: those of a team that dies at home and away, then of one that
        does not."""
        results = "trial.db"
        done = self.run_program("experiment", "e.yaml", "--plugins", program.TEST_PLUGINS / "deaths", "--no-page",
                                "--quiet", *more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        counts = [count for count, in self.stored("SELECT attempts FROM matches ORDER BY row", results)]
        ended = [how for how, in self.stored("SELECT ended FROM matches ORDER BY row", results)]
        (self.folder / results).unlink()
        self.assertEqual(ended, ["forfeit", "forfeit", "limit", "limit"])
        return counts

    def test_an_experiment(self):
        self.with_context("aborts")
        changes = [("small.yaml", "bad.yaml"), ("matches: 4", "matches: 2")]
        self.document("", changes)
        # Dead where both teams share a process, and again by itself; the first match of a pairing is played twice.
        self.assertEqual(self.plays(), [2, 2, 2, 1])
        self.assertEqual(self.plays("--isolation", "always"), [1, 1, 2, 1])
        self.assertEqual(self.plays("--isolation", "always", "--play-once"), [1, 1, 1, 1])
        self.document("isolation: always\n", changes)
        self.assertEqual(self.plays(), [1, 1, 2, 1])
        self.assertEqual(self.plays("--isolation", "after-death"), [2, 2, 2, 1])
        self.document("isolation: always\nplay_twice: false\n", changes)
        self.assertEqual(self.plays(), [1, 1, 1, 1])

    def test_a_tuning(self):
        self.with_context("aborts")
        text = ("tuning: tuned\nteam: small.yaml\nopponents: [{team: bad.yaml}]\n"
                "parameters: [{path: utility.terms.near.params.scale, range: [1, 2]}]\nlimit: 12\n"
                "search: {algorithm: random_search, matches: 4}\nselection: {finalists: 1, matches: 2}\n"
                "verification: {matches: 28}\nslices: {points: 0}\nset: {rules.durations.ready: 3}\n")
        for more, plays in ("", (2,)), ("isolation: always\n", (1,)):
            self.write("t.yaml", text + more)
            done = self.run_program("tune", "t.yaml", "--plugins", program.TEST_PLUGINS / "deaths", "--no-page",
                                    "--quiet")
            # A tuning against opponents that forfeit ends here; what was played so far is kept.
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("opponents forfeit: plugin aborts", done.stderr)
            self.assertEqual(self.stored("SELECT attempts FROM matches WHERE row = 1", "tuned.db"), [plays])
            (self.folder / "tuned.db").unlink()


if __name__ == "__main__":
    unittest.main()
