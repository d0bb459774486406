# SPDX-License-Identifier: MIT
"""Every command does its main job once, with the shipped plugins and documents; a new command needs a line here."""

import json
import re
import unittest

import program

SHIPPED = program.PROGRAM.parent.parent / "lib" / "regista" / "plugins"
CONFIGS = program.SOURCE / "configs"
TEAMS = CONFIGS / "teams"

EXPERIMENT = f"""\
experiment: trial
question: Does the sender matter?
arms: [{{name: events, team: "{TEAMS}/paper.yaml"}}, {{name: clock, team: "{TEAMS}/fixed_rate.yaml"}}]
opponent: "{TEAMS}/paper.yaml"
matches: 2
seed: 3
limit: 5
primary: {{measure: overlap_seconds}}
"""
TUNING = f"""\
tuning: trial
question: Is another weight better?
team: "{TEAMS}/paper.yaml"
opponents: [{{team: "{TEAMS}/fixed_rate.yaml"}}]
parameters: [utility.terms.distance.weight]
objective: {{minimise: uncovered_seconds}}
set: {{rules.durations.ready: 2, rules.durations.set: 1}}
limit: 5
seed: 7
search: {{algorithm: random_search, matches: 4}}
selection: {{finalists: 1, matches: 4}}
verification: {{candidates: 1, matches: 20, against: base}}
"""
RECORDING = "event,t,x_mm,y_mm\n" + "".join(f"1,{i / 70:.4f},{1000 * i / 70:.3f},0\n" for i in range(210))


class Smoke(program.ShippedCase):
    def setUp(self):
        super().setUp()
        self.folder.joinpath("share").symlink_to(program.PROGRAM.parent.parent / "share")

    def commands(self, *group):
        """The commands that the help of the program, or of a group of commands, lists."""
        listed = self.succeed(*group, "--help").split("Commands:\n")[1].split("\n\n")[0]
        return {" ".join([*group, name]) for name in re.findall(r"^  ([\w-]+) ", listed, re.MULTILINE)}

    def smokes(self):
        return {name.removeprefix("test_").replace("__", " ").replace("_", "-") for name in dir(self)
                if name.startswith("test_") and name != "test_each_command_is_here"}

    def test_each_command_is_here(self):
        groups = {"plugin", "config"}
        commands = self.commands() - groups
        for group in sorted(groups):
            commands |= self.commands(group)
        self.assertEqual(commands, self.smokes())

    def tournament(self, *more):
        return self.succeed("tournament", "--team", TEAMS / "paper.yaml", "--team", TEAMS / "fixed_rate.yaml", "--pairs", 1,
                            "--limit", 5, "--quiet", "--no-page", "--results", "r.db", *more)

    def match(self, *more):
        return self.succeed("match", TEAMS / "paper.yaml", TEAMS / "fixed_rate.yaml", "--seed", 1, "--limit", 10, *more)

    def test_match(self):
        first = json.loads(self.match("--json"))
        self.assertEqual(first["state_hash"], json.loads(self.match("--json"))["state_hash"])

    def test_view(self):
        self.match("--record", "m.mcap")
        self.succeed("view", "m.mcap", "--at", "9", "-o", "m.svg")
        self.assertIn("<svg", (self.folder / "m.svg").read_text())

    def test_tournament(self):
        self.assertIn("paper", self.tournament())

    def test_experiment(self):
        self.write("e.yaml", EXPERIMENT)
        self.assertIn("events", self.succeed("experiment", "e.yaml", "--quiet", "--no-page"))

    def test_tune(self):
        self.write("t.yaml", TUNING)
        self.assertIn("trial", self.succeed("tune", "t.yaml", "--quiet", "--no-page"))

    def test_run(self):
        self.write("e.yaml", EXPERIMENT)
        self.assertIn("events", self.succeed("run", "e.yaml", "--quiet", "--no-page"))

    def test_resume(self):
        self.assertEqual(self.tournament(), self.succeed("resume", "r.db", "--quiet"))

    def test_report(self):
        self.assertEqual(self.tournament(), self.succeed("report", "r.db"))

    def test_results(self):
        self.tournament()
        self.assertIn("r.db", self.succeed("results"))

    def test_gather(self):
        self.assertIn("no folder of a study", self.refused("gather", "."))

    def test_status(self):
        self.assertIn("no folder of a study", self.refused("status", "."))

    def test_stop(self):
        self.assertIn("no folder of a study", self.refused("stop", "."))

    def test_power(self):
        self.tournament()
        self.assertIn("r.db holds 1 pair", self.refused("power", "r.db"))

    def test_sprt(self):
        self.assertIn("LLR", self.succeed("sprt", "--elo", "0,10", 34, 54, 63, 64, 75))

    def test_rank(self):
        self.write("games.csv", "first,second,wins,draws,losses\na,b,7,1,2\n")
        self.assertIn("Elo", self.succeed("rank", "games.csv"))

    def test_evaluate_predictor(self):
        self.write("m_ball_raw.csv", RECORDING)
        self.write("m_referee.csv", "event,t,state\n1,0,GameRunning\n")
        self.assertIn("kalman_ball", self.succeed("evaluate-predictor", CONFIGS / "studies/ssl_ball.yaml",
                                                 "--quiet", "--data", "m_ball_raw.csv", "--referee", "m_referee.csv"))

    def test_metrics(self):
        self.assertIn("overlap_seconds", self.succeed("metrics"))

    def test_completion(self):
        self.assertIn("regista", self.succeed("completion", "bash"))

    def test_help(self):
        self.assertEqual(self.succeed("help", "match"), self.succeed("match", "--help"))

    def test_plugin__list(self):
        self.assertIn("voronoi", self.succeed("plugin", "list"))

    def test_plugin__info(self):
        self.assertIn("voronoi", self.succeed("plugin", "info", "voronoi"))

    def test_plugin__new(self):
        self.succeed("plugin", "new", "assigner", "mine")
        self.assertTrue((self.folder / "mine" / "CMakeLists.txt").exists())

    def test_plugin__check(self):
        self.assertIn("1 pass", self.succeed("plugin", "check", SHIPPED / "greedy.so", "--only", "assigner.promises"))

    def test_plugin__reference(self):
        self.assertIn("greedy", self.succeed("plugin", "reference"))

    def test_config__check(self):
        self.assertIn("sound", self.succeed("config", "check", TEAMS / "paper.yaml"))

    def test_config__show(self):
        self.assertIn("team: paper", self.succeed("config", "show", TEAMS / "paper.yaml"))

    def test_config__diff(self):
        done = self.run_program("config", "diff", "paper", "fixed_rate")
        self.assertEqual(done.returncode, 1)
        self.assertIn("sender.plugin: event_based | fixed_rate", done.stdout)

    def test_config__schema(self):
        self.assertIn("$schema", json.loads(self.succeed("config", "schema", "team")))

    def test_config__reference(self):
        self.assertIn("#", self.succeed("config", "reference"))

    def test_config__draw(self):
        self.succeed("config", "draw", TEAMS / "paper.yaml", "-o", "team.svg")
        self.assertIn("<svg", (self.folder / "team.svg").read_text())

    def test_config__copy(self):
        self.succeed("config", "copy", "mine")
        self.assertTrue((self.folder / "mine" / "teams" / "paper.yaml").exists())


if __name__ == "__main__":
    unittest.main()
