# SPDX-License-Identifier: MIT
"""Sequential tests of tournaments: where they stop, what they say, and that this is the same for any number of
workers. And tournaments of more than two teams."""

import csv
import io
import json
import math
import unittest

import program
import tournament

WORSE = ("small.yaml", "worse.yaml")
THREE = ("small.yaml", "worse.yaml", "other.yaml")


class Verdicts(tournament.Tournament):
    def same_for_any_number_of_workers(self, *more, **options):
        """The report in words and as JSON, played by one, two and four workers."""
        said = set()
        for workers in ("1", "2", "4"):
            file = f"{workers}.db"
            words = self.play(*more, "--workers", workers, "--results", file, **options)
            report = self.play(*more, "--json", "--resume", "--results", file, **options)
            said.add((words, report))
            counted = json.loads(report)["matches"]
            # Others may have been under way when it was over; those that count are all there and the same.
            self.assertEqual(self.rows(file)[:counted], self.rows("1.db")[:counted])
        self.assertEqual(len(said), 1)
        words, report = said.pop()
        return words, json.loads(report)

    def test_a_test_on_scores(self):
        words, report = self.same_for_any_number_of_workers("--sprt", "0,200", teams=WORSE, pairs=200)
        pairing = report["pairings"][0]
        self.assertEqual(report["verdict"], "H1")
        pairs = sum(pairing["pentanomial"])
        self.assertLess(pairs, 60)
        self.assertEqual(report["matches"], 2 * pairs)
        self.assertTrue(words.startswith(f"Tournament: small vs worse ({pairs} pairs of 200, seeds from 1, 2 scenes of about 10 s)\n"))
        self.assertIn(f"\nsmall is stronger than worse.", words)
        self.assertIn(f"\nAfter {pairs} pairs of scenes small has ", words)
        self.assertIn("\nThe test accepted H1: the scores speak for a strength of 200 rather than 0 nElo; error rates ", words)
        test = pairing["sprt"]
        self.assertGreaterEqual(test["llr"], test["llr_stopping"][1])
        # Another command comes to the same numbers from the same counts.
        alone = json.loads(self.succeed("sprt", "--elo", "0,200", "--json", *map(str, pairing["pentanomial"])))
        for key, value in {"llr": test["llr"], "elo": pairing["elo"], "nelo": pairing["nelo"]}.items():
            self.assertAlmostEqual(alone[key], value, places=9)

    def rounds_are_as_drawn(self, form):
        words, report = self.same_for_any_number_of_workers("--format", form, teams=THREE, pairs=1)
        self.assertEqual((report["format"], len(report["rounds"]), report["complete"]), (form, 2, True))
        self.assertTrue(words.startswith("Tournament: 3 teams, "), words)
        # Each line of the table is the match of its row, and of the meeting that was drawn for its round.
        table = list(csv.DictReader(io.StringIO(self.succeed("report", "1.db", "--csv"))))
        stored = self.stored("SELECT row, seed, job FROM matches JOIN fixtures ON fixture = id ORDER BY row", "1.db")
        self.assertEqual([(line["row"], line["seed"], [f"{line[side]}.yaml" for side in ("home", "away")]) for line in table],
                         [(str(row), str(seed), json.loads(job)["teams"]) for row, seed, job in stored])
        self.assertEqual([line["pair"] for line in table], ["1", "1", "2", "2"])
        self.assertEqual([{line["home"], line["away"]} for line in table[::2]],
                         [set(meeting) for meetings in report["rounds"] for meeting in meetings])

    def test_a_knock_out(self):
        self.rounds_are_as_drawn("knock_out")

    def test_a_swiss_tournament(self):
        self.rounds_are_as_drawn("swiss")

    def test_the_other_verdict_and_none(self):
        teams = ("worse.yaml", "small.yaml")
        report = self.only("--sprt", "0,200", "--model", "logistic", "--alpha", "0.1", "--beta", "0.2", teams=teams,
                           pairs=200)
        self.assertEqual((report["verdict"], report["sprt"]["model"]), ("H0", "logistic"))
        self.assertAlmostEqual(report["sprt"]["llr_bounds"][0], math.log(0.2 / 0.9))
        self.assertAlmostEqual(report["sprt"]["llr_bounds"][1], math.log(0.8 / 0.1))
        text = self.play("--sprt", "0,20", "--results", "short.db", teams=teams, pairs=2)
        self.assertIn("\nThe test ended without a verdict on worse and small.", text)

    def test_a_test_on_goals(self):
        words, report = self.same_for_any_number_of_workers("--metric", "goals", teams=WORSE, pairs=200)
        self.assertEqual(report["verdict"], "H1")
        pairs = sum(report["pairings"][0]["pentanomial"])
        self.assertLess(pairs, 60)
        self.assertIn(f"\nsmall scores more goals than worse.\nAfter {pairs} pairs of scenes ", words)
        self.assertGreater(report["pairings"][0]["goals_per_match"]["confidence_sequence"][0], -0.01)

    def test_a_test_on_a_metric_of_a_role(self):
        # A team whose robots get the roles in another order.
        lines = program.TEAM.format(name="shuffled").splitlines(keepends=True)
        striker = next(i for i, line in enumerate(lines) if "name: striker" in line)
        lines[striker:striker + 2] = reversed(lines[striker:striker + 2])
        self.write("shuffled.yaml", "".join(lines))
        teams = ("small.yaml", "shuffled.yaml")
        metric = "striker.overlap_seconds"
        words, report = self.same_for_any_number_of_workers("--metric", metric, "--alpha", "0.2", teams=teams,
                                                            pairs=20)
        told = report["pairings"][0]["metric"]
        self.assertEqual((told["name"], told["alpha"]), (metric, 0.2))
        # The rows say the same.
        mine, theirs, signs = [], [], [0, 0, 0]
        stored = list(self.metrics("1.db").values())[:report["matches"]]
        of = lambda match, side: match["roles"][side]["striker"]["overlap_seconds"]
        for first, second in zip(stored[::2], stored[1::2]):
            mine.append((of(first, 0) + of(second, 1)) / 2)
            theirs.append((of(first, 1) + of(second, 0)) / 2)
            signs[1 + (mine[-1] > theirs[-1]) - (mine[-1] < theirs[-1])] += 1
        self.assertGreater(signs[0] + signs[2], 0)  # else this test would show little
        self.assertEqual(told["pairs_less_equal_more"], signs)
        self.assertAlmostEqual(told["means"][0], sum(mine) / len(mine))
        self.assertAlmostEqual(told["means"][1], sum(theirs) / len(theirs))
        self.assertIn(f"{metric}: ", words)
        # The same path in full.
        full = self.only("--metric", f"roles.{metric}", "--alpha", "0.2", "--results", "full.db", teams=teams, pairs=20)
        self.assertEqual({**full["metric"], "name": metric}, told)

    def test_tests_that_contradict_each_other(self):
        ask = lambda *more, **options: self.refused(*self.arguments(*more, **options))
        teams = ("--team", "small.yaml", "--team", "other.yaml")
        self.assertIn("--metric goals: test: expected exactly one of elo, metric", ask("--sprt", "0,10", "--metric", "goals"))
        self.assertIn("--beta 0.1: test: expected one of elo, metric", ask("--beta", "0.1"))
        self.assertIn("--beta 0.1: test.beta: makes sense only with elo", ask("--beta", "0.1", "--metric", "goals"))
        self.assertIn("--model logistic: test: expected one of elo, metric", ask("--model", "logistic"))
        self.assertIn("--model logistic: test.model: belongs to elo", ask("--model", "logistic", "--metric", "goals"))
        self.assertIn("--alpha 0.1: test: expected one of elo, metric", ask("--alpha", "0.1"))
        self.assertIn("--sprt 10,0: test.elo: ", ask("--sprt", "10,0"))
        self.assertIn("--beta 0.5: test: alpha and beta: their sum must be below 1",
                      ask("--sprt", "0,10", "--alpha", "0.5", "--beta", "0.5"))
        self.assertIn("tournament: pairs: how many at most?", self.refused("tournament", *teams, "--metric", "goals"))
        self.assertIn("a sequential test is between two teams", ask("--sprt", "0,10", teams=THREE))
        self.assertIn("a sequential test is between two teams", ask("--metric", "goals", teams=THREE))
        self.assertIn('nearest: "striker.overlap_seconds"', ask("--metric", "striker.overlap_secnods"))
        self.assertIn('nearest: "goals"', ask("--metric", "gaols"))
        self.assertIn("--metric packets_share: test.metric packets_share: whole matches have none",
                      self.refused("tournament", *teams, "--metric", "packets_share", "--pairs", "2"))
        self.assertIn('test.model: unknown value "logistics"; nearest: "logistic"', ask("--sprt", "0,10", "--model", "logistics"))
        self.assertEqual([file.name for file in self.folder.glob("*.db*")], [])


