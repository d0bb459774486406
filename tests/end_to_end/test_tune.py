# SPDX-License-Identifier: MIT
"""`regista tune`: the search, its resumption, the verdict, and the team that comes of it."""

import csv
import io
import json
import time
import unittest

import program
import tournament

TUNING = """\
tuning: trial
question: Is another scale better?
team: small.yaml
opponents:
  - {{team: other.yaml, weight: 2}}
  - {{team: worse.yaml}}
parameters: {parameters}
objective: {objective}
openings: scenes
seed: 7
search: {{algorithm: {algorithm}, matches: {matches}{search}}}
selection: {{finalists: 2, matches: 8}}
verification: {{candidates: 1, matches: 24, against: base}}
slices: {{points: 2, pairs: 2}}
seeds: consecutive
{more}"""
FREE = "[utility.terms.distance.weight, utility.terms.bearing.weight]"
SHIPPED = program.PROGRAM.parent.parent / "lib" / "regista" / "plugins"
TEAMS = program.SOURCE / "configs" / "teams"


class Tuning(tournament.Tournament):
    """Teams of shipped plugins, whose weights matter; small.yaml has bad ones."""

    plugins = ()

    def setUp(self):
        super().setUp()
        self.plugin_folder.rmdir()
        self.plugin_folder.symlink_to(SHIPPED)
        bad = "utility: {terms: {distance: {weight: 0.02}, bearing: {weight: 0.8}}}\n"
        for name, base, more in (("small", "paper", bad), ("other", "fixed_rate", ""), ("worse", "spqr2023", "")):
            self.write(f"{name}.yaml", f"extends: {TEAMS}/{base}.yaml\nteam: {name}\n{more}")
        self.document()

    def document(self, more="", parameters=FREE, algorithm="spsa", matches=24 if program.SANITIZED else 40, search="", changes=(),
                 objective="{minimise: uncovered_seconds}"):
        text = TUNING.format(more=more, parameters=parameters, algorithm=algorithm, matches=matches, search=search,
                             objective=objective)
        for what, instead in changes:
            self.assertIn(what, text)
            text = text.replace(what, instead)
        return self.write("t.yaml", text)

    def arguments(self, *more):
        words = ["tune", "t.yaml"]
        if not self.pages:
            words.append("--no-page")
        return [*words, *more]

    def tune(self, *more):
        return json.loads(self.succeed(*self.arguments("--quiet", "--json", *more)))

    def assert_same_matches(self, file, alone):
        """alone: played by one worker. Others may have been under way when the verification was decided: these are
        beyond its last pair, and count for nothing."""
        theirs = self.rows(alone)
        rows = {each[0] for each in theirs}
        more = [each for each in self.rows(file) if each[0] not in rows]
        self.assertEqual([each for each in self.rows(file) if each[0] in rows], theirs)
        last = max(each[0] for each in theirs if each[2] >> 50 == 2)
        self.assertTrue(all(each[2] >> 50 == 2 and each[0] > last for each in more), more)

    def trace(self, file):
        return list(csv.DictReader(io.StringIO((self.folder / file).read_text(), newline="")))


