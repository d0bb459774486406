# SPDX-License-Identifier: MIT
"""The teams that are shipped, with the plugins that are shipped, as a user meets them first."""

import json
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"
SHIPPED = program.PROGRAM.parent.parent / "lib" / "regista" / "plugins"


class ShippedTeams(program.Case):
    plugins = ()

    def setUp(self):
        super().setUp()
        self.plugin_folder.rmdir()
        self.plugin_folder.symlink_to(SHIPPED)

    def test_every_team_is_sound(self):
        files = sorted(TEAMS.glob("*.yaml"))
        self.assertTrue(files)
        self.assertEqual(self.succeed("config", "check", *files), "".join(f"{file}: team, sound\n" for file in files))

    def test_paper_against_fixed_rate(self):
        command = ("match", TEAMS / "paper.yaml", TEAMS / "fixed_rate.yaml", "--limit", "200", "--json")
        first, again = json.loads(self.succeed(*command)), json.loads(self.succeed(*command))
        other = json.loads(self.succeed(*command, "--seed", "2"))
        self.assertEqual(first["teams"], ["paper", "fixed_rate"])
        self.assertEqual(first["state_hash"], again["state_hash"])
        self.assertNotEqual(first["state_hash"], other["state_hash"])
        for packets in first["packets"]:
            self.assertGreater(packets, 0)
        # The ball is played: a match in which nobody finds it is none.
        self.assertGreater(sum(first["kicks"]), 0)


if __name__ == "__main__":
    unittest.main()
