# SPDX-License-Identifier: MIT
"""The teams that are shipped, with the plugins that are shipped, as a user meets them first."""

import json
import re
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"
OTHER_TEAMS = program.SOURCE / "tests" / "fixtures" / "teams"
SHIPPED = program.PROGRAM.parent.parent / "lib" / "regista" / "plugins"


class Shipped(program.Case):
    """With the plugins that are shipped."""

    plugins = ()

    def setUp(self):
        super().setUp()
        self.plugin_folder.rmdir()
        self.plugin_folder.symlink_to(SHIPPED)


class ShippedTeams(Shipped):
    def test_every_team_is_sound(self):
        files = sorted(TEAMS.glob("*.yaml"))
        self.assertTrue(files)
        done = self.run_program("config", "check", *files)  # there are warnings, see below
        self.assertEqual((done.returncode, done.stdout), (0, "".join(f"{file}: team, sound\n" for file in files)))

    def idle_terms(self, page):
        """The names of the terms that a team is warned of, of a page that extends paper.yaml."""
        self.write("other.yaml", f"extends: {TEAMS / 'paper.yaml'}\nteam: other\n{page}")
        found = json.loads(self.succeed("config", "check", "other.yaml", "--json"))["documents"][0]["warnings"]
        return sorted(re.match(r"utility\.terms\.(\w+): ", each["message"])[1] for each in found)

    def test_terms_that_change_nothing_are_warned_of(self):
        where = next(line for line, text in enumerate((TEAMS / "paper.yaml").read_text().splitlines(), 1)
                     if "plugin: waypoint_proximity" in text)
        warning = (f"regista: {TEAMS}/paper.yaml:{where}:18: warning: utility.terms.waypoint: waypoint_proximity gives all "
                   "robots the same number for a task, which changes nothing that greedy decides; weight: 0 leaves it out\n")
        for name, expected in (("paper", warning), ("regista", warning), ("fixed_rate", ""), ("events_only", ""),
                               ("formation", ""), ("scram", ""), ("spqr2023", "")):
            self.assertEqual(self.run_program("config", "check", TEAMS / f"{name}.yaml").stderr, expected, name)

        openness = "utility: {terms: {waypoint: ~, free: {plugin: openness, weight: 0.3}}}\n"
        self.assertEqual(self.idle_terms(openness), ["free"])
        # As many tasks as robots, the largest sum: the same number for all is in every sum.
        self.assertEqual(self.idle_terms(openness + "assigner: {plugin: hungarian}\n"), ["free"])
        # More tasks than robots: it says which of them are done.
        self.assertEqual(self.idle_terms(openness + "assigner: {plugin: hungarian}\ntasks: {keep: all}\n"), [])
        # A waypoint for each robot: then the numbers differ.
        self.assertEqual(self.idle_terms("positioner: {plugin: voronoi_cells}\n"), [])
        self.assertEqual(self.idle_terms("utility: {terms: {waypoint: {weight: 0}}}\n"), [])

    def test_every_study_is_sound(self):
        """For experiments that means every arm at every value of the sweep."""
        files = sorted((TEAMS.parent / "studies").glob("*.yaml"))
        kinds = [line.removeprefix(f"{file}: ") for file, line in
                 zip(files, self.succeed("config", "check", *files).splitlines(), strict=True)]
        self.assertEqual(set(kinds), {"experiment, sound", "predictor_study, sound", "tuning, sound"})
        for file, kind in zip(files, kinds):
            text = file.read_text()
            self.assertTrue(text.startswith("#"), file)
            if kind.startswith(("experiment", "tuning")):
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
        for team in sorted(TEAMS.glob("*.yaml")) + sorted(OTHER_TEAMS.glob("*.yaml")):
            played = json.loads(self.succeed("match", team, TEAMS / "paper.yaml", "--limit", limit, "--json"))
            self.assertEqual(played["failures"], [])
            unused -= set(re.findall(r"plugin: (\w+)", self.succeed("config", "show", team)))
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
