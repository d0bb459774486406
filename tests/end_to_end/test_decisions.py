# SPDX-License-Identifier: MIT
"""`regista match --decisions`: a match as its robots saw it. The lines must fit together, and with the result."""

import collections
import json
import unittest

import program
import recorded

SECONDS = 120


class Decisions(program.Case):
    def setUp(self):
        super().setUp()
        command = ("match", "small.yaml", "small.yaml", "--limit", SECONDS, "--json", *program.PLAY_SOON)
        self.without = json.loads(self.succeed(*command))
        self.result = json.loads(self.succeed(*command, "--decisions", "decisions.jsonl"))
        with open(self.folder / "decisions.jsonl", encoding="utf-8") as file:
            self.lines = [json.loads(line) for line in file]
        self.by_kind = collections.defaultdict(list)
        for line in self.lines:
            self.by_kind[line["kind"]].append(line)

    def test_all(self):
        with self.subTest("watching changes nothing"):
            self.assertEqual(self.result["state_hash"], self.without["state_hash"])
        with self.subTest("head"):
            self.assertEqual(self.lines[0], {"kind": "match", "time": 0.0, "teams": ["small", "small"], "seed": 1})
        with self.subTest("in order of time"):
            times = [line["time"] for line in self.lines]
            self.assertEqual(times, sorted(times))
        self.check_truth()
        self.check_decisions()
        self.check_packets()
        with self.subTest("events"):
            events = [line["event"] for line in self.by_kind["event"]]
            self.assertIn("kick_off", events)
            self.assertEqual(events.count("goal"), sum(self.result["score"]))

    def check_truth(self):
        truth = self.by_kind["truth"]
        with self.subTest("truth once a second"):
            self.assertEqual([line["time"] for line in truth], [float(i + 1) for i in range(SECONDS)])
        for line in truth:
            self.assertEqual((len(line["home"]), len(line["away"])), (7, 7))
            self.assertLessEqual(abs(line["ball"][0]), 4.5 + 0.7 + 0.5)
        self.assertEqual(truth[-1]["score"], self.result["score"])

    def check_decisions(self):
        known = {}
        for line in self.by_kind["decision"]:
            key = (line["side"], line["robot"])
            state = [line[name] for name in ("context", "role", "kept", "assignment")]
            with self.subTest("a line only for what changed or was sent", time=line["time"], robot=key):
                self.assertTrue(line["packet"] is not None or state != known.get(key))
            known[key] = state
            if line["role"] is not None:
                self.assertEqual(line["assignment"][line["robot"] - 1], line["role"])
                self.assertIn(line["role"], line["kept"])
                before, after = line["target"]["before"], line["target"]["after"]
                self.assertLessEqual(((before[0] - after[0])**2 + (before[1] - after[1])**2)**0.5, 0.3 + 0.002)
                self.assertEqual(set(line["utility"]), set(line["kept"]))
                self.assertIsNotNone(line["utility"][line["role"]])
                self.assertEqual(line["context"], "playing")
        self.assertEqual(len(known), 14)

    def check_packets(self):
        sent = collections.Counter(line["side"] for line in self.by_kind["decision"] if line["packet"] is not None)
        with self.subTest("a line for each packet"):
            self.assertEqual([sent["home"], sent["away"]], self.result["packets"])

    def test_a_robot_that_is_given_up_plays_on(self):
        # Robots that speak once a second are given up half a second later, each by itself too; who decides on what all
        # know then decides on what it knows itself, and the recorders tell of that.
        self.succeed("match", "small.yaml", "small.yaml", "--limit", "20", *program.PLAY_SOON, "--force", "--decisions",
                     "decisions.jsonl", "--record", "given_up.mcap", "--set", "teammates_forgotten_after=0.5", "--set",
                     "tasks.knowledge=common", "--set", "utility.knowledge=common")
        with open(self.folder / "decisions.jsonl", encoding="utf-8") as file:
            lines = [json.loads(line) for line in file]
        penalised = {(line["side"], line["robot"]) for line in lines if line.get("event") == "penalty"}
        self.assertLess(len(penalised), 7)
        decisions = [line for line in lines if line["kind"] == "decision" and line["context"] and
                     (line["side"], line["robot"]) not in penalised]
        self.assertGreater(len(decisions), 100)
        for line in decisions:
            self.assertIsNotNone(line["role"], line)
            self.assertEqual(set(line["utility"]), set(line["kept"]))
        worlds = collections.Counter()
        recording = recorded.read(self.folder / "given_up.mcap")
        for side in ("home", "away"):
            for number in range(1, 8):
                for decision in recording.of(f"/decision/{side}/{number}"):
                    if decision["context"] < 0 or (side, number) in penalised:
                        continue
                    worlds[decision["knowledge"]] += 1
                    self.assertIn(number, decision["rows"])
                    self.assertEqual(len(decision["utility"]), len(decision["rows"]))
        self.assertGreater(min(worlds["mine"], worlds["common"]), 100)

    def test_the_striker_stands_where_it_believes(self):
        # Beliefs are in the field frame of the own team, the truth in that of home: half a turn apart for away.
        placed = [line for line in self.by_kind["decision"] if line["time"] < 2.0]
        truth = self.by_kind["truth"][0]
        checked = 0
        for line in placed:
            x, y, _ = truth[line["side"]][line["robot"] - 1]
            sign = 1 if line["side"] == "home" else -1
            error = ((sign * x - line["pose"][0])**2 + (sign * y - line["pose"][1])**2)**0.5
            if line["time"] > 1.0:
                self.assertLess(error, 0.8, line)
                checked += 1
        self.assertGreater(checked, 0)


if __name__ == "__main__":
    unittest.main()
