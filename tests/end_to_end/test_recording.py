# SPDX-License-Identifier: MIT
"""`regista match --record`: what stands in the file is what was played, whatever happened to the program meanwhile."""

import collections
import json
import math
import os
import random
import signal
import subprocess
import time
import unittest

import jsonschema

import program
import recorded

SECONDS = 60
MATCH = ("match", "small.yaml", "other.yaml", *program.PLAY_SOON)
BOTH_HALVES = (*MATCH, "--set", "rules.durations.half=25", "--limit", SECONDS)
LONG = (*MATCH, "--set", "rules.durations.half=7200")
MILLIMETRE = 0.001 + 1e-9


def turned(pose, sign):
    """Of the field frame of a team that attacks towards sign * x."""
    x, y, *heading = pose
    return [sign * x, sign * y, *(math.remainder(each + (0 if sign > 0 else math.pi), math.tau) for each in heading)]


class Recording(program.Case):
    def setUp(self):
        super().setUp()
        other = program.TEAM.format(name="other").replace("terms: {near", "knowledge: common, terms: {near")
        self.write("other.yaml", other)

    def near(self, a, b, tolerance):
        self.assertEqual(len(a), len(b))
        for one, two in zip(a[:2], b[:2]):
            self.assertLessEqual(abs(one - two), tolerance, (a, b))
        for one, two in zip(a[2:], b[2:]):
            self.assertLessEqual(abs(math.remainder(one - two, math.tau)), tolerance, (a, b))

    def recording(self, name="a.mcap"):
        return recorded.read(self.folder / name)


class Crashed(Recording):
    def roles(self, *more):
        """Those that each robot of the home team holds before, while and after it may have crashed."""
        self.succeed(*MATCH, "--limit", 120, "--quiet", "--record", "a.mcap", "--force", *more)
        out = collections.defaultdict(set)
        for topic, message in self.recording().messages:
            if topic != "/game":
                continue
            time = message["time"]
            when = "before" if 15 < time < 19.9 else "while" if 20.3 < time < 29.7 else "after" if time > 90 else None
            for robot, role in enumerate(message["roles"][0], start=1):
                out[when, robot].add(role)
        return out

    def test_a_robot_that_has_crashed_holds_no_role(self):
        """Whatever it held when it stopped to decide; and a role again when it is back."""
        usual = self.roles()
        robot = next(n for n in range(2, 8) if all(-1 not in usual[when, n] for when in ("before", "while", "after")))
        crashed = self.roles("--set", f"a_disturbance.incidents=[{{kind: crash, robots: [{robot}], at: 20, for: 10}}]")
        self.assertEqual(crashed["before", robot], usual["before", robot])
        self.assertEqual(crashed["while", robot], {-1})
        self.assertGreaterEqual(max(crashed["after", robot]), 0)


