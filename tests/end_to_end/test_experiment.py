# SPDX-License-Identifier: MIT
"""`regista experiment`: arms against one opponent, pair by pair."""

import json
import math
import shlex
import statistics
import time
import unittest

import experiment


class Played(experiment.Experiment):
    def test_report_does_not_depend_on_workers_or_interruptions(self):
        once = self.succeed(*self.arguments("--quiet", "--json", "--workers", 1, "--results", "one.db"))
        twice = self.succeed(*self.arguments("--quiet", "--json", "--workers", 2, "--results", "two.db"))
        self.assertEqual(once, twice)
        self.assertEqual(self.rows("one.db"), self.rows("two.db"))
        self.assertEqual(len(self.rows("one.db")), 8)
        self.kill_when(lambda: self.count("three.db") >= 2, *self.arguments("--quiet", "--results", "three.db"))
        resumed = self.succeed(*self.arguments("--quiet", "--json", "--results", "three.db", "--resume"))
        self.assertEqual(resumed, once)
        self.assertEqual(self.rows("three.db"), self.rows("one.db"))
        self.assertEqual(self.succeed("report", "one.db", "--json"), once)
        self.assertEqual(self.succeed("report", "one.db"), self.succeed("report", "three.db"))

    def test_report_and_tables_agree(self):
        report = self.experiment("--csv", "long.csv", "--summary", "short.csv")
        self.assertTrue(report["complete"])
        self.assertEqual((report["matches"], report["pairs"]), (8, 2))
        rows = self.long_table("long.csv")
        told = 0
        values = {(row["arm"], int(row["seed"]), row["side"], row["measure"]): float(row["value"]) for row in rows}
        for measure in report["measures"]:
            name = measure["measure"]
            if not any(row["measure"] == name for row in rows):  # of what did not happen in any match
                self.assertEqual({condition["pairs"] for condition in measure["conditions"]}, {0})
                continue
            told += 1
            of_arm = {}
            for condition in measure["conditions"]:
                arm, pairs = condition["arm"], []
                for seed in (3, 4):
                    both = [values[arm, seed, side, name] for side in ("home", "away")]
                    if measure["unit"] == "min per 60 min":
                        played = sum(values[arm, seed, side, "playing_seconds"] for side in ("home", "away"))
                        pairs.append(60 * sum(both) / played)
                    else:
                        pairs.append(sum(both) / 2)
                of_arm[arm] = pairs
                self.assertAlmostEqual(condition["mean"], statistics.mean(pairs), places=9, msg=name)
                self.assertEqual(condition["pairs"], 2)
                if pairs[0] == pairs[1]:
                    self.assertIsNone(condition["interval"])
                else:  # Student's t of one degree of freedom: tan(0.475 pi)
                    half = math.tan(0.475 * math.pi) * statistics.stdev(pairs) / math.sqrt(2)
                    self.assertAlmostEqual(condition["interval"][1] - condition["mean"], half, places=6, msg=name)
            difference, = measure["differences"]
            by_pair = [a - b for a, b in zip(of_arm["at the ball"], of_arm["beside it"])]
            self.assertAlmostEqual(difference["mean"], statistics.mean(by_pair), places=9, msg=name)
        self.assertGreater(told, 20)
        summary = {(row["measure"], row["arm"]): row for row in self.long_table("short.csv")}
        for measure in report["measures"]:
            for condition in measure["conditions"]:
                row = summary[measure["measure"], condition["arm"]]
                if condition["pairs"] == 0:
                    self.assertEqual((row["mean"], condition["mean"]), ("", None))
                else:
                    self.assertAlmostEqual(float(row["mean"]), condition["mean"], places=12)
        table = self.table_of("--metrics")
        stored = {(row["arm"], int(row["seed"]), row["side"], row["measure"]): float(row["value"]) for row in table}
        self.assertEqual(stored, values)
        self.assertEqual(len(table), len(stored))  # each number of a match once
        for name in ("playing_seconds", "in_play_seconds", "ball_rests", "ball_crowd_seconds"):  # of the match, not of a team
            self.assertEqual(sum(measure == name for *_, measure in stored), 8)

    def test_an_arm_against_itself_shows_no_difference(self):
        self.document(experiment.PRIMARY, [("other.yaml", "small.yaml")])
        done = self.run_program(*self.arguments("--json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("at the ball and beside it are equal", done.stderr)
        report = json.loads(done.stdout)
        shown = 0
        for measure in report["measures"]:
            difference, = measure["differences"]
            if difference["pairs"] > 0:  # some numbers are those of what did not happen
                self.assertEqual(difference["mean"], 0)
                shown += 1
        self.assertGreater(shown, 20)
        comparison, = report["primary"]["comparisons"]
        self.assertTrue(comparison["equal_by_construction"])
        self.assertFalse(comparison["found"])

    def test_an_arm_may_be_a_value_of_the_same_team(self):
        self.document("team: small.yaml\n" + experiment.PRIMARY, [
            ("team: small.yaml}", "set: {utility.terms.near.params.scale: 2}}"),
            ("team: other.yaml}", "set: {sender: ~, sender: {plugin: every_second}, roles.playing.striker.target.shift: "
                                  "[-0.15, 0]}}".replace("sender: ~, ", "")),
        ])
        report = self.experiment()
        self.assertEqual([arm["team"] for arm in report["arms"]], ["small.yaml", "small.yaml"])
        self.assertIn("roles.playing.striker.target.shift=[-0.15, 0]", report["arms"][1]["set"])
        # The same as a team of its own, to the byte.
        self.document(experiment.PRIMARY, name="teams.yaml")
        other = self.experiment("--results", "teams.db", file="teams.yaml")
        self.assertEqual(report["measures"], other["measures"])

    def test_a_sweep_plays_every_arm_at_every_value(self):
        self.document("sweep: {path: a_disturbance.radio.loss, values: [0, 1]}\nmeasures: [packets, agreement]\n",
                      [("matches: 4", "matches: 2")])
        report = self.experiment()
        self.assertEqual(report["planned_matches"], 8)
        self.assertEqual([(each["arm"], each["value"]) for each in self.measure(report, "packets")["conditions"]],
                         [("at the ball", "0"), ("beside it", "0"), ("at the ball", "1"), ("beside it", "1")])
        self.assertEqual({row["a_disturbance.radio.loss"] for row in self.table_of()}, {"0", "1"})
        self.succeed("report", "trial.db", "--figures", "figures")
        self.assertTrue((self.folder / "figures" / "sweep_1.svg").read_text().startswith("<?xml"))

    def test_disturbances_follow_the_arm(self):
        self.write("deaf.yaml", "disturbance: deaf\nradio: {silence: true}\n")
        self.document("disturbance: deaf.yaml\n")
        self.experiment()
        jobs = [json.loads(job) for job, in self.stored("SELECT job FROM fixtures ORDER BY id", "trial.db")]
        for job in jobs:
            own = 0 if job["teams"][1] == "worse.yaml" else 1
            self.assertEqual([job["home_disturbance"], job["away_disturbance"]][own], "deaf.yaml")
            self.assertEqual([job["home_disturbance"], job["away_disturbance"]][1 - own], "")

    def test_any_row_is_played_again(self):
        self.experiment()
        for row in (1, 4):
            done = self.run_program("match", "--from", "trial.db", "--row", row, "--json")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"the same match as row {row}", done.stderr)

    def test_plan_is_stored_before_the_first_match(self):
        self.kill_when(lambda: self.count("trial.db") >= 1, *self.arguments("--quiet"))
        plan = json.loads(self.stored("SELECT value FROM meta WHERE name = 'schedule'", "trial.db")[0][0])
        self.assertEqual((plan["study"], plan["pairs"]), ("experiment", 2))
        self.assertIn("\nseed: 3\n", plan["document"])
        for home, away in plan["conditions"]:
            self.assertTrue(home["home"] and home["common"] and away["away"])

    def test_minutes_of_the_clock_make_pairs(self):
        # Initial 1 s, Ready 3 s and Set 1 s are no time of the clock: 7 s of the 12 are. 30 s are five such matches.
        self.document(changes=[("matches: 4", "minutes: 0.5")])
        report = self.experiment()
        self.assertEqual(report["pairs"], 3)
        for condition in report["conditions"]:  # counted ten times a second, first and last moment both
            self.assertLess(condition["playing_minutes_of_a_match"], 7.15 / 60)
            self.assertGreater(condition["playing_minutes_of_a_match"], 0)
            self.assertAlmostEqual(condition["playing_minutes_of_a_match"], condition["playing_seconds"] / 60 / 6)
        self.assertIn("Mean minutes of a match in the phase Playing: at the ball 0.1, beside it 0.1.",
                      self.succeed("report", "trial.db"))
        self.document(changes=[("matches: 4", "minutes: 0.5"), ("limit: 12", "limit: 5")])
        self.assertRegex(self.refused(*self.arguments("--results", "none.db")),
                         r"e\.yaml:\d+:\d+: limit: .*before their first kick-off")

    def test_rules_that_are_varied_are_the_opponents_too(self):
        sentence = "Rules and robot apply to the opponent, too"
        self.document("sweep: {path: rules.messages.budget, values: [100, 200]}\n", [("matches: 4", "matches: 2")])
        swept = self.experiment()
        self.assertTrue(any(sentence in each and "rules.messages.budget" in each for each in swept["notes"]))
        self.assertIn(sentence, self.succeed("report", "trial.db"))
        self.succeed("report", "trial.db", "-o", "page.html")
        self.assertIn("the same at all values of", (self.folder / "page.html").read_text())
        self.document(changes=[("matches: 4", "matches: 2"),
                               ("team: other.yaml}", "team: other.yaml, set: {robot.walk.forward: 0.2}}")])
        armed = self.experiment("--results", "armed.db")
        self.assertTrue(any(sentence in each and "robot.walk.forward" in each for each in armed["notes"]))
        self.document("sweep: {path: a_disturbance.radio.loss, values: [0, 0.5]}\n", [("matches: 4", "matches: 2")])
        self.assertFalse(any(sentence in each for each in self.experiment("--results", "own.db")["notes"]))

    def test_interrupted_cleanly(self):
        self.document(changes=[("matches: 4", "matches: 400")])
        with self.start(*self.arguments("--results", "long.db"), stdout=-1, stderr=-1) as process:
            self.wait_for(lambda: self.count("long.db") >= 2)
            process.send_signal(2)
            out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (130, ""))
        self.assertIn("to go on:", err)
        self.assertIn("--resume", err.splitlines()[-1])
        self.assertGreaterEqual(self.count("long.db"), 2)


