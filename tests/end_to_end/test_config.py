# SPDX-License-Identifier: MIT
"""`regista config check`, `show` and `schema`."""

import json
import unittest

import program

PROFILES = ("rules/spl2023.yaml", "robots/nao.yaml", "disturbances/none.yaml")


class Config(program.Case):
    def profiles(self):
        return [program.SOURCE / "configs" / each for each in PROFILES]

    def test_check_of_every_kind(self):
        files = self.profiles()
        self.assertEqual(self.succeed("config", "check", *files, "small.yaml"),
                         f"{files[0]}: rules, sound\n{files[1]}: robot, sound\n{files[2]}: disturbance, sound\n"
                         "small.yaml: team, sound\n")

    def test_check_goes_on_after_what_is_not_sound(self):
        self.write("bad.yaml", "team: bad\nroles: 3\n")
        done = self.run_program("config", "check", "bad.yaml", "small.yaml", "missing.yaml")
        self.assertEqual((done.returncode, done.stdout), (2, "small.yaml: team, sound\n"))
        first, second = done.stderr.splitlines()
        self.assertTrue(first.startswith("regista: bad.yaml:"), first)
        self.assertTrue(second.startswith("regista: missing.yaml: "), second)

    def test_check_opens_plugins_of_teams(self):
        self.write("team.yaml", program.TEAM.format(name="team").replace("scale: 2", "scale: 20"))
        self.assertRegex(self.refused("config", "check", "team.yaml"),
                         r'^team\.yaml:\d+:\d+: .*scale.*20.*0\.1 to 10 m')

    def test_show_is_read_back_as_the_same(self):
        for file in (*self.profiles(), "small.yaml"):
            shown = self.succeed("config", "show", file)
            self.write("shown.yaml", shown)
            self.assertEqual(self.values(self.succeed("config", "show", "shown.yaml")), self.values(shown))

    def values(self, page):
        """A page without its comments, which tell where values are from."""
        return [line.split("#")[0].rstrip() for line in page.splitlines()]

    def test_show_with_a_value_laid_over(self):
        page = self.succeed("config", "show", "small.yaml", "--set", "utility.terms.near.weight=0.25")
        self.assertRegex(page, r"(?m)^\s+weight: 0\.25\s")

    def test_show_knows_the_parameters_of_plugins(self):
        page = self.succeed("config", "show", "small.yaml")
        self.assertRegex(page, r"(?m)^\s+squared: false\s")

    def test_schema(self):
        for kind in ("rules", "robot", "disturbance", "opening", "team"):
            schema = json.loads(self.succeed("config", "schema", kind))
            self.assertEqual(schema["$schema"], "https://json-schema.org/draft/2020-12/schema")

    def test_schema_of_teams_knows_plugins(self):
        self.assertIn("first_free", self.succeed("config", "schema", "team"))


if __name__ == "__main__":
    unittest.main()