class WhatStandsInIt(Recording):
    """Against the log of --decisions, which another part of the program writes, and the result of the match."""

    def setUp(self):
        super().setUp()
        command = (*BOTH_HALVES, "--json")
        self.without = json.loads(self.succeed(*command))
        self.result = json.loads(self.succeed(*command, "--record", "a.mcap", "--decisions", "decisions.jsonl"))
        lines = (self.folder / "decisions.jsonl").read_text().splitlines()
        self.log = collections.defaultdict(list)
        for line in map(json.loads, lines):
            self.log[line["kind"]].append(line)
        self.file = self.recording()
        self.about = {side: json.loads(self.file.about[side]) for side in ("home", "away")}
        self.halves = [event["time"] for event in self.file.of("/event") if event["event"] == "half_begins"]
        self.roles = {side: [role["name"] for role in self.about[side]["roles"]] for side in ("home", "away")}

    def sign(self, side, time):
        """Towards which end a side attacks."""
        first_half = sum(begin <= time for begin in self.halves) == 1
        return 1 if first_half == (side == "home") else -1

    def test_all(self):
        self.assertEqual(len(self.halves), 2)
        with self.subTest("recording changes nothing"):
            self.assertEqual(self.result["state_hash"], self.without["state_hash"])
        with self.subTest("whole"):
            self.assertTrue(self.file.whole)
        with self.subTest("schemas"):
            self.check_schemas()
        with self.subTest("about"):
            self.assertEqual((self.file.about["format"], self.file.about["seed"]), ("1", "1"))
            self.assertEqual([self.about[side]["team"] for side in ("home", "away")], self.result["teams"])
            again = self.file.about["command"]
            self.assertNotIn("--record", again)
        self.check_truth()
        self.check_decisions()
        self.check_beliefs()
        self.check_radio()
        self.check_metrics()
        with self.subTest("events"):
            seen = [(e["time"], e["event"], e["side"], e["robot"] or None, e["score"]) for e in self.file.of("/event")]
            self.assertEqual(seen, [(e["time"], e["event"], e["side"], e["robot"], e["score"])
                                    for e in self.log["event"]])

    def check_schemas(self):
        validators = {}
        for topic, schema in self.file.schemas.items():
            jsonschema.Draft7Validator.check_schema(schema)
            validators[topic] = jsonschema.Draft7Validator(schema)
        topics = {topic.split("/")[1] for topic in validators}
        self.assertEqual(topics, {"game", "event", "play", "packet", "heard", "decision", "belief"})
        for number, (topic, message) in enumerate(self.file.messages):
            if number % 5 == 0:  # the validator is slow
                validators[topic].validate(message)

    def check_truth(self):
        games = self.file.of("/game")
        with self.subTest("ten times a second"):
            self.assertEqual([game["time"] for game in games], [round(0.1 * (i + 1), 3) for i in range(10 * SECONDS)])
        at = {game["time"]: game for game in games}
        for line in self.log["truth"]:
            game = at[line["time"]]
            for name in ("half", "clock", "phase", "set_play", "score", "packets_left"):
                self.assertEqual(game[name], line[name])
            sign = self.sign("home", line["time"])  # the log is in the frame of home
            self.near(game["ball"][:2], turned(line["ball"], sign), MILLIMETRE)
            for side in ("home", "away"):
                for one, two in zip(game[side], line[side], strict=True):
                    self.near(one, turned(two, sign), MILLIMETRE)

    def check_decisions(self):
        """A message for each change that the log knows, with the same numbers, and one after 5 s without."""
        known = {}
        expected = []
        for line in self.log["decision"]:
            key = (line["side"], line["robot"])
            state = [line[name] for name in ("context", "role", "kept", "assignment")]
            if state != known.get(key):
                expected.append(line)
            known[key] = state
        self.assertGreater(len(expected), 30)
        for side in ("home", "away"):
            names = self.roles[side]
            contexts = [context["name"] for context in self.about[side]["contexts"]]

            def name(row):
                return {-1: None, -2: "unknown"}.get(row) if row < 0 else names[row]

            for robot in range(1, 8):
                messages, repeated = self.changes(self.file.of(f"/decision/{side}/{robot}"))
                gaps = [b["time"] - a["time"] for a, b in zip(repeated, repeated[1:])]
                self.assertLessEqual(max(gaps), 5.0 + 1e-6)
                lines = [line for line in expected if (line["side"], line["robot"]) == (side, robot)]
                for message, line in zip(messages, lines, strict=True):
                    context = message["context"]
                    self.assertEqual(message["time"], line["time"])
                    self.assertEqual(contexts[context] if context >= 0 else None, line["context"])
                    self.assertEqual(name(message["role"]), line["role"])
                    self.assertEqual([name(row) for row in message["assigned"]], line["assignment"])
                    self.assertEqual([name(row) for row in message["columns"]], line["kept"])
                    self.assertEqual(len(message["waypoints"]), line["waypoints"])
                    self.check_matrices(side, robot, message, line, name)
                    if line["target"] is not None:
                        task = next(task for task in message["tasks"] if task["role"] == message["role"])
                        for when in ("before", "after"):
                            sign = self.sign(side, message["time"])
                            self.near(task[when], turned(line["target"][when], sign), 0.006)

    def changes(self, messages):
        """Those that tell of a change, and all."""
        found = []
        for message in messages:
            told = [message[name] for name in ("context", "role", "columns", "assigned")]
            if not found or told != found[-1][0]:
                found.append((told, message))
        return [message for _, message in found], messages

    def check_matrices(self, side, robot, message, line, name):
        if line["utility"] is None:
            return
        row = message["rows"].index(robot)
        for column, role in enumerate(message["columns"]):
            value, logged = message["utility"][row][column], line["utility"][name(role)]
            if logged is None:
                self.assertIsNone(value)
            else:
                self.assertLessEqual(abs(value - logged), 2e-5 + 1e-4 * abs(logged))
        # What is not forbidden is the weighted sum of its terms.
        weights = [term["weight"] for term in self.about[side]["contexts"][message["context"]]["terms"]]
        for i, values in enumerate(message["utility"]):
            for j, value in enumerate(values):
                if value is not None:
                    total = sum(weight * term[i][j] for weight, term in zip(weights, message["terms"], strict=True))
                    self.assertLessEqual(abs(value - total), 2e-4)

    def check_beliefs(self):
        for side in ("home", "away"):
            for robot in range(1, 8):
                beliefs = self.file.of(f"/belief/{side}/{robot}")
                decided = self.file.of(f"/decision/{side}/{robot}")
                with self.subTest("twice a second", side=side, robot=robot):
                    gaps = [b["time"] - a["time"] for a, b in zip(beliefs, beliefs[1:])]
                    self.assertLessEqual(max(gaps), 0.5 + 1e-6)
                with self.subTest("at each change of role", side=side, robot=robot):
                    times = {belief["time"] for belief in beliefs}
                    changed = [b for a, b in zip(decided, decided[1:]) if a["role"] != b["role"]]
                    self.assertTrue(all(message["time"] in times for message in changed))
                with self.subTest("what all know, where it is used", side=side):
                    self.assertTrue(all(("common" in belief) == (side == "away") for belief in beliefs))
                for belief in beliefs:
                    own = belief["mine"]["teammates"]["number"].index(robot)
                    self.near(belief["mine"]["teammates"]["pose"][own], belief["pose"], 0.011)

    def check_radio(self):
        packets = self.file.of("/packet")
        with self.subTest("each packet"):
            expected = [(line["time"], line["side"], line["robot"], line["packet"]) for line in self.log["decision"]
                        if line["packet"] is not None]
            self.assertEqual([(p["time"], p["side"], p["robot"], p["reason"]) for p in packets], expected)
        with self.subTest("who heard it"):
            sent = {(p["side"], p["robot"], p["time"]) for p in packets}
            heard = self.file.of("/heard")
            self.assertGreater(len(heard), len(packets))
            for each in heard:
                self.assertIn((each["side"], each["sender"], each["sent"]), sent)
                self.assertNotEqual(each["robot"], each["sender"])
                self.assertGreater(each["time"], each["sent"])

    def check_metrics(self):
        """Overlap and uncovered time, counted from the file as match/metrics.hpp says."""
        for i, side in enumerate(("home", "away")):
            roles = self.about[side]["roles"]
            overlap, uncovered = collections.Counter(), collections.Counter()
            for game in self.file.of("/game"):
                if game["phase"] != "playing":
                    continue
                active = [n for n in range(1, 8) if n not in game["penalised"][i]]
                held = collections.Counter(game["roles"][i][n - 1] for n in active if game["roles"][i][n - 1] >= 0)
                lists = collections.Counter()
                for role, count in held.items():
                    lists[roles[role]["list"]] += count
                in_force = max(lists, key=lists.get) if lists else None
                for row, role in enumerate(roles):
                    overlap[row] += held[row] >= 2
                    wanted = role["list"] == in_force and role["priority"] < len(active) and (
                        role["least_in_play"] <= len(active) and (not role["robots"] or set(active) & set(role["robots"])))
                    uncovered[row] += held[row] == 0 and wanted
            stored = self.result["roles"][i]
            for row, role in enumerate(roles):
                with self.subTest("metrics", side=side, role=role["name"]):
                    self.assertAlmostEqual(0.1 * overlap[row], stored[role["name"]]["overlap_seconds"], 6)
                    self.assertAlmostEqual(0.1 * uncovered[row], stored[role["name"]]["uncovered_seconds"], 6)

    def test_packets_that_a_silent_radio_never_sends_are_not_told(self):
        self.write("silent.yaml", "disturbance: silent\nradio: {silence: true}\n")
        result = json.loads(self.succeed(*BOTH_HALVES, "--json", "--home-disturbance", "silent.yaml", "--record",
                                         "silent.mcap", "--decisions", "silent.jsonl"))
        lines = map(json.loads, (self.folder / "silent.jsonl").read_text().splitlines())
        logged = collections.Counter(line["side"] for line in lines if line.get("packet") is not None)
        told = collections.Counter(packet["side"] for packet in self.recording("silent.mcap").of("/packet"))
        self.assertEqual(result["packets"][0], 0)
        self.assertGreater(result["packets"][1], 0)
        self.assertEqual(logged, {"away": result["packets"][1]})
        self.assertEqual(told, logged)

    def test_same_match_same_bytes(self):
        before = (self.folder / "a.mcap").read_bytes()
        os.symlink(self.program, self.folder / "bin" / "another-name")
        self.program = self.folder / "bin" / "another-name"
        self.succeed(*BOTH_HALVES, "--quiet", "--record", "b.mcap")
        self.assertEqual((self.folder / "b.mcap").read_bytes(), before)

    def test_who_shares_a_role_tells_why(self):
        """At the beginning of an overlap there is a fresh decision of everybody in it."""
        checked = 0
        for i, side in enumerate(("home", "away")):
            decided = {n: [d["time"] for d in self.file.of(f"/decision/{side}/{n}")] for n in range(1, 8)}
            before = {}
            for game in self.file.of("/game"):
                held = collections.defaultdict(set)
                for n, role in enumerate(game["roles"][i], 1):
                    if role >= 0:
                        held[role].add(n)
                for role, robots in held.items():
                    if len(robots) < 2 or robots == before.get(role) or game["time"] > SECONDS - 0.5:
                        continue
                    for robot in robots:
                        near = [t for t in decided[robot] if abs(t - game["time"]) <= 0.25]
                        self.assertTrue(near, (side, game["time"], robot))
                        checked += 1
                before = held
        self.assertGreater(checked, 4)