class Page(experiment.Experiment):
    pages = True

    def test_page_and_figures_stand_beside_the_results(self):
        report = self.experiment("--results", "night.db")
        page = (self.folder / "night.html").read_text()
        self.assertIn("Does it matter where the striker stands?", page)
        self.assertIn("<svg", page)
        self.assertNotIn("http://", page.replace("http://www.w3.org", ""))
        figures = self.folder / "night.figures"
        self.assertIn("<svg", (figures / "measures_1.svg").read_text())
        # Robots of these teams agree on everything: no role is ever held twice or by nobody.
        self.assertFalse((figures / "roles.svg").exists())
        # What is drawn is what is told, and all that has a number.
        drawn = set()
        for file in figures.glob("measures_*.csv"):
            for row in self.long_table(f"night.figures/{file.name}"):
                for column in row:
                    if not column.endswith(" mean"):
                        continue
                    measure = column.removesuffix(" mean")
                    mean = next(each for each in self.measure(report, measure)["conditions"] if each["arm"] == row["arm"])
                    self.assertAlmostEqual(float(row[column]), mean["mean"], places=9)
                    drawn.add(measure)
        self.assertIn("packets", drawn)
        for each in report["measures"]:
            if "." not in each["measure"]:
                self.assertEqual(each["measure"] in drawn, any(mean["mean"] for mean in each["conditions"]), each)

    def test_figures_of_an_earlier_experiment_do_not_stay(self):
        sweep = "sweep: {path: a_disturbance.radio.loss, values: [0, 0.5]}\nmeasures: [packets]\n"
        self.document(sweep, [("matches: 4", "matches: 2")])
        self.experiment("--results", "night.db")
        figures = self.folder / "night.figures"
        self.assertTrue((figures / "sweep_1.csv").exists())
        # Versions before this one wrote scripts and pixels, too.
        for written in ("sweep_1.gnuplot", "sweep_1.png", "sweep_1.txt", "sweep_x.csv", "mine.svg"):
            (figures / written).write_text("of the user, or of another version")
        (self.folder / "night.db").unlink()
        self.document(changes=[("matches: 4", "matches: 2")])
        self.experiment("--results", "night.db")
        there = {each.name for each in figures.iterdir()}
        self.assertLessEqual({"sweep_1.txt", "sweep_x.csv", "mine.svg", "measures_1.csv", "measures_1.svg"}, there)
        self.assertFalse({"sweep_1.csv", "sweep_1.gnuplot", "sweep_1.svg", "sweep_1.png"} & there)

    def test_every_measure_of_ones_own_is_drawn(self):
        """The primary one by itself, all others beside each other."""
        measures = ["packets", "agreement", "packet_bytes"]
        self.document(f"measures: [{', '.join(measures)}, silent_seconds]\nprimary: {{measure: packets}}\n")
        report = self.experiment("--results", "own.db")
        folder = self.folder / "own.figures"
        self.succeed("report", "own.db", "--figures", "again")
        self.assertEqual({each.name for each in folder.iterdir()},
                         {f"{name}_1.{end}" for name in ("measure", "measures") for end in ("csv", "svg")})
        page = (self.folder / "own.html").read_text()
        self.assertEqual(page.count("<svg"), 2)
        self.assertIn("<b>Packets.</b>", page)
        self.assertIn("Not drawn, because all numbers are 0 or missing: silent_seconds.", page)
        for name, shown in (("measure_1", measures[:1]), ("measures_1", measures[1:])):
            self.assertEqual((folder / f"{name}.svg").read_text(), (self.folder / "again" / f"{name}.svg").read_text())
            rows = self.long_table(f"own.figures/{name}.csv")
            for measure in shown:
                before = "" if len(shown) == 1 else f"{measure} "
                told = self.measure(report, measure)["conditions"]
                self.assertEqual([row["arm"] for row in rows], [each["arm"] for each in told])
                for row, each in zip(rows, told):
                    self.assertAlmostEqual(float(row[f"{before}mean"]), each["mean"], places=9)
                    low, high = each["interval"] or (each["mean"], each["mean"])
                    self.assertAlmostEqual(float(row[f"{before}low"]), low, places=9)
                    self.assertAlmostEqual(float(row[f"{before}high"]), high, places=9)

    def test_headline_says_what_was_found(self):
        report = self.experiment("--results", "night.db")
        comparison, = report["primary"]["comparisons"]
        headline = report["findings"][0]
        self.assertIn(f'<h1 id="verdict">{headline}</h1>', (self.folder / "night.html").read_text())
        self.assertIn(f"\n{headline}\n", self.succeed("report", "night.db"))
        self.assertEqual("has more" in headline, comparison["found"])
        self.assertNotIn(">", headline)

    def test_page_is_a_function_of_the_results(self):
        self.experiment("--results", "one.db", "--workers", 1)
        before = (self.folder / "one.html").read_bytes()
        self.succeed("report", "one.db", "-o", "again.html")
        self.assertEqual((self.folder / "again.html").read_bytes(), before)