class Played(Tuning):
    def test_how_a_robot_plays_the_ball_is_tuned(self):
        path = "behaviours.play_ball.params.creep_speed"
        self.document(parameters=f"[{path}]", matches=24, objective="{maximise: touches}")
        told = self.tune("--trace", "trace.csv", "--workers", 2)
        self.assertEqual([each["path"] for each in told["parameters"]], [path])
        trace = self.trace("trace.csv")
        self.assertGreater(len({row[path] for row in trace}), 2, trace)
        self.assertGreater(len({row["value"] for row in trace}), 1, "it plays otherwise with another speed")

    def test_trace_does_not_depend_on_workers_or_interruptions(self):
        for algorithm in ("spsa",) if program.SANITIZED else ("spsa", "sbplx", "isres"):
            with self.subTest(algorithm):
                self.document(algorithm=algorithm, matches=200 if algorithm == "isres" else 40,
                              search=", population: 6" if algorithm == "isres" else "")
                names = [f"{algorithm}_{each}" for each in ("one", "two", "three")]
                once = self.succeed(*self.arguments("--quiet", "--json", "--workers", 1, "--results", names[0] + ".db",
                                                    "--trace", "one.csv", "--output", "tuned.yaml"))
                team = (self.folder / "tuned.yaml").read_text()
                twice = self.succeed(*self.arguments("--quiet", "--json", "--workers", 2, "--results", names[1] + ".db",
                                                     "--trace", "two.csv", "--output", "tuned.yaml"))
                self.assertEqual(once, twice)
                self.assertEqual(self.trace("one.csv"), self.trace("two.csv"))
                self.assertEqual(team, (self.folder / "tuned.yaml").read_text())
                file = names[2] + ".db"
                for wanted in (3, 30, 50):  # in the search, and later
                    resume = ["--resume"] if wanted > 3 else []
                    self.kill_when(lambda: self.count(file) >= wanted,
                                   *self.arguments("--quiet", "--results", file, *resume))
                resumed = self.succeed(*self.arguments("--quiet", "--json", "--results", file, "--resume", "--trace",
                                                       "three.csv", "--output", "tuned.yaml"))
                self.assertEqual(resumed, once)
                self.assertEqual(self.trace("three.csv"), self.trace("one.csv"))
                for each in names[1:]:
                    self.assert_same_matches(each + ".db", names[0] + ".db")
                self.assertEqual(team, (self.folder / "tuned.yaml").read_text())
                # What is stored says the same, without the files it came from.
                self.assertEqual(list(csv.DictReader(io.StringIO(self.succeed("report", file, "--csv")))),
                                 self.trace("one.csv"))
                told, reported = json.loads(once), json.loads(self.succeed("report", file, "--json"))
                for each in (told, reported):
                    each.pop("tuned_file")
                self.assertEqual(told, reported)

    def test_stages_play_seeds_of_their_own(self):
        self.tune()
        stages = [{seed & (1 << 50) - 1 for seed, in self.stored(
            f"SELECT DISTINCT seed FROM matches WHERE seed >> 50 = {stage}", "trial.db")} for stage in range(4)]
        self.assertTrue(all(stages))
        # All matches were of one of them, and those of the verification begin somewhere else.
        self.assertEqual(self.stored("SELECT count(*) FROM matches WHERE seed >> 50 > 3", "trial.db"), [(0,)])
        self.assertFalse(stages[2] & (stages[0] | stages[1]))

    def test_tuned_team_plays_what_was_verified(self):
        report = self.tune()
        file = self.folder / "trial.tuned.yaml"
        checked = self.run_program("config", "check", file.name)
        self.assertEqual((checked.returncode, checked.stdout), (0, f"{file.name}: team, sound\n"))
        # What the base team has, the tuned one has.
        self.assertRegex(checked.stderr, r"\A(regista: .*paper\.yaml:\d+:\d+: warning: utility\.terms\.waypoint: .*\n)?\Z")
        text = file.read_text()
        self.assertTrue(text.startswith("# Tuned by Regista"))
        self.assertIn("VERIFIED", text.splitlines()[0])
        self.assertIn('extends: "small.yaml"', text)
        # A match of the verification that the tuned team played at home is the match of the file.
        query = "SELECT seed, hash, job FROM matches JOIN fixtures ON fixture = id WHERE seed >> 50 = 2"
        told, own = 0, [f"home.{each['path']}={each['tuned']!r}" for each in report["tuned"]["values"]]
        for seed, hashed, job in self.stored(query, "trial.db"):
            job = json.loads(job)
            if told > 2 or not set(own) <= set(job["overrides"]):
                continue
            told += 1
            match = json.loads(self.succeed("match", file.name, job["teams"][1], "--opening", job["opening"], "--seed",
                                            seed, "--json"))
            self.assertEqual(match["state_hash"], hashed)
        self.assertGreater(told, 0)
        # The file, and the values as settings, make the same robots do the same.
        settings = [f"a.{each['path']}={each['tuned']!r}" for each in report["tuned"]["values"]]
        words = [word for each in settings for word in ("--set", each)]
        scene = ("--opening", "scenes/left.yaml", "--seed", "11", "--json")
        by_file = json.loads(self.succeed("match", "trial.tuned.yaml", "other.yaml", *scene))
        by_values = json.loads(self.succeed("match", "small.yaml", "other.yaml", *words, *scene))
        as_it_was = json.loads(self.succeed("match", "small.yaml", "other.yaml", *scene))
        self.assertEqual(by_file["state_hash"], by_values["state_hash"])
        self.assertNotEqual(by_file["state_hash"], as_it_was["state_hash"])

    def test_stored_match_is_played_again(self):
        self.tune()
        for stage in range(4):
            query = f"SELECT row, hash FROM matches WHERE seed >> 50 = {stage} ORDER BY row LIMIT 1"
            (row, hashed), = self.stored(query, "trial.db")
            done = self.run_program("match", "--from", "trial.db", "--row", row, "--json")
            self.assertEqual(json.loads(done.stdout)["state_hash"], hashed)
        last, = self.stored("SELECT max(row) FROM matches", "trial.db")[0]
        self.assertEqual(self.refused("match", "--from", "trial.db", "--row", last + 1),
                         f"--row {last + 1}: this match of trial.db has not been played")

    def test_crashing_candidates_get_the_worst_value(self):
        deaths = program.TEST_PLUGINS / "deaths"
        with open(self.folder / "small.yaml", "a") as file:
            file.write("contexts: [{name: playing, priority: 0, plugin: dies_of_daring}]\n")
        self.document(parameters="[contexts.playing.params.daring]", algorithm="random_search", matches=40,
                      objective="{maximise: goal_difference}")
        report = self.tune("--plugins", deaths, "--trace", "trace.csv")
        crashed = [row for row in self.trace("trace.csv") if row["failed"] == "1"]
        sound = [row for row in self.trace("trace.csv") if row["failed"] == "0"]
        self.assertTrue(crashed and sound)
        path = "contexts.playing.params.daring"
        self.assertTrue(all(float(row[path]) > 0.5 for row in crashed))
        self.assertTrue(all(float(row[path]) <= 0.5 for row in sound))
        worst = {float(row["value"]) for row in crashed}
        self.assertEqual(len(worst), 1)
        self.assertLess(worst.pop(), min(float(row["value"]) for row in sound))
        self.assertGreater(report["search"]["failed"], 0)
        if report["tuned"]:
            self.assertLessEqual(report["tuned"]["values"][0]["tuned"], 0.5)
        # The base team itself must play.
        refused = self.refused(*self.arguments("--plugins", deaths, "--results", "b.db", "--quiet", "--set",
                                               "set={contexts.playing.params.daring: 0.9}"))
        self.assertRegex(refused, "^tuning: the base team forfeits its first matches: plugin dies_of_daring in holds: ")

    def test_time_ends_the_search_and_is_remembered(self):
        self.document(matches=4000, search=", minutes: 0.02")
        first = self.tune("--trace", "first.csv")
        self.assertLess(len(self.trace("first.csv")), 900)
        self.assertIn("time", first["search"]["ended"])
        again = self.tune("--trace", "again.csv", "--resume")
        self.assertEqual(first, again)
        self.assertEqual(self.trace("first.csv"), self.trace("again.csv"))

    def test_time_is_not_counted_while_stored_points_are_told(self):
        self.document(matches=60 if program.SANITIZED else 120, search=", minutes: 60")
        self.kill_when(lambda: self.count("trial.db") >= 40, *self.arguments("--quiet"))
        # As if it had taken almost an hour.
        self.change("UPDATE meta SET value = substr(value, 1, instr(value, ' ')) || '3599.9' "
                    "WHERE name = 'time of search'", "trial.db")
        before = self.count("trial.db")
        report = self.tune("--resume")
        self.assertEqual(report["search"]["ended"], "its time was up")
        self.assertGreaterEqual(report["matches"]["search"] + 4, before - before % 4)
        self.assertTrue(report["complete"])
        self.assertEqual(self.tune("--resume"), report)

    def test_inputs_are_not_replaced(self):
        self.write("mine.tuned.yaml", (self.folder / "small.yaml").read_text())
        self.document(changes=(("team: small.yaml", "team: mine.tuned.yaml"),))
        text = (self.folder / "mine.tuned.yaml").read_text()
        self.write("mine.tuned.yaml", "# Tuned by Regista, once\n" + text)
        for words in (("--output", "mine.tuned.yaml"), ("--trace", "t.yaml"), ("--trace", "./other.yaml")):
            line = self.refused(*self.arguments("--quiet", *words))
            self.assertEqual(line, f"{words[0]} {words[1]}: is a file that this tuning reads")
        self.assertIn("no_such/x.yaml: cannot be written there: No such file or directory",
                      self.refused(*self.arguments("--quiet", "--output", "no_such/x.yaml")))
        self.assertFalse((self.folder / "trial.db").exists())

    def test_interrupted_says_how_to_go_on(self):
        self.document(matches=40)  # with fewer it finds no other team
        with self.start(*self.arguments("--quiet"), stdout=-1, stderr=-1) as process:
            self.wait_for(lambda: self.count("trial.db") >= 3)
            process.send_signal(2)
            out, err = process.communicate(timeout=30)
        self.assertEqual(process.returncode, 130, err)
        self.assertRegex(err.splitlines()[-1], r"interrupted after \d+ of \d+ matches; to go on: .*--resume")
        self.assertIn("not at its end", self.run_program("report", "trial.db").stderr)
        (self.folder / "t.yaml").unlink()  # the file of results knows what was asked
        resumed = json.loads(self.succeed("resume", "trial.db", "--quiet", "--json", "--no-page"))
        self.document(matches=40)
        whole = self.tune("--results", "whole.db", "--workers", 1)
        tuned = [(self.folder / each.pop("tuned_file")).read_text() for each in (resumed, whole)]
        self.assertEqual(resumed, whole)
        self.assertEqual(*(each[each.index("\nutility:"):] for each in tuned))  # what stands before it is called by the file
        self.assert_same_matches("trial.db", "whole.db")

    def test_packets_of_short_games_are_told_again(self):
        """By who reads no other numbers, because the scores decide."""
        for name, y in (("left", 0.3), ("right", -0.3)):  # where most kicks are goals
            text = tournament.SCENE.format(name=name, y=y)
            self.write(f"scenes/{name}.yaml", text.replace("at: [3, ", "at: [4.2, ").replace("at: [2.7, ", "at: [3.9, "))
        self.document(matches=40, objective="{minimise: goal_difference}")
        told = self.tune()
        reported = json.loads(self.succeed("report", "trial.db", "--json"))
        packets = [[each["packets_of_short_games"] for each in report["verification"]["candidates"]]
                   for report in (told, reported)]
        self.assertEqual(*packets)
        self.assertTrue(packets[0] and all(each["per_match"] > 0 for each in packets[0]), packets)

    def test_opponent_that_is_the_base_is_noted(self):
        self.document(changes=(("other.yaml", "small.yaml"),))
        done = self.run_program(*self.arguments())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("note: small is the base team itself", done.stderr)

    def test_stranger_is_not_replaced(self):
        self.write("trial.tuned.yaml", "mine: 1\n")
        line = self.refused(*self.arguments("--quiet"))
        self.assertIn("--output names another file", line)
        self.assertFalse((self.folder / "trial.db").exists())
        self.assertEqual((self.folder / "trial.tuned.yaml").read_text(), "mine: 1\n")

    def test_changed_team_is_not_mixed(self):
        self.tune()
        self.write("other.yaml", (self.folder / "other.yaml").read_text() + "utility: {terms: {distance: {weight: 0.6}}}\n")
        line = self.refused(*self.arguments("--quiet", "--resume"))
        self.assertIn("--resume: trial.db was begun with something else: other: team", line)