class Play(Recording):
    plugins = tuple(sorted(program.BEHAVIOURS[0].parent.glob("*.so")))  # all that are shipped

    def test_as_much_is_told_as_is_counted(self):
        """Of each kind, and the nearest robot goes for the ball as often."""
        teams = [program.SOURCE / "configs/teams" / name for name in ("regista.yaml", "spqr2023.yaml")]
        result = json.loads(self.succeed("match", *teams, "--seed", "31", "--limit", "400", "--json", "--record",
                                         "a.mcap"))
        file = self.recording()
        plays = file.of("/play")
        validator = jsonschema.Draft7Validator(file.schemas["/play"])
        for play in plays:
            validator.validate(play)
        self.assertEqual(sorted(play["time"] for play in plays), [play["time"] for play in plays])
        self.assertEqual(sum(play["kind"] == "duel" for play in plays), result["duels"])
        for i, side in enumerate(("home", "away")):
            told = collections.Counter(play["kind"] for play in plays if play["side"] == side)
            for kind, metric in (("shot", "shots"), ("pass", "meant_passes"), ("clearance", "clearances")):
                self.assertEqual(told[kind], result[metric][i], (side, kind))
            able = goes = 0
            for game in file.of("/game"):
                if game["phase"] != "playing" or game["set_play"] != "none":
                    continue
                out = {*game["penalised"][i], *game["fallen"][i]}
                self.assertFalse(out & {*game["chases"][i]})
                near = [(math.dist(pose[:2], game["ball"][:2]), n) for n, pose in enumerate(game[side], 1)
                        if n not in out]
                able += len(near) > 0
                goes += len(near) > 0 and min(near)[1] in game["chases"][i]
            self.assertAlmostEqual(goes / able, result["nearest_plays_ball"][i], 3)
        self.assertEqual({play["kind"] for play in plays}, {"shot", "pass", "clearance", "duel"})


