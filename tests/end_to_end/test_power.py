# SPDX-License-Identifier: MIT
"""`regista power`: how many pairs a study needs, from stored pairs or from a pilot."""

import json
import math
import statistics

import experiment
import tournament


class PowerOfTournaments(tournament.Tournament):
    def test_spread_is_that_of_the_stored_pairs(self):
        self.play(pairs=24)
        rows = self.table()
        goals = []
        for first, second in zip(rows[::2], rows[1::2]):
            at_home = int(first["home_goals"]) - int(first["away_goals"])
            away = int(second["away_goals"]) - int(second["home_goals"])
            goals.append((at_home + away) / 2)
        report = json.loads(self.succeed("power", "tournament.db", "--json"))
        self.assertEqual((report["test"], report["alpha"], report["family"], report["smallest_pairs"]), ("sign_flip", 0.05, 1, 6))
        self.assertEqual((report["measure"], report["difference"], report["power"], report["pairs"]), ("goals", 0.5, 0.8, 24))
        [pairing] = report["comparisons"]
        self.assertEqual(pairing["pairs"], 24)
        self.assertAlmostEqual(pairing["mean"], statistics.mean(goals), 9)
        self.assertAlmostEqual(pairing["standard_deviation"], statistics.stdev(goals), 9)
        # Most pairs are even, and the others differ by half a goal. A mean of 0.2 needs two uneven pairs of five at least, all for
        # one side, and six of them: by the binomial law.
        self.assertEqual((pairing["even_pairs"], set(map(abs, goals))), (goals.count(0), {0.0, 0.5}))
        self.assertLess(statistics.stdev(goals) ** 2 + 0.2 ** 2, 0.5 * 0.2)
        needed = next(n for n in range(6, 99) if sum(math.comb(n, k) * 0.4 ** k * 0.6 ** (n - k) for k in range(6, n + 1)) >= 0.8)
        fine = json.loads(self.succeed("power", "tournament.db", "--json", "--difference", 0.2, "--pairs", 100))
        self.assertEqual(fine["comparisons"][0]["pairs_needed"], needed)
        least, most = fine["comparisons"][0]["pairs_needed_interval"]
        self.assertTrue(least <= needed < most)
        # Of many pairs the normal law is a little too hopeful.
        self.assertAlmostEqual(fine["comparisons"][0]["difference_found"], 0.2801585 * statistics.stdev(goals), delta=0.01)
        text = self.succeed("power", "tournament.db")
        self.assertIn("small - other", text)
        self.assertIn("Sign-flip test at 5 %, two-sided. It finds nothing with fewer than 6 uneven pairs.", text)

    def test_any_metric_and_any_family(self):
        self.play("--team", "worse.yaml", pairs=4)
        report = json.loads(self.succeed("power", "tournament.db", "--json", "--metric", "target_distance_mean_metres"))
        self.assertEqual((report["family"], report["smallest_pairs"], report["difference"]), (3, 7, None))
        self.assertEqual([(each["first"], each["second"]) for each in report["comparisons"]],
                         [("small", "other"), ("small", "worse"), ("other", "worse")])
        table = self.table("--metrics")
        values = [(float(a["home.target_distance_mean_metres"]) - float(a["away.target_distance_mean_metres"])
                   + float(b["away.target_distance_mean_metres"]) - float(b["home.target_distance_mean_metres"])) / 2
                  for a, b in zip(table[::2], table[1::2]) if (a["home"], a["away"]) == ("small", "worse")]
        self.assertAlmostEqual(report["comparisons"][1]["standard_deviation"], statistics.stdev(values), 9)

    def test_a_pilot_is_played_on_seeds_of_its_own(self):
        words = ["power", *self.arguments("--quiet", "--json")[1:]]
        words = [each for each in words if each != "--no-page"]
        report = json.loads(self.succeed(*words))
        self.assertEqual((report["comparisons"][0]["pairs"], report["pairs"]), (10, 3))
        seeds = {row[2] for row in self.rows("tournament.pilot.db")}
        self.assertEqual(len(seeds), 10)
        self.assertFalse(seeds & set(range(1, 100)))
        rows = self.rows("tournament.pilot.db")
        self.assertEqual(json.loads(self.succeed(*words)), report)  # read, not played
        self.assertEqual(self.rows("tournament.pilot.db"), rows)
        self.assertFalse((self.folder / "tournament.db").exists())
        self.assertIn("was begun with something else", self.refused(*words, "--limit", 5))
        more = json.loads(self.succeed(*words, "--pilot", 12, "--results", "larger.pilot.db"))
        self.assertEqual(more["comparisons"][0]["pairs"], 12)
        self.assertIn("tests goals", self.succeed("power", "tournament.pilot.db", "--difference", "20elo"))

    def test_bad_input(self):
        self.play(pairs=2)
        refused = self.refused("power", "tournament.db", "--metric", "silent_second")
        self.assertIn('unknown metric "silent_second" in --metric; nearest: "silent_seconds"', refused)
        self.assertIn("--difference", self.refused("power", "tournament.db", "--difference", 0))
        self.assertIn("--power", self.refused("power", "tournament.db", "--power", 1))
        self.assertIn("--team is of a study that a pilot is played for", self.refused("power", "tournament.db", "--team", "a"))
        self.assertIn("of which study?", self.refused("power"))
        self.assertIn("no such file", self.refused("power", "nothing.db"))
        self.assertIn("this is a team document", self.refused("power", "small.yaml"))
        self.play("--results", "one.db", pairs=1)
        self.assertIn('one.db holds 1 pair with a value of "goals"; a standard deviation needs two or more',
                      self.refused("power", "one.db"))
        self.play("--results", "equal.db", teams=("small.yaml", "small.yaml"))
        self.assertEqual(self.refused("power", "equal.db"),
                         'power: "goals" has no spread in equal.db: all pairs are even; play longer matches; or play more pairs: '
                         'regista resume equal.db --pairs N')

    def test_elo_is_a_difference_of_points(self):
        self.play(pairs=8)
        text = self.succeed("power", "tournament.db", "--difference", "20elo")
        self.assertIn("20 Elo are a score of 52.88 %, 0.0575 points a match more than the other team has.", text)
        self.assertIn("points, difference of pairs of matches, points a match", text)


class PowerOfExperiments(experiment.Experiment):
    def test_it_is_of_the_primary_measure_by_its_own_test(self):
        self.document("primary: {measure: goal_difference, test: sign_flip}\nopenings: [scenes]\n",
                      [("matches: 4", "matches: 16")])
        whole = self.experiment()
        comparison = self.measure(whole, "goal_difference")["differences"][0]
        report = json.loads(self.succeed("power", "trial.db", "--json"))
        self.assertEqual((report["measure"], report["test"], report["difference"]), ("goal_difference", "sign_flip", 0.5))
        self.assertEqual(report["comparisons"][0]["pairs"], 8)
        self.assertAlmostEqual(report["comparisons"][0]["mean"], comparison["mean"], 12)

    def test_a_pilot_of_a_document(self):
        self.document("primary: {measure: goal_difference}\nopenings: [scenes]\n")
        report = json.loads(self.succeed("power", "e.yaml", "--quiet", "--json", "--difference", 1))
        self.assertEqual((report["test"], report["smallest_pairs"], report["pairs"]), ("sign_flip", 6, 2))
        self.assertEqual(report["comparisons"][0]["pairs"], 10)

    def test_bad_input(self):
        self.document()
        self.experiment()
        self.assertIn("names no primary measure; --metric names a number", self.refused("power", "trial.db"))
