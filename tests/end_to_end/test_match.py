# SPDX-License-Identifier: MIT
"""`regista match`: what it plays and what it says about it."""

import json
import unittest

import program

SHORT = ("match", "small.yaml", "small.yaml", "--limit", "30", *program.PLAY_SOON)


class Match(program.Case):
    def play(self, *arguments):
        return json.loads(self.succeed(*SHORT, "--json", *arguments))

    def test_same_seed_same_match_other_seed_other_match(self):
        first, second, other = self.play(), self.play(), self.play("--seed", "2")
        for result in (first, second, other):
            del result["wall_seconds"]
        self.assertEqual(first, second)
        self.assertEqual((first["seed"], other["seed"]), (1, 2))
        self.assertRegex(first["state_hash"], "^[0-9a-f]{16}$")
        self.assertNotEqual(first["state_hash"], other["state_hash"])

    def test_largest_seed(self):
        self.assertEqual(self.play("--seed", str(2**64 - 1))["seed"], 2**64 - 1)

    def test_json_keys(self):
        result = self.play()
        self.assertEqual(list(result)[:11], ["played", "teams", "score", "seed", "ended", "simulated_seconds", "wall_seconds",
                                             "state_hash", "failures", "playing_seconds", "in_play_seconds"])
        self.assertEqual(result["teams"], ["small", "small"])
        self.assertEqual(result["ended"], "limit")
        self.assertEqual(result["simulated_seconds"], 30.0)
        self.assertEqual(result["failures"], [])
        for key in ("score", "packets", "roles", "packets_by_reason", "possession_seconds", "agreement", "falls",
                    "penalties", "kicks", "touches"):
            self.assertEqual(len(result[key]), 2, key)
        for roles in result["roles"]:
            self.assertEqual(list(roles), ["goalkeeper", "striker", "supporter", "left", "right", "back", "front"])
            for values in roles.values():
                self.assertEqual(list(values)[:3], ["overlap_seconds", "uncovered_seconds", "switches"])
        for packets, reasons in zip(result["packets"], result["packets_by_reason"]):
            self.assertEqual(packets, sum(reasons.values()))
            self.assertEqual(packets, reasons["period"] + reasons["second"])
            self.assertGreater(reasons["second"], reasons["period"])  # the plugin's own

    def test_a_role_of_two_lists_is_named_with_its_list(self):
        text = program.TEAM.format(name="two").replace(
            "utility:", "  waiting:\n    - {name: striker, target: {at: [0, 0]}}\nutility:")
        self.write("two.yaml", text)
        done = self.run_program("match", "two.yaml", "two.yaml", "--limit", "1", "--json")  # warns: nothing plays "waiting"
        result = json.loads(done.stdout)
        self.assertIn("playing.striker", result["roles"][0])
        self.assertIn("waiting.striker", result["roles"][0])
        self.assertNotIn("striker", result["roles"][0])
        self.assertIn("goalkeeper", result["roles"][0])

    def test_page_for_people(self):
        result = self.play()
        page = self.succeed(*SHORT)
        score = result["score"]
        self.assertTrue(page.startswith("What was played\n"), page)
        self.assertIn(f"\nsmall {score[0]} : {score[1]} small\n", page)
        self.assertIn("at the time limit, after 30.0 s\n", page)
        self.assertRegex(page, r"(?m)^seed +1$")
        self.assertRegex(page, rf"(?m)^state hash +{result['state_hash']}$")
        self.assertRegex(page, r"(?m)^wall time +\d+\.\d\d s")
        for side in ("home", "away"):
            self.assertIn(f"\nsmall ({side})\n", page)
        self.assertEqual(len([line for line in page.splitlines() if line.split()[:1] == ["striker"]]), 2)
        # 30 s of a match of 1200 s in which 1200 packets may be sent.
        sent = result["packets"][0]
        self.assertGreater(sent, 30)
        reasons = result["packets_by_reason"][0]
        self.assertIn(f"packets {sent} of 1200 (more than the share of this length: 30): {reasons['second']} second, "
                      f"{reasons['period']} period\n", page)
        self.assertIn("after 1.0 s, before the first kick-off\n", self.succeed("match", "small.yaml", "small.yaml", "--limit", "1"))

    def test_the_summary_has_titles_and_json_names(self):
        titles = ("--set", "a.title=The First, e.V.", "--set", "b.title=Second")
        score = self.play(*titles)["score"]
        self.assertEqual(self.play(*titles)["teams"], ["small", "small"])
        page = self.succeed(*SHORT, *titles)
        self.assertIn(f"\nThe First, e.V. {score[0]} : {score[1]} Second\n", page)
        for heading in ("The First, e.V. (home)", "Second (away)"):
            self.assertIn(f"\n{heading}\n", page)

    def test_shipped_profiles_are_the_built_in_values(self):
        configs = program.SOURCE / "configs"
        shipped = self.play("--rules", configs / "rules" / "spl2023.yaml", "--robot", configs / "robots" / "nao.yaml",
                            "--disturbance", configs / "disturbances" / "none.yaml")
        self.assertEqual(shipped["state_hash"], self.play()["state_hash"])

    def test_overrides_reach_their_document(self):
        base = self.play()["state_hash"]
        # The built-in value by name: laying it over changes nothing.
        self.assertEqual(self.play("--set", "rules.ball.rolling_deceleration=0.32",
                                   "--set", "robot.walk.turn_deg=90")["state_hash"], base)
        hashes = {base}
        for override in ("a.tasks.offset.at_most=0", "b.tasks.offset.at_most=0", "tasks.offset.at_most=0",
                         "rules.durations.ready=4", "robot.walk.forward=0.2", "disturbance.radio.loss=0.5",
                         "a_disturbance.radio.loss=0.5", "b_disturbance.radio.loss=0.5"):
            hashes.add(self.play("--set", override)["state_hash"])
        self.assertEqual(len(hashes), 9)

    def test_packets_of_a_short_game(self):
        """Each robot sends every second, as long as its team has packets left."""
        short = ("match", "small.yaml", "small.yaml", "--limit", "30", *program.PLAY_SOON)
        share = ("--set", "rules.messages.short_games=share")
        whole = json.loads(self.succeed(*short, "--json"))
        self.assertTrue(all(packets > 60 for packets in whole["packets"]), whole["packets"])
        self.assertEqual(self.values_of(whole), self.values_of(json.loads(
            self.succeed(*short, "--json", "--set", "rules.messages.short_games=whole"))))
        self.assertEqual(json.loads(self.succeed(*short, "--json", *share))["packets"], [30, 30])
        self.assertEqual(self.succeed(*short, *share).count("packets 30 of 30:"), 2)
        # A match of its whole length is none of the short games.
        match = ("match", "small.yaml", "small.yaml", *program.PLAY_SOON, "--set", "rules.durations.half=10", "--json")
        self.assertEqual(self.values_of(json.loads(self.succeed(*match))),
                         self.values_of(json.loads(self.succeed(*match, *share))))

    def values_of(self, match):
        return {key: value for key, value in match.items() if key not in ("played", "wall_seconds")}

    def test_disturbances_by_side(self):
        profiles = program.SOURCE / "configs" / "disturbances"
        none, lossy = profiles / "none.yaml", profiles / "lossy_radio.yaml"
        both = self.play("--disturbance", lossy)["state_hash"]
        home = self.play("--home-disturbance", lossy)["state_hash"]
        away = self.play("--away-disturbance", lossy)["state_hash"]
        self.assertEqual(len({self.play()["state_hash"], both, home, away}), 4)
        self.assertEqual(self.play("--home-disturbance", lossy, "--away-disturbance", lossy)["state_hash"], both)
        self.assertEqual(self.play("--disturbance", lossy, "--away-disturbance", none)["state_hash"], home)

    def test_version_and_help(self):
        self.assertRegex(self.succeed("--version"), r"^regista \d+\.\d+\.\d+ \(plugin interface 0\.2, .+\)\n$")
        for command in ((), ("match",), ("plugin", "list"), ("plugin", "info"), ("config", "check"),
                        ("config", "show"), ("config", "schema")):
            text = self.succeed(*command, "--help")
            self.assertIn("Examples:\n  regista ", text)
            self.assertIn(" ".join(("regista", *command)), text)


if __name__ == "__main__":
    unittest.main()