class Ends(Recording):
    def test_a_file_that_exists_is_kept(self):
        self.succeed(*MATCH, "--limit", "1", "--quiet", "--record", "a.mcap")
        first = (self.folder / "a.mcap").read_bytes()
        self.assertEqual(self.refused(*MATCH, "--record", "a.mcap"),
                         "--record a.mcap: exists already; --force replaces it")
        self.assertEqual((self.folder / "a.mcap").read_bytes(), first)
        self.succeed(*MATCH, "--limit", "3", "--quiet", "--record", "a.mcap", "--force")
        self.assertEqual(len(self.recording().of("/game")), 30)
        self.write("empty.mcap", "")
        self.succeed(*MATCH, "--limit", "1", "--quiet", "--record", "empty.mcap", "--force")

    def test_no_file_of_another_kind_is_replaced(self):
        self.write("mine.txt", "mine")
        self.succeed("tournament", "--team", "small.yaml", "--team", "other.yaml", "--pairs", "1", "--limit", "1",
                     "--quiet", "--results", "mine.db")
        self.succeed(*MATCH, "--limit", "1", "--quiet", "--record", "a.mcap")
        from_results = ("match", "--from", "mine.db", "--row", "1")
        for name in ("mine.txt", "mine.db", "small.yaml", f"lib/regista/plugins/{program.SOUND.name}"):
            before = (self.folder / name).read_bytes()
            for command in (MATCH, from_results):
                self.refused(*command, "--record", name, "--force")
                self.refused(*command, "--decisions", name)
            self.refused("view", "a.mcap", "--at", "0.5", "-o", name, "--force")
            self.refused("report", "mine.db", "-o", name, "--force")
            self.assertEqual((self.folder / name).read_bytes(), before)
        self.assertIn("both name", self.refused(*MATCH, "--record", "x.j", "--decisions", "./x.j", "--force"))
        self.assertIn("is a file that this match reads", self.refused(*MATCH, "--record", "small.yaml", "--force"))
        self.assertIn("belongs to --record", self.refused(*MATCH, "--force"))

    def test_places_where_nothing_can_be_written(self):
        self.assertIn("No such file or directory", self.refused(*MATCH, "--record", "none/a.mcap"))
        if os.path.exists("/dev/full"):
            self.assertIn("No space left", self.refused(*MATCH, "--record", "/dev/full", "--force"))

    def test_a_disk_that_fills_up_ends_the_match_with_a_line(self):
        limited = f"ulimit -f 100; trap '' XFSZ; exec {self.program} {' '.join(map(str, LONG))} --quiet --record a.mcap"
        done = subprocess.run(["sh", "-c", limited], cwd=self.folder, env=self.environment(), text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=60)
        self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
        self.assertEqual(done.stderr, "regista: a.mcap: cannot be written: File too large\n")
        self.assertGreater(len(self.recording().of("/game")), 10)

    def stopped(self, number):
        """How far the match had come when it was stopped."""
        with self.start(*LONG, "--quiet", "--record", "a.mcap", stdout=subprocess.DEVNULL,
                        stderr=subprocess.PIPE) as process:
            file = self.folder / "a.mcap"
            end = time.monotonic() + 60
            while not file.exists() or file.stat().st_size < 200_000:
                self.assertLess(time.monotonic(), end)
                self.assertIsNone(process.poll())
                time.sleep(0.01)
            process.send_signal(number)
            _, self.said = process.communicate(timeout=60)
        return process.returncode

    def test_after_ctrl_c_the_file_is_whole(self):
        self.assertEqual(self.stopped(signal.SIGINT), 130)
        self.assertTrue(self.recording().whole)
        self.assertTrue(self.said.endswith(" --quiet --record a.mcap --force\n"), self.said)
        self.assertEqual(self.succeed("view", "a.mcap", "--at", "3", "-o", "a.svg"), "a.svg\n")

    def test_after_a_crash_what_was_finished_is_there(self):
        self.assertEqual(self.stopped(signal.SIGKILL), -signal.SIGKILL)
        file = self.recording()
        self.assertFalse(file.whole)
        games = file.of("/game")
        self.assertEqual([game["time"] for game in games], [round(0.1 * (i + 1), 3) for i in range(len(games))])
        done = self.run_program("view", "a.mcap", "--at", "3", "-o", "a.svg")
        self.assertEqual((done.returncode, done.stdout), (0, "a.svg\n"))
        self.assertIn("is cut off at byte", done.stderr)

    def test_a_file_cut_anywhere_yields_its_complete_chunks(self):
        self.succeed(*MATCH, "--limit", "20", "--quiet", "--record", "a.mcap")
        data = (self.folder / "a.mcap").read_bytes()
        chance = random.Random(5)
        reached = set()
        for _ in range(100):
            size = chance.randrange(len(data))
            (self.folder / "cut.mcap").write_bytes(data[:size])
            done = self.run_program("view", "cut.mcap", "--at", "0.1", "-o", "cut.svg", "--force")
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            games = recorded.Recording(data[:size]).of("/game") if size >= 8 else []
            reached.add(len(games))
            self.assertEqual(done.returncode, 0 if games else 2, (size, done.stderr))
            if not games:
                continue
            # It sees the last state that stands in a complete chunk, and nothing beyond.
            last = games[-1]["time"]
            beyond = self.run_program("view", "cut.mcap", "--at", last + 0.1, "-o", "cut.svg", "--force")
            self.assertIn(f"the recording ends at {last:.1f} s", beyond.stderr)
        self.assertGreater(len(reached), 5)


if __name__ == "__main__":
    unittest.main()