class BadInput(experiment.Experiment):
    def refusal(self, more="", changes=(), arguments=()):
        self.document(more, changes)
        began = time.monotonic()
        line = self.refused(*self.arguments("--quiet", *arguments))
        self.assertLess(time.monotonic() - began, 20)
        self.assertFalse((self.folder / "trial.db").exists(), "nothing is played")
        return line

    def test_paths_that_are_unknown(self):
        line = self.refusal("sweep: {path: a_disturbance.radio.los, values: [0, 1]}\n")
        self.assertRegex(line, r"e\.yaml:\d+:\d+: a_disturbance\.radio\.los: .*nearest: \"loss\"")
        line = self.refusal(changes=[("team: other.yaml}", "team: other.yaml, set: {utility.terms.near.wieght: 1}}")])
        self.assertRegex(line, r"e\.yaml:5:\d+: utility\.terms\.near\.wieght: .*nearest: \"weight\"")
        line = self.refusal("sweep: {path: b.utility.terms.near.weigth, values: [1]}\n")
        self.assertIn('nearest: "weight"', line)
        line = self.refusal(changes=[("team: other.yaml}", "team: other.yaml, set: {utility.terms.naer.weight: 1}}")])
        self.assertRegex(line, r"e\.yaml:5:\d+: utility\.terms\.naer\.weight: ")

    def test_values_that_do_not_fit(self):
        line = self.refusal("sweep: {path: rules.messages.budget, values: [100, -5]}\n")
        self.assertRegex(line, r"e\.yaml:\d+:\d+: rules\.messages\.budget: .*-5")
        line = self.refusal(changes=[("team: other.yaml}", "team: other.yaml, set: {assigner.plugin: gredy}}")])
        self.assertRegex(line, r"^e\.yaml:5:\d+: ")

    def test_documents_that_are_no_experiments(self):
        for more, changes, expected in (
            ("", [("arms:", "armes:")], r'e\.yaml:3:1: unknown key "armes"; nearest: "arms"'),
            ("", [("beside it", "at the ball")], r"e\.yaml:5:12: .*second element named"),
            ("", [("matches: 4", "matches: 3")], r"e\.yaml:\d+:\d+: matches: 3 is odd"),
            ("minutes: 5\n", [], r"e\.yaml:\d+:\d+: expected exactly one of minutes, matches"),
            ("", [("matches: 4\n", "")], r"e\.yaml:1:1: expected one of minutes, matches"),
            ("", [("team: other.yaml", "team: none.yaml")], r"e\.yaml:5:\d+: .*none\.yaml: no such file"),
            ("", [(", team: small.yaml", "")], r"e\.yaml:4:\d+: arm \"at the ball\": which team"),
            ("measures: [striker.overlap_second]\n", [], r"e\.yaml:\d+:\d+: unknown measure .*nearest: \"striker.overlap_seconds\""),
            ("primary: {measure: goal}\n", [], r"e\.yaml:\d+:\d+: unknown measure .*nearest: \"goals\""),
            ("primary: {measure: goals, compare: [[at the ball, beside]]}\n", [],
             r"e\.yaml:\d+:\d+: .*unknown arm \"beside\""),
            ("primary: {measure: goals, compare: [[beside it, beside it]]}\n", [], r"compared with itself"),
            ("sweep: {path: rules.messages.budget, values: [1, 1]}\n", [], r"the same value a second time"),
            ("sweep: {path: a_disturbance.radio.loss, values: [0.1, 1e-1]}\n", [], r"the same value a second time"),
            ("sweep: {path: a_disturbance.radio.loss, values: [0, 0.10, 0.1]}\n", [], r"the same value a second time"),
            ("sweep: {path: roles.playing.striker.target.shift, values: [[1, 0], [1.0, 0]]}\n", [],
             r"the same value a second time"),
            ("primary: {measure: goals, compare: [[at the ball, beside it], [beside it, at the ball]]}\n", [],
             r"e\.yaml:\d+:\d+: primary\.compare: the same two arms a second time"),
            ("sweep: {path: a_disturbance.radio.loss, values: [0, 0.5]}\n",
             [("team: other.yaml}", "team: other.yaml, set: {a_disturbance.radio: {loss: 0.1}}}")],
             r"e\.yaml:5:\d+: a_disturbance\.radio: the sweep sets a_disturbance\.radio\.loss in every arm"),
            ("sweep: {path: opponent, values: [worse.yaml, small.yaml]}\n", [],
             r"e\.yaml:\d+:\d+: sweep: opponent: expected a path inside it, as in `b\.sender\.plugin`"),
            ("sweep: {path: opponent.sender.plugin, values: [a, b]}\n", [],
             r"sweep: opponent\.sender\.plugin: the study's own team is called a and the other b, as in all commands: b\.sender"),
            ("set: {rules: hsl2026}\n", [("set: {rules.durations.ready: 3, rules.durations.set: 1}\n", "")],
             r"set: rules: expected a path inside it"),
            ("sweep: {path: rules.messages.budget, values: []}\n", [], r"e\.yaml:\d+:\d+: .*the list is empty"),
            ("sweep: {path: home.sender, values: [1]}\n", [], r"each arm plays at home and away"),
            ("confidence: 1\n", [], r"confidence: \"1\" is outside"),
            ("openings: scenes/nothing\n", [], r"e\.yaml:\d+:\d+: openings: .*no such file"),
        ):
            with self.subTest(expected):
                self.assertRegex(self.refusal(more, changes), expected)

    def test_no_arms(self):
        text = experiment.EXPERIMENT.format(more="")
        begin, end = text.index("  - {"), text.index("opponent:")
        self.write("e.yaml", text[:begin].replace("arms:\n", "arms: []\n") + text[end:])
        self.assertRegex(self.refused(*self.arguments()), r"e\.yaml:3:7: arms: 0 elements")

    def test_command_lines(self):
        self.assertIn("which one?", self.refused("experiment"))
        self.assertIn("no such file", self.refused("experiment", "nothing.yaml"))
        self.assertIn("this is a team document", self.refused("experiment", "small.yaml"))
        self.assertIn("--workers", self.refused(*self.arguments("--workers", 0)))
        self.assertIn("expected exactly one of minutes, matches", self.refused(*self.arguments("--game-minutes", 5, "--matches", 4)))
        self.assertIn("`regista tournament`", self.refused(*self.arguments("--pairs", 5)))
        self.assertIn("is odd", self.refused(*self.arguments("--matches", 3)))

    def test_the_second_example_of_the_help(self):
        example = next(line for line in self.succeed("experiment", "--help").splitlines() if "yaml --set " in line)
        override = shlex.split(example)[-1]
        self.assertEqual(override, "arms.events.set={sender.params.reserve: 60}")

    def test_nothing_to_resume(self):
        line = self.refused(*self.arguments("--quiet", "--resume"))
        self.assertEqual(line, "--resume: trial.db: no such file; without --resume it is begun")

    def test_resumed_with_something_else(self):
        self.experiment()
        self.assertIn("exists", self.refused(*self.arguments("--quiet")))
        self.document(experiment.PRIMARY, [("seed: 3", "seed: 4"), ("matches: 4", "matches: 6")])
        line = self.refused(*self.arguments("--quiet", "--resume"))
        self.assertIn("matches: was 4, now 6", line)
        self.assertIn("seed: was 3, now 4", line)
        self.document(experiment.PRIMARY)
        self.write("other.yaml", (self.folder / "other.yaml").read_text().replace("weight: 1", "weight: 0.5"))
        line = self.refused(*self.arguments("--quiet", "--resume"))
        self.assertIn("beside it: team", line)
        self.assertIn("has changed", line)
        line = self.refused(*super().arguments("--quiet", "--resume", "--results", "trial.db"))
        self.assertNotEqual(line, "")

    def test_a_tournament_is_not_continued_as_an_experiment(self):
        self.succeed("tournament", "--team", "small.yaml", "--team", "other.yaml", "--pairs", 1, "--limit", 5, "--quiet",
                     "--no-page")
        line = self.refused(*self.arguments("--quiet", "--resume", "--results", "tournament.db"))
        self.assertIn("it was a tournament, now an experiment", line)


class Documents(experiment.Experiment):
    def test_config_knows_experiments(self):
        self.assertEqual(self.succeed("config", "check", "e.yaml"), "e.yaml: experiment, sound\n")
        shown = self.succeed("config", "show", "e.yaml")
        self.assertIn("experiment: trial", shown)
        self.write("shown.yaml", shown)
        self.assertEqual(self.succeed("config", "check", "shown.yaml"), "shown.yaml: experiment, sound\n")
        schema = json.loads(self.succeed("config", "schema", "experiment"))
        self.assertIn("arms", schema["$defs"]["document"]["properties"])
        self.document("sweep: {path: rules.messages.budgett, values: [1]}\n")
        self.assertIn('rules.messages.budgett: unknown key "budgett"', self.refused("config", "check", "e.yaml"))


if __name__ == "__main__":
    unittest.main()
