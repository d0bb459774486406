# SPDX-License-Identifier: MIT
"""Plugins that talk to their counterparts: what each segment came to stands in the recording, in the log of decisions
and in the numbers of the match, and all of them say the same."""

import collections
import csv
import io
import json
import unittest

import jsonschema

import program
import recorded

SECONDS = 60
TEAMMATES = 6
BIDS = program.TEST_PLUGINS / "bids" / "bids.so"
LOSSY = "disturbance: lossy\nradio: {loss: 0.4, delay: 0.05, jitter: 0.3}\n"
MATCH = ("match", "bids.yaml", "small.yaml", "--limit", SECONDS, "--home-disturbance", "lossy.yaml", "--quiet",
         *program.PLAY_SOON)
COUNTS = ("offered", "refused", "sent", "dropped", "heard")


class Negotiations(program.Case):
    plugins = (program.SOUND, *program.BEHAVIOURS, BIDS)

    def setUp(self):
        super().setUp()
        team = program.TEAM.format(name="bids")
        self.write("bids.yaml", team.replace("plugin: first_free", "plugin: bids"))
        self.write("lossy.yaml", LOSSY)

    def play(self, *more):
        return json.loads(self.succeed(*MATCH, "--json", *more))

    def lines(self, name="a.jsonl"):
        with open(self.folder / name, encoding="utf-8") as file:
            return [json.loads(line) for line in file]

    def test_all(self):
        without = self.play()
        result = self.play("--record", "a.mcap", "--decisions", "a.jsonl")
        with self.subTest("watching changes nothing, and the report says the same"):
            self.assertEqual({**result, "wall_seconds": 0}, {**without, "wall_seconds": 0})
        self.file = recorded.read(self.folder / "a.mcap")
        self.segments = self.file.of("/segment")
        with self.subTest("schema"):
            validator = jsonschema.Draft7Validator(self.file.schemas["/segment"])
            for message in self.segments[::7]:
                validator.validate(message)
            self.assertEqual({key for message in self.segments for key in message}
                             - set(self.file.schemas["/segment"]["properties"])
                             - set(self.file.schemas["/segment"]["allOf"][0]["properties"]), set())
        with self.subTest("the log says the same"):
            logged = [{k: v for k, v in line.items() if k != "kind"} for line in self.lines()
                      if line["kind"] == "segment"]
            self.assertEqual(logged, self.segments)
        self.lives = collections.defaultdict(list)  # what became of each offer: (robot, handle)
        for message in self.segments:
            self.assertEqual(message["side"], "home")
            robot = message.get("sender", message["robot"])
            self.lives[robot, message.get("handle", 0)].append(message)
        self.check_counts(result)
        self.check_lives()
        self.check_radio()
        self.follow_one_bid()

    def check_counts(self, result):
        told = collections.Counter(message["segment"] for message in self.segments)
        for kind in COUNTS:
            with self.subTest("counted", kind=kind):
                self.assertEqual(result[f"segments_{kind}"], [told[kind], 0])
                self.assertGreater(told[kind], 10)
        ended = {(m["robot"], m["handle"]) for m in self.segments if m["segment"] in ("sent", "dropped")}
        taken = {(m["robot"], m["handle"]) for m in self.segments if m["segment"] == "offered"}
        pending = len(taken - ended)
        offered, _, sent, dropped, heard = (result[f"segments_{kind}"][0] for kind in COUNTS)
        with self.subTest("what is offered is sent, dropped, or pending"):
            self.assertEqual(offered, sent + dropped + pending)
            self.assertLessEqual(pending, 7)
            self.assertLess(heard, sent * TEAMMATES)
            # 0.6 of the packets arrive, but for those that are under way at the end.
            self.assertAlmostEqual(heard / (sent * TEAMMATES), 0.6, delta=0.08)
        with self.subTest("why"):
            why = collections.Counter(m["why"] for m in self.segments if m["segment"] in ("dropped", "refused"))
            self.assertEqual(set(why), {"expired", "replaced", "withdrawn", "too_long"})
            self.assertGreater(min(why.values()), 5)

    def check_lives(self):
        """In each life one offer, then at most one end; heard only after it was sent, at most once by each teammate."""
        for (robot, handle), life in self.lives.items():
            if handle == 0:
                self.assertEqual({message["segment"] for message in life}, {"refused"})
                self.assertTrue(all(m["length"] == 100 and len(m["bytes"]) == 200 for m in life))
                self.assertTrue(all(m["text"] == 'no bid: "100 bytes"' for m in life))
                continue
            kinds = [message["segment"] for message in life]
            self.assertEqual(kinds[0], "offered")
            self.assertEqual(collections.Counter(kinds)["offered"], 1)
            self.assertLessEqual(sum(kind in ("sent", "dropped") for kind in kinds), 1, life)
            listeners = [message["robot"] for message in life if message["segment"] == "heard"]
            self.assertEqual(len(listeners), len(set(listeners)), life)
            self.assertNotIn(robot, listeners)
            offer = life[0]
            number, task, utility = bytes.fromhex(offer["bytes"])
            self.assertEqual(offer["text"], f"bid {number}: 0.{utility:02d} for task {task}")
            self.assertEqual((offer["plugin"], offer["length"]), ("bids", 3))
            for message in life[1:]:
                self.assertEqual((message["plugin"], message["place"]), ("bids", offer["place"]))
                if message["segment"] == "dropped":
                    self.check_drop(robot, offer, message)
                if message["segment"] == "heard":
                    sent = next(m for m in life if m["segment"] == "sent")
                    self.assertEqual(message["sent"], sent["time"])
                    self.assertGreater(message["heard"], message["sent"] + 0.05)
                    self.assertLessEqual(message["heard"], message["time"])

    def check_drop(self, robot, offer, drop):
        if drop["why"] == "expired":
            self.assertGreaterEqual(drop["time"], offer["expires"])
        else:
            self.assertLess(drop["time"], offer["expires"])
        if drop["why"] == "replaced":
            successor = self.lives[robot, drop["by"]][0]
            self.assertEqual((successor["segment"], successor["time"]), ("offered", drop["time"]))

    def check_radio(self):
        """A segment is heard by exactly those who heard its packet: so the radio tells who did not."""
        packets = {(p["robot"], p["time"]) for p in self.file.of("/packet") if p["side"] == "home"}
        came = collections.defaultdict(set)
        for each in self.file.of("/heard"):
            if each["side"] == "home":
                came[each["sender"], each["sent"]].add(each["robot"])
        lost = 0
        for (robot, _), life in self.lives.items():
            for sent in (message for message in life if message["segment"] == "sent"):
                self.assertIn((robot, sent["time"]), packets)
                self.assertIs(sent["left"], True)
                heard = {message["robot"] for message in life if message["segment"] == "heard"}
                self.assertEqual(heard, came[robot, sent["time"]])
                lost += TEAMMATES - len(heard)
        self.assertGreater(lost, 50)

    def follow_one_bid(self):
        """offered -> sent -> heard by some, lost for others; and what the log says of it."""
        life = next(life for (_, handle), life in sorted(self.lives.items())
                    if handle and 2 <= sum(m["segment"] == "heard" for m in life) < TEAMMATES)
        robot, handle = life[0]["robot"], life[0]["handle"]
        self.assertEqual([m["segment"] for m in life[:3]], ["offered", "sent", "heard"])
        logged = [line for line in self.lines() if line["kind"] == "segment" and line.get("handle") == handle and
                  line.get("sender", line["robot"]) == robot]
        self.assertEqual([{k: v for k, v in line.items() if k != "kind"} for line in logged], life)
        # The packet that took it along stands in the log as well.
        decisions = [line for line in self.lines() if line["kind"] == "decision" and line["side"] == "home" and
                     line["robot"] == robot and line["time"] == life[1]["time"]]
        self.assertEqual([line["packet"] for line in decisions], ["second"])

    def test_a_silent_radio_keeps_its_packets(self):
        self.write("lossy.yaml", "disturbance: silent\nradio: {silence: true}\n")
        result = self.play("--record", "a.mcap")
        self.assertEqual((result["packets"][0], result["segments_heard"]), (0, [0, 0]))
        self.assertGreater(result["segments_sent"][0], 0)
        sent = [m for m in recorded.read(self.folder / "a.mcap").of("/segment") if m["segment"] == "sent"]
        self.assertEqual({message["left"] for message in sent}, {False})
        self.assertEqual(len(sent), result["segments_sent"][0])

    def test_teams_that_say_nothing_have_no_such_topic(self):
        self.succeed("match", "small.yaml", "small.yaml", "--limit", 20, "--quiet", *program.PLAY_SOON, "--record",
                     "quiet.mcap", "--decisions", "quiet.jsonl")
        self.assertNotIn("/segment", recorded.read(self.folder / "quiet.mcap").schemas)
        self.assertNotIn("segment", {line["kind"] for line in self.lines("quiet.jsonl")})
        summary = self.succeed("match", "bids.yaml", "small.yaml", "--limit", 20, "--quiet", *program.PLAY_SOON)
        self.assertEqual(summary.count("segments offered"), 1)

    def test_the_counts_come_through_from_other_processes(self):
        rows = {}
        for name, more in (("ordinary", ()), ("isolated", ("--isolation", "always"))):
            self.succeed("tournament", "--team", "bids.yaml", "--team", "small.yaml", "--pairs", "1", "--limit", "30",
                         "--quiet", "--results", f"{name}.db", *program.PLAY_SOON, *more)
            table = self.succeed("report", f"{name}.db", "--csv", "--metrics")
            rows[name] = [{key: value for key, value in row.items() if "segments_" in key}
                          for row in csv.DictReader(io.StringIO(table))]
        self.assertEqual(rows["isolated"], rows["ordinary"])
        self.assertEqual(len(rows["isolated"]), 2)
        for row in rows["isolated"]:
            self.assertEqual(len(row), 2 * len(COUNTS))
            # One of the two teams talks.
            for kind in COUNTS:
                counts = sorted(float(value) for key, value in row.items() if key.endswith(f"segments_{kind}"))
                self.assertEqual(counts[0], 0.0)
                self.assertGreater(counts[1], 0.0)


if __name__ == "__main__":
    unittest.main()
