# SPDX-License-Identifier: MIT
"""`--opening`: games that start from a scene, and scenes that cannot be played."""

import json
import unittest

import program

SCENES = program.SOURCE / "configs" / "openings"

SCENE = """\
opening: duel
summary: Two at the ball
length: 8
ball: {at: [0.5, 0]}
home:
  - {at: [0, 0]}
  - {at: [-4, 0]}
away:
  - {at: [1, 0], heading_deg: 180}
  - {at: [4, 0]}
"""

TWO = ("--set", "rules.team_size=2")


class Openings(program.Case):
    def setUp(self):
        super().setUp()
        self.write("duel.yaml", SCENE)

    def play(self, *arguments):
        played = json.loads(self.succeed("match", "small.yaml", "small.yaml", "--json", *arguments))
        del played["wall_seconds"]
        return played

    def duel(self, *arguments):
        return self.play(*TWO, "--opening", "duel.yaml", *arguments)

    def assert_refused(self, arguments, line):
        self.assertEqual(self.refused("match", "small.yaml", "small.yaml", *arguments), line)

    def test_a_shipped_one(self):
        played = self.play("--opening", SCENES / "through_ball.yaml")
        self.assertEqual((played["opening"], played["ended"]), ("through_ball", "limit"))
        self.assertEqual(played["simulated_seconds"], 35.0)
        self.assertGreater(played["playing_seconds"], 5.0)

    def test_every_shipped_one_is_sound(self):
        files = sorted(SCENES.glob("*.yaml"))
        self.assertGreaterEqual(len(files), 32)
        self.assertEqual(self.succeed("config", "check", *files),
                         "".join(f"{file}: opening, sound\n" for file in files))

    def test_same_seed_same_game_other_seed_or_scene_another(self):
        first = self.duel()
        self.assertEqual(first["playing_seconds"], 8.0)
        self.assertEqual(self.duel(), first)
        hashes = {first["state_hash"], self.duel("--seed", "2")["state_hash"],
                  self.duel("--set", "opening.ball.at=[0.5, 0.1]")["state_hash"],
                  self.duel("--set", "opening.home.1.at=[-3, 0]")["state_hash"],
                  self.play(*TWO, "--limit", "8")["state_hash"]}
        self.assertEqual(len(hashes), 5)
        self.assertNotIn("opening", self.play(*TWO, "--limit", "1"))

    def test_length_and_limit(self):
        self.assertEqual(self.duel("--set", "opening.length=3")["simulated_seconds"], 3.0)
        self.assertEqual(self.duel("--limit", "12")["simulated_seconds"], 12.0)

    def test_page_for_people(self):
        page = self.succeed("match", "small.yaml", "small.yaml", *TWO, "--opening", "duel.yaml")
        self.assertRegex(page, r"(?m)^opening +duel$")
        self.assertIn("at the time limit, after 8.0 s\n", page)

    def test_decisions_begin_in_play(self):
        self.duel("--decisions", "decisions.jsonl")
        lines = [json.loads(line) for line in (self.folder / "decisions.jsonl").read_text().splitlines()]
        self.assertEqual([line["event"] for line in lines if line["kind"] == "event"][:1], ["opening"])
        self.assertTrue(all(line["phase"] == "playing" for line in lines if line["kind"] == "truth"))

    def test_decisions_do_not_replace_the_scene(self):
        self.assert_refused((*TWO, "--opening", "duel.yaml", "--decisions", "duel.yaml"),
                            "--decisions duel.yaml: is a file that this match reads")

    def test_show_is_read_back_as_the_same(self):
        self.write("shown.yaml", self.succeed("config", "show", SCENES / "cross_from_the_right.yaml"))
        self.assertEqual(self.play("--opening", "shown.yaml"),
                         self.play("--opening", SCENES / "cross_from_the_right.yaml"))

    def test_team_larger_than_the_scene(self):
        self.assert_refused(("--opening", "duel.yaml"),
                            "duel.yaml:6:3: opening duel: home has 2 places, a team has 7 robots")

    def test_positions_that_do_not_fit_the_rules(self):
        self.assert_refused(
            (*TWO, "--opening", "duel.yaml", "--set", "rules.field.length=6"),
            "duel.yaml:7:10: opening duel: home 2 at (-4, 0) is off the carpet, which has room up to x = 3.55 and "
            "y = 3.55 m")
        self.assertEqual(
            self.refused("config", "check", SCENES / "through_ball.yaml", "--rules", "missing.yaml"),
            "missing.yaml: no such file")

    def test_check_with_other_rules(self):
        self.write("two.yaml", "rules: two\nteam_size: 2\n")
        done = self.run_program("config", "check", "duel.yaml")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertEqual(done.stderr,
                         "regista: duel.yaml:6:3: opening duel: home has 2 places, a team has 7 robots\n"
                         "regista: duel.yaml:9:3: opening duel: away has 2 places, a team has 7 robots\n")
        self.assertEqual(self.succeed("config", "check", "duel.yaml", "--rules", "two.yaml"),
                         "duel.yaml: opening, sound\n")

    def test_a_value_laid_over_is_blamed(self):
        self.assert_refused(
            (*TWO, "--opening", "duel.yaml", "--set", "opening.ball.at=[0.1, 0]"),
            "duel.yaml:6:10: opening duel: home 1 at (0, 0) stands on the ball at (0.1, 0): 0.1 m apart, they need "
            "0.2 m")
        self.assert_refused(
            (*TWO, "--opening", "duel.yaml", "--set", "opening.away.1.at=[1.2, 0]"),
            "--set opening.away.1.at=[1.2, 0]: opening duel: away 2 at (1.2, 0) and away 1 at (1, 0) overlap: "
            "0.2 m apart, they need 0.3 m")
        self.assert_refused((*TWO, "--opening", "duel.yaml", "--set", "opening.length=0"),
                            '--set opening.length=0: length: "0" is outside 0.1 to 3600 s')

    def test_bad_files(self):
        self.assert_refused(("--opening", "missing.yaml"), "missing.yaml: no such file")
        self.assert_refused(("--opening", "small.yaml"),
                            "small.yaml:1:1: this is a team document; expected an opening document")
        self.write("bad.yaml", SCENE.replace("ball: {at: [0.5, 0]}\n", ""))
        self.assert_refused(("--opening", "bad.yaml"), 'bad.yaml:1:1: missing key "ball"')

    def test_values_for_an_opening_that_is_not_there(self):
        self.assert_refused(("--set", "opening.length=3"),
                            "--set opening.length=3: there is no opening; --opening FILE names one")


if __name__ == "__main__":
    unittest.main()
