# SPDX-License-Identifier: MIT
"""The teams that are shipped, with the plugins that are shipped, as a user meets them first."""

import collections
import contextlib
import json
import re
import sqlite3
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"
OTHER_TEAMS = program.SOURCE / "tests" / "fixtures" / "teams"


class ShippedTeams(program.ShippedCase):
    def test_every_team_is_sound(self):
        files = sorted(TEAMS.rglob("*.yaml"))
        self.assertTrue(files)
        done = self.run_program("config", "check", *files)  # there are warnings, see below
        self.assertEqual((done.returncode, done.stdout), (0, "".join(f"{file}: team, sound\n" for file in files)))

    @unittest.skipIf(program.SANITIZED, "it plays a hundred times")
    def test_robots_of_every_team_decide_alone(self):
        """The first match comes out the same with a process for each robot, and nothing is kept between them."""
        files = sorted(TEAMS.rglob("*.yaml"))
        for team, other in zip(files, files[1:] + files[:1]):
            with self.subTest(team.stem):
                results = f"{team.parent.stem}_{team.stem}.db"
                report = json.loads(self.succeed("tournament", "--team", team, "--team", other, "--pairs", 1, "--limit", 60,
                                                 "--no-page", "--quiet", "--json", "--results", results))
                for doubt in ("not_alone", "not_reproducible", "not_proven", "kept_outside"):
                    self.assertEqual(report[doubt]["matches"], 0, report[doubt])
                with contextlib.closing(sqlite3.connect(self.folder / results)) as database:
                    played = database.execute("SELECT attempts FROM matches ORDER BY row").fetchall()
                self.assertEqual(played, [(2,), (1,)])

    def idle_terms(self, page):
        """The names of the terms that a team is warned of, of a page that extends paper.yaml."""
        self.write("other.yaml", f"extends: {TEAMS / 'paper.yaml'}\nteam: other\n{page}")
        found = json.loads(self.succeed("config", "check", "other.yaml", "--json"))["documents"][0]["warnings"]
        return sorted(re.match(r"utility\.terms\.(\w+): ", each["message"])[1] for each in found)

    def test_terms_that_change_nothing_are_warned_of(self):
        for team in TEAMS.rglob("*.yaml"):
            self.assertEqual(self.run_program("config", "check", team).stderr, "", team)
        self.write("near.yaml", f"extends: {TEAMS / 'paper.yaml'}\nteam: near\n"
                                "utility: {terms: {waypoint: {plugin: waypoint_proximity}}}\n")
        self.assertEqual(self.run_program("config", "check", "near.yaml").stderr,
                         "regista: near.yaml:3:29: warning: utility.terms.waypoint: waypoint_proximity gives all robots the "
                         "same number for a task, which changes nothing that greedy decides; weight: 0 leaves it out\n")

        openness = "utility: {terms: {waypoint: ~, free: {plugin: openness, weight: 0.3}}}\n"
        self.assertEqual(self.idle_terms(openness), ["free"])
        # As many tasks as robots, the largest sum: the same number for all is in every sum.
        self.assertEqual(self.idle_terms(openness + "assigner: {plugin: hungarian}\ncontexts: {kick_off: ~}\n"), ["free"])
        # More tasks than robots, if only until a kick-off: it says which of them are done.
        self.assertEqual(self.idle_terms(openness + "assigner: {plugin: hungarian}\n"), [])
        self.assertEqual(self.idle_terms(openness + "assigner: {plugin: hungarian}\ntasks: {keep: all}\n"), [])
        # A waypoint for each robot: then the numbers differ.
        cells = "positioner: {plugin: voronoi_cells}\n"
        self.assertEqual(self.idle_terms(cells + "utility: {terms: {waypoint: {plugin: waypoint_proximity}}}\n"), [])
        self.assertEqual(self.idle_terms(cells), ["waypoint"])  # which belong to robots, and none to a task
        self.assertEqual(self.idle_terms("utility: {terms: {waypoint: {weight: 0}}}\n"), [])

    def warned(self, name, page):
        """What a team is warned of, but for its terms, of a page that extends paper.yaml."""
        self.write(name, f"extends: {TEAMS / 'paper.yaml'}\nteam: other\n{page}")
        found = json.loads(self.succeed("config", "check", name, "--json"))["documents"][0]["warnings"]
        return [(each["line"], each["message"]) for each in found if not each["message"].startswith("utility.")]

    def test_contexts_that_contradict_themselves_are_warned_of(self):
        contradictions = {"ball_zone": "{x_least: 2, x_most: 1}", "numbers_near_ball": "{least: 3, most: 2}",
                          "score": "{least: 2, most: 1}", "set_play": "{at_most: 0}",
                          "possession": "{who: fight, likely: 1, reach: 0.05, settle: 10}"}
        for plugin, params in contradictions.items():
            found = self.warned("never.yaml", "contexts: {never: {before: search, priority: 70, plugin: "
                                f"{plugin}, params: {params}}}}}\n")
            if plugin == "possession":  # unlikely, but no contradiction
                self.assertEqual(found, [])
                continue
            self.assertEqual(found, [(3, f"contexts.never: {plugin} held in none of 12000 made-up scenes (score, set play, "
                                      "ball, robots): with these parameters it may never hold")])

    def test_contexts_that_hold_now_and_then_are_not_warned_of(self):
        for plugin, params in (
                ("ball_zone", "{x_least: 3.5, x_most: 4.5, y_least: -0.8, y_most: 0.8, band: 0}"),
                ("ball_lost", "{after: 25, seen_again: 1}"),
                ("numbers_near_ball", "{least: 4, reach: 1, margin: 0}"),
                ("numbers_near_ball", "{least: -100, most: -4}"),
                ("possession", "{who: none, settle: 5}"),
                ("score", "{least: 9, in_last: 30}"),
                ("score", "{least: -5, most: -5, in_last: 300}"),
                ("set_play", "{corner_kick: true, whose: own, at_most: 1}"),
                ("set_play", "{penalty_kick: true, whose: opponent, ready: true}"),
                ("set_play", "{goal_kick: true, whose: own, at_most: 1, hold_seconds: 2}")):
            self.assertEqual(self.warned("rare.yaml", "contexts: {rare: {before: search, priority: 70, plugin: "
                                         f"{plugin}, params: {params}}}}}\n"), [], (plugin, params))

    def test_contexts_below_one_that_always_holds_and_scenes_without_any(self):
        below = self.warned("below.yaml", "contexts: {low: {after: playing, priority: -5, plugin: possession}}\n")
        self.assertEqual([line for line, _ in below], [3])
        self.assertRegex(below[0][1], r"^contexts\.low: never in force, for playing \(.*/paper\.yaml:\d+:5\), which comes "
                                      r"first, always holds$")
        above = self.warned("above.yaml", "contexts: {any: {before: search, priority: 55, plugin: score, params: "
                                          "{least: -100}}}\n")
        below = ("search", "own_set_play", "opponent_set_play", "defend", "attack", "playing")
        self.assertEqual(len(above), len(below))
        for name, (_, message) in zip(below, above):
            self.assertRegex(message, rf"^contexts\.{name}: in each of the \d+ made-up scenes in which \w+ held, any "
                                      r"\(above\.yaml:3:17\), which comes first, held too: it may never be in force$")
        bare = self.warned("bare.yaml", "contexts: {playing: ~}\n")
        self.assertEqual(len(bare), 1)
        self.assertRegex(bare[0][1], r"^contexts: none holds in \d+ of 12000 made-up scenes, and then no robot has a role: "
                                     r"plugin: always, below attack, holds at all times$")
        # Between them, these two hold at all times.
        self.assertEqual(self.warned("both.yaml", "contexts: {playing: {plugin: score, params: {least: 0}}, behind: {after: "
                                     "playing, priority: -1, plugin: score, params: {least: -100, most: -1}}}\n"), [])

    def packets(self, name, page, of="fixed_rate.yaml"):
        """Of each robot of the home team: how many packets for which reason, in the first 130 s."""
        self.write(name, f"extends: {TEAMS / of}\nteam: other\n{page}")
        played = json.loads(self.succeed("match", name, TEAMS / "fixed_rate.yaml", "--limit", "130", "--json", "--decisions",
                                         "decisions.jsonl"))
        self.assertEqual(played["failures"], [])
        self.assertGreater(sum(played["kicks"]), 0)
        out = {number: collections.Counter() for number in range(1, 8)}
        with open(self.folder / "decisions.jsonl", encoding="utf-8") as file:
            for line in map(json.loads, file):
                if line["kind"] == "decision" and line["side"] == "home" and line["packet"] is not None:
                    out[line["robot"]][line["packet"]] += 1
        return out

    @unittest.skipIf(program.SANITIZED, "plays several matches, which sanitizers slow down to minutes")
    def test_every_reading_of_the_fixed_rate_and_of_events_is_played(self):
        """A page each, as docs/writing-a-team.md has it."""
        totals = lambda packets: sorted(sum(each.values()) for each in packets.values())
        usual = totals(self.packets("usual.yaml", ""))
        slow = totals(self.packets("slow.yaml", "sender: {params: {fast_period: 8}}\n"))
        self.assertGreater(sum(usual), sum(slow) + 5)  # the striker, whoever it is
        alike = totals(self.packets("alike.yaml", 'sender: {params: {period: 7, fast_role: ""}}\n'))
        self.assertLessEqual(alike[-1], alike[-2] + 1)  # who is out of play sends less
        for page in ("sender: {params: {at_once: false}}\n", "sender: {params: {lasts: false}}\n",
                     "predictors: {teammates: {plugin: hold_last}}\n"):
            self.assertGreater(sum(totals(self.packets("other.yaml", page))), 100, page)
        alone = self.packets("alone.yaml", "teammates_forgotten_after: 3600\nsender: {params: {periodic: false}}\n",
                             "paper.yaml")
        reasons = sum(alone.values(), collections.Counter())
        self.assertNotIn("period", reasons)
        self.assertGreaterEqual(reasons["phase_changed"], 14)
        self.assertLess(sum(totals(alone)), sum(usual))

    @unittest.skipIf(program.SANITIZED, "plays several matches, which sanitizers slow down to minutes")
    def test_regista_plays_in_other_sizes_and_on_other_fields(self):
        """The team whose behaviours reckon with teammates and opponents: with few, with many, with another body."""
        pair = (TEAMS / "regista.yaml", TEAMS / "spqr2023.yaml")
        league = ("--rules", program.SOURCE / "configs" / "rules" / "hsl2026.yaml",
                  "--robot", program.SOURCE / "configs" / "robots" / "humanoid.yaml")
        gone = "{name: gone, kind: crash, at: 1, for: 3600, robots: "
        no_opponents = ("--set", f"b_disturbance.incidents=[{gone} all}}]")
        one_left = ("--set", f"a_disturbance.incidents=[{gone} [1, 2, 3, 4, 5, 6]}}]")
        sizes = [("--set", f"rules.team_size={size}") for size in (2, 3, 5, 11)]
        for options in (*sizes, league, no_opponents, one_left):
            done = self.run_program("match", *pair, "--seed", "3", "--limit", "200", "--json", *options)
            self.assertEqual(done.returncode, 0, done.stderr)  # a small team is warned of roles that nobody takes
            played = json.loads(done.stdout)
            self.assertEqual(played["failures"], [], options)
            self.assertGreater(played["kicks"][0], 0, options)
            self.assertGreater(played["nearest_plays_ball"][0], 0.6, options)

    WITH_A_SECOND_GOALKEEPER = ("paper", "regista", "league/b_human")

    @unittest.skipIf(program.SANITIZED, "plays several matches, which sanitizers slow down to minutes")
    def test_a_lone_robot_plays_the_ball(self):
        for team in self.WITH_A_SECOND_GOALKEEPER:
            file = TEAMS / f"{team}.yaml"
            done = self.run_program("match", file, file, "--limit", "300", "--json", "--set", "rules.team_size=1")
            self.assertEqual(done.returncode, 0, done.stderr)  # there are warnings of roles that nobody takes
            self.assertGreater(min(json.loads(done.stdout)["kicks"]), 0, team)

    @unittest.skipIf(program.SANITIZED, "plays several matches, which sanitizers slow down to minutes")
    def test_another_robot_keeps_the_goal_while_the_first_is_out(self):
        """Robot 1 crashes a minute after the beginning and stays so; once with a role for it alone."""
        gone = ("--set", "a_disturbance.incidents=[{name: gone, kind: crash, at: 60, robots: [1]}]")
        alone = "{goalkeeper: {robot: 1}}"
        for team in self.WITH_A_SECOND_GOALKEEPER:
            self.write("first.yaml", f"extends: {TEAMS / team}.yaml\nteam: first\nroles: {{playing: {alone}, searching: {alone}}}\n")
            held, empty = [], []  # s that a robot holds the goalkeeper's role; that none is in the penalty area
            for file in (TEAMS / f"{team}.yaml", "first.yaml"):
                played = json.loads(self.succeed("match", file, TEAMS / "paper.yaml", "--limit", "400", "--json", *gone))
                empty.append(played["goal_empty_seconds"][0])
                held.append(sum(sum(role["robot_seconds"]) for name, role in played["roles"][0].items()
                                if name.endswith("goalkeeper")))
            self.assertGreater(held[0], 150, team)
            self.assertLess(held[1], 30, team)
            self.assertLess(empty[0], empty[1], team)

    def test_every_study_is_sound(self):
        """For experiments that means every arm at every value of the sweep."""
        files = sorted((TEAMS.parent / "studies").glob("*.yaml"))
        kinds = [line.removeprefix(f"{file}: ") for file, line in
                 zip(files, self.succeed("config", "check", *files).splitlines(), strict=True)]
        self.assertEqual(set(kinds), {"experiment, sound", "predictor_study, sound", "tournament, sound", "tuning, sound"})
        for file, kind in zip(files, kinds):
            text = file.read_text()
            self.assertTrue(text.startswith("#"), file)
            if kind.startswith(("experiment", "tournament", "tuning")):
                self.assertRegex(text, r"\nquestion: .*\?\n", file)

    def test_reference_of_plugins_is_up_to_date(self):
        written = (program.SOURCE / "docs" / "plugin-reference.md").read_text()
        self.assertEqual(self.succeed("plugin", "reference"), written,
                         "write it anew: regista plugin reference > docs/plugin-reference.md")

    def test_every_plugin_plays(self):
        """Between them, the shipped teams and those of the tests use every plugin there is."""
        listed = json.loads(self.succeed("plugin", "list", "--json"))["plugins"]
        unused = {plugin["id"] for plugin in listed}
        limit = "30" if program.SANITIZED else "120"
        for team in sorted(TEAMS.glob("*.yaml")) + sorted(TEAMS.glob("league/*.yaml")) + sorted(OTHER_TEAMS.glob("*.yaml")):
            played = json.loads(self.succeed("match", team, TEAMS / "paper.yaml", "--limit", limit, "--json"))
            self.assertEqual(played["failures"], [])
            # A behaviour that a page says nothing of is the plugin of its name.
            unused -= set(re.findall(r"\b(?:plugin|behaviour): (\w+)", self.succeed("config", "show", team)))
        self.assertEqual(unused, set())

    def test_paper_against_fixed_rate(self):
        limit = "60" if program.SANITIZED else "200"
        command = ("match", TEAMS / "paper.yaml", TEAMS / "fixed_rate.yaml", "--limit", limit, "--json")
        first, again = json.loads(self.succeed(*command)), json.loads(self.succeed(*command))
        other = json.loads(self.succeed(*command, "--seed", "2"))
        self.assertEqual(first["teams"], ["paper", "fixed_rate"])
        self.assertEqual(first["state_hash"], again["state_hash"])
        self.assertNotEqual(first["state_hash"], other["state_hash"])
        for packets in first["packets"]:
            self.assertGreater(packets, 0)
        # The ball is played: a match in which nobody finds it is none.
        if not program.SANITIZED:
            self.assertGreater(sum(first["kicks"]), 0)

    @unittest.skipIf(program.SANITIZED, "plays two long matches, which sanitizers slow down to minutes")
    def test_goals_as_lines_only_when_asked_for(self):
        command = ("match", TEAMS / "paper.yaml", TEAMS / "paper.yaml", "--json", "--limit", "600", "--set",
                   "rules.field.goal_width=4", "--set", "rules.ball.rolling_deceleration=0.1")
        done = self.run_program(*command, "--verbose")
        score = json.loads(done.stdout)["score"]
        self.assertGreater(sum(score), 0)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), sum(score))
        for line in lines:
            self.assertRegex(line, r"^\d+:\d+  goal for paper \((home|away)\), half 1, \d\d:\d\d$")
        self.assertTrue(lines[-1].startswith(f"{score[0]}:{score[1]}  "), lines)
        self.assertEqual(self.run_program(*command).stderr, "")


if __name__ == "__main__":
    unittest.main()