class Page(Tuning):
    pages = True

    def test_page_and_figures(self):
        self.tune()
        page = (self.folder / "trial.html").read_text()
        self.assertIn("Is another scale better?", page)
        figures = {each.name for each in (self.folder / "trial.figures").iterdir()}
        self.assertTrue({"convergence.svg", "importance.svg", "slice_1.svg", "slice_2.svg"} <= figures, figures)
        before = page
        self.succeed("report", "trial.db", "-o", "again.html")
        self.assertEqual((self.folder / "again.html").read_text(), before)


class BadInput(Tuning):
    def assert_refused(self, line, *more):
        began = time.monotonic()
        self.assertEqual(self.refused(*self.arguments("--quiet", *more)), line)
        self.assertFalse((self.folder / "trial.db").exists())
        self.assertLess(time.monotonic() - began, 20)

    def test_parameters(self):
        self.document(parameters="[utility.terms.bearing.wieght]")
        self.assertTrue(self.refused(*self.arguments()).startswith(
            't.yaml:7:14: parameters: "utility.terms.bearing.wieght" is no number of this team; '
            "nearest: utility.terms.bearing.weight, "))
        self.document(parameters="[sender.params.role_changed]")
        self.assert_refused("t.yaml:7:14: parameters: sender.params.role_changed cannot be tuned: plugin event_based "
                            "declares it as something else than a number")
        self.document(parameters="[nothing.*]")
        self.assertIn("matches nothing that can be tuned", self.refused(*self.arguments()))
        path = "path: utility.terms.distance.weight"
        self.document(parameters=f"[{{{path}, range: [3, 1]}}]")
        self.assert_refused("t.yaml:7:59: parameters.0.range: empty: 3 is more than 1")
        self.document(parameters=f"[{{{path}, range: [.nan, 1]}}]")
        self.assertIn("parameters.0.range.0", self.refused(*self.arguments()))
        self.document(parameters=f"[{{{path}, range: [0.5, 20]}}]")
        self.assert_refused("t.yaml:7:59: parameters: utility.terms.distance.weight: 0.5 to 20 is wider than what is "
                            "declared, 0 to 1; a range can be narrowed only")
        self.document(parameters=f"[{{{path}, range: [0.3, 0.4]}}]")
        self.assert_refused("t.yaml:7:59: parameters: utility.terms.distance.weight: the team's own 0.02 is outside 0.3 to 0.4")
        self.document(parameters=f"[{{{path}, range: [0.02, 0.02]}}]")
        self.assertIn("there is nothing to tune", self.refused(*self.arguments()))

    def test_algorithms(self):
        self.document(algorithm="spas")
        self.assertIn('t.yaml:11:21: search.algorithm: unknown algorithm "spas"; nearest: "spsa"',
                      self.refused(*self.arguments()))
        for name, why in (("LN_NEWUOA_BOUND", "hang"), ("ld_lbfgs", "gradient"), ("praxis", "noisy"),
                          ("GN_DIRECT", "direct_l")):
            self.document(algorithm=name)
            line = self.refused(*self.arguments())
            self.assertIn(f"t.yaml:11:21: search.algorithm: {name}: ", line)
            self.assertIn(why, line)
            self.assertIn("; offered: sbplx, bobyqa, ", line)
        for name in ("gn_ags", "slsqp"):
            self.document(algorithm=name)
            self.assertIn(f't.yaml:11:21: search.algorithm: unknown algorithm "{name}"; known: sbplx, bobyqa, ',
                          self.refused(*self.arguments()))
        self.document(algorithm="sbplx", search=", population: 8")
        self.assertIn("search.population: sbplx has none", self.refused(*self.arguments()))

    def test_points_to_start_from(self):
        for point, column, line in (
                ("utility.terms.baering.weight: 0.5", 54,
                 'unknown parameter "utility.terms.baering.weight" in search.start_from; nearest: '
                 '"utility.terms.bearing.weight"; known: utility.terms.distance.weight, utility.terms.bearing.weight'),
                ("utility.terms.persistence.weight: 0.5", 54,
                 'unknown parameter "utility.terms.persistence.weight" in search.start_from; '),
                ("utility.terms.bearing.weight: 1.5", 84,
                 "search.start_from: utility.terms.bearing.weight: 1.5 is outside 0 to 1"),
                ("utility.terms.bearing.weight: -0.1", 84,
                 "search.start_from: utility.terms.bearing.weight: -0.1 is outside 0 to 1"),
                ("utility.terms.bearing.weight: much", 84, 'search.start_from.0.utility.terms.bearing.weight: "much" is not a number')):
            with self.subTest(point):
                self.document(matches=40, search=f", start_from: [{{{point}}}]")
                told = self.refused(*self.arguments())
                self.assertTrue(told.startswith(f"t.yaml:11:{column}: {line}"), told)
                self.assertFalse((self.folder / "trial.db").exists())

    def test_budgets(self):
        self.document(matches=4)
        self.assertRegex(self.refused(*self.arguments()),
                         r"^t\.yaml:11:\d+: search\.matches: 4 are too few for the first round of spsa, .*expected "
                         r"\d+ or more matches$")
        self.document(changes=(("finalists: 2, matches: 8", "finalists: 2, matches: 7"),))
        self.assertIn("selection.matches", self.refused(*self.arguments()))

    def test_objective_and_files(self):
        self.document(objective="{maximise: goal_diference}")
        self.assertIn('objective: unknown measure "goal_diference"; nearest: "goal_difference"',
                      self.refused(*self.arguments()))
        self.document(changes=(("team: other.yaml", "team: otter.yaml"),))
        self.assertIn('nearest: "other.yaml"', self.refused(*self.arguments()))
        self.assertEqual(self.refused("tune"), "tune: which one? Name its file; see: regista tune --help")
        self.write("e.yaml", "team: x\n")
        self.assertIn("this is a team document; expected a tuning document", self.refused("tune", "e.yaml"))


if __name__ == "__main__":
    unittest.main()