class Formats(tournament.Tournament):
    def labels(self):
        return [(row["pair"], row["home"], row["away"]) for row in self.table()]

    def test_round_robin(self):
        report = self.report(teams=THREE, pairs=6)
        expected = []
        for pair in range(1, 7):
            for first, second in (("small", "worse"), ("small", "other"), ("worse", "other")):
                expected += [(str(pair), first, second), (str(pair), second, first)]
        self.assertEqual(self.labels(), expected)
        self.assertEqual((report["matches"], report["format"], report["verdict"]), (36, "round_robin", None))
        self.assertEqual([pairing["teams"] for pairing in report["pairings"]],
                         [["small", "worse"], ["small", "other"], ["worse", "other"]])
        # All matches of a pair have the same luck.
        self.assertEqual(self.stored("SELECT seed, count(*) FROM matches GROUP BY seed"),
                         [(seed, 6) for seed in range(1, 7)])
        # Points and goals of the ranking are those of the rows.
        points = dict.fromkeys(("small", "worse", "other"), 0.0)
        goals = {team: [0, 0] for team in points}
        for row in self.table():
            home, away = int(row["home_goals"]), int(row["away_goals"])
            points[row["home"]] += 1.0 if home > away else 0.5 if home == away else 0.0
            points[row["away"]] += 1.0 if away > home else 0.5 if home == away else 0.0
            for team, scored, conceded in ((row["home"], home, away), (row["away"], away, home)):
                goals[team] = [goals[team][0] + scored, goals[team][1] + conceded]
        self.assertEqual({rank["team"]: rank["points"] for rank in report["ranking"]}, points)
        self.assertEqual({rank["team"]: rank["goals"] for rank in report["ranking"]}, goals)
        self.assertEqual(report["ranking"][-1]["team"], "worse")
        self.assertAlmostEqual(sum(rank["nash"] for rank in report["ranking"]), 1.0)
        elos = [rank["elo"] for rank in report["ranking"]]
        self.assertEqual(elos, sorted(elos, reverse=True))
        # Another command comes to the same ranking from the table.
        for metrics in ([], ["--metrics"]):
            self.write("matches.csv", self.succeed("report", "tournament.db", "--csv", *metrics))
            ranked = json.loads(self.succeed("rank", "matches.csv", "--json"))
            self.assertEqual(ranked["remarks"], [])
            self.assertEqual([[row[key] for key in ("team", "elo", "elo_interval", "points")] for row in ranked["ranking"]],
                             [[row[key] for key in ("team", "elo", "elo_interval", "points")] for row in report["ranking"]])
        text = self.play("--resume", teams=THREE, pairs=6)
        self.assertTrue(text.startswith("Tournament: 3 teams, round robin (6 pairs each, seeds from 1, 2 scenes of about 10 s)\n"))
        self.assertEqual(self.play("--results", "four.db", "--workers", "4", teams=THREE, pairs=6), text)
        self.assertEqual(self.rows("four.db"), self.rows())

    def test_gauntlet(self):
        report = self.report("--format", "gauntlet", teams=THREE, pairs=2)
        expected = []
        for pair in ("1", "2"):
            for other in ("worse", "other"):
                expected += [(pair, "small", other), (pair, other, "small")]
        self.assertEqual(self.labels(), expected)
        self.assertEqual((report["format"], len(report["pairings"])), ("gauntlet", 2))
        self.assertEqual([rank["nash"] for rank in report["ranking"]], [None] * 3)
        changed = self.refused(*self.arguments("--resume", teams=THREE, pairs=2))
        self.assertIn("format: was gauntlet, now round_robin", changed)

    def test_values_for_the_third_team(self):
        changed = ("--set", "c.utility.terms.near.params.scale=3")
        self.play(*changed, teams=THREE, pairs=1)
        for job, in self.stored("SELECT job FROM fixtures"):
            job = json.loads(job)
            sides = [side for side, team in zip(("home", "away"), job["teams"]) if team == "other.yaml"]
            self.assertEqual(job["overrides"], [f"{side}.utility.terms.near.params.scale=3" for side in sides])

    def test_openings_are_part_of_what_is_played(self):
        self.play()
        self.assertEqual([row["opening"] for row in self.table()], ["left"] * 2 + ["right"] * 2 + ["left"] * 2)
        scene = self.folder / "scenes" / "right.yaml"
        text = scene.read_text()
        scene.write_text(text.replace("ball: {at: [3, ", "ball: {at: [3.1, "))
        self.assertIn("opening right has changed", self.refused(*self.arguments("--resume")))
        scene.write_text(text)
        self.write("scenes/third.yaml", tournament.SCENE.format(name="third", y=0))
        self.assertIn("opening third", self.refused(*self.arguments("--resume")))
        (self.folder / "scenes" / "third.yaml").unlink()
        self.play("--resume")
        self.assertIn("there is no .yaml file", self.refused(*self.arguments("--openings", "bin")))
        self.assertIn("small.yaml", self.refused(*self.arguments("--openings", "small.yaml")))


if __name__ == "__main__":
    unittest.main()
