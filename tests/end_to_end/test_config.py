# SPDX-License-Identifier: MIT
"""`regista config check`, `show` and `schema`."""

import json
import re
import unittest

import program

PROFILES = ("rules/spl2023.yaml", "robots/nao.yaml", "disturbances/none.yaml")

# The teams of these tests have no role for a ball that nobody knows, and are warned of that each time.
NO_ROLE = re.compile(r"contexts: none holds in \d+ of 12000 made-up scenes, and then no robot has a role: plugin: always, "
                     r"below playing, holds at all times")


class Config(program.Case):
    def run_program(self, *arguments, **options):
        done = super().run_program(*arguments, **options)
        kept = [line for line in done.stderr.splitlines(keepends=True) if not NO_ROLE.search(line)]
        done.stderr = "".join(kept)
        return done

    def test_a_team_that_may_have_no_role_is_warned_of(self):
        done = super().run_program("config", "check", "small.yaml")
        self.assertEqual((done.returncode, done.stdout), (0, "small.yaml: team, sound\n"))
        self.assertRegex(done.stderr, r"^regista: small\.yaml:8:5: warning: " + NO_ROLE.pattern + "\n$")

    def profiles(self):
        return [program.SOURCE / "configs" / each for each in PROFILES]

    def test_check_of_every_kind(self):
        files = self.profiles()
        self.assertEqual(self.succeed("config", "check", *files, "small.yaml"),
                         f"{files[0]}: rules, sound\n{files[1]}: robot, sound\n{files[2]}: disturbance, sound\n"
                         "small.yaml: team, sound\n")

    def test_a_sketch_says_so(self):
        rules = program.SOURCE / "configs" / "rules" / "hsl2026.yaml"
        done = self.run_program("config", "check", rules)
        self.assertEqual((done.returncode, done.stdout), (0, f"{rules}: rules, sound\n"))
        self.assertRegex(done.stderr, rf"^regista: {rules}:2:1: warning: a sketch: half of these numbers [^\n]+\n$")
        # In the head alone, and only as a line of its own.
        self.write("own.yaml", "# no Sketch: here\nrules: own\n# Sketch: below the head\n")
        self.assertEqual(self.succeed("config", "check", "own.yaml"), "own.yaml: rules, sound\n")

    def test_check_goes_on_after_what_is_not_sound(self):
        self.write("bad.yaml", "team: bad\nroles: 3\n")
        done = self.run_program("config", "check", "bad.yaml", "small.yaml", "missing.yaml")
        self.assertEqual((done.returncode, done.stdout), (2, "small.yaml: team, sound\n"))
        *bad, missing = done.stderr.splitlines()
        self.assertEqual([each.split(" ", 2)[1] for each in bad], ["bad.yaml:1:1:"] * 4 + ["bad.yaml:2:8:"])
        self.assertTrue(missing.startswith("regista: missing.yaml: "), missing)

    def test_check_opens_plugins_of_teams(self):
        self.write("team.yaml", program.TEAM.format(name="team").replace("scale: 2", "scale: 20"))
        self.assertRegex(self.refused("config", "check", "team.yaml"),
                         r'^team\.yaml:\d+:\d+: .*scale.*20.*0\.1 to 10 m')

    # Each line of TEAM that is wrong, what it is instead, and what is said of it.
    MISTAKES = (("ball:      {plugin: last_news}", "ball:      {plugin: lost_news}", 'unknown predictor "lost_news"'),
                ("opponents: {plugin: last_news}", "opponents: {plugin: 7}", 'predictors.opponents.plugin: "7" is not'),
                ("plugin: ball_seen", "plugin: nearness", "nearness"),
                ("at_most: 0.3", "at_most: far", 'tasks.offset.at_most: "far" is not a number'),
                ("robot: 1,", "robot: 99,", "roles.playing.0.robot: the role goalkeeper is for robot 99, "
                                            "a team has 7 robots by the rules spl2023"),
                ("required: true", "required: yes", 'roles.playing.1.required: "yes" is neither true nor false'),
                ("[-1, 0]", "[-1]", "roles.playing.2.target.shift: 1 elements"),
                ("params: {scale: 2}", "params: {scale: 20, sale: 2}", "scale"),
                ("assigner:", "asigner:", 'unknown key "asigner"'))

    def mistaken(self):
        """A page with all of them, and the numbers of their lines."""
        page, lines = program.TEAM.format(name="wrong"), []
        for sound, mistaken, _ in self.MISTAKES:
            self.assertEqual(page.count(sound), 1, sound)
            lines.append(page[:page.index(sound)].count("\n") + 1)
            page = page.replace(sound, mistaken)
        return page, lines

    def test_check_tells_every_mistake_in_the_order_of_the_lines(self):
        page, lines = self.mistaken()
        self.write("wrong.yaml", page)
        done = self.run_program("config", "check", "wrong.yaml", "small.yaml")
        self.assertEqual((done.returncode, done.stdout), (2, "small.yaml: team, sound\n"))
        told = done.stderr.splitlines()
        wanted = []
        for (_, _, message), line in zip(self.MISTAKES, lines):
            wanted += [(line, message)] * (2 if message == "scale" else 1)  # a wrong value, an unknown parameter
        self.assertEqual(len(told), len(wanted), done.stderr)
        for each, (line, message) in zip(told, wanted):
            self.assertRegex(each, rf"^regista: wrong\.yaml:{line}:\d+: ")
            self.assertIn(message, each)

    def test_check_as_json(self):
        page, lines = self.mistaken()
        self.write("wrong.yaml", page)
        done = self.run_program("config", "check", "wrong.yaml", "small.yaml", "--json")
        self.assertEqual((done.returncode, done.stderr), (2, ""))
        wrong, sound = json.loads(done.stdout)["documents"]
        self.assertEqual((wrong["file"], wrong["kind"], wrong["sound"]), ("wrong.yaml", "team", False))
        self.assertEqual(sorted({each["line"] for each in wrong["mistakes"]}), sorted(lines))
        self.assertEqual(wrong["mistakes"][-1]["file"], "wrong.yaml")
        self.assertTrue(wrong["mistakes"][-1]["message"].startswith('unknown key "asigner"'))
        self.assertRegex(sound["warnings"].pop()["message"], NO_ROLE)
        self.assertEqual(sound, {"file": "small.yaml", "kind": "team", "sound": True, "mistakes": [],
                                 "mistakes_left_out": 0, "warnings": []})

    def test_check_does_not_flood_the_terminal(self):
        self.write("rules.yaml", "rules: many\n" + "".join(f"key_{i}: 1\n" for i in range(250)))
        done = self.run_program("config", "check", "rules.yaml")
        lines = done.stderr.splitlines()
        self.assertEqual((done.returncode, len(lines)), (2, 101))
        self.assertTrue(lines[99].startswith("regista: rules.yaml:101:1: unknown key"), lines[99])
        self.assertEqual(lines[100], "regista: rules.yaml: ... and 150 more")
        done = self.run_program("config", "check", "rules.yaml", "--json")
        self.assertEqual(len(json.loads(done.stdout)["documents"][0]["mistakes"]), 250)

    def test_a_role_for_a_robot_that_no_team_has(self):
        self.write("team.yaml", program.TEAM.format(name="team").replace("robot: 1,", "robot: 6,"))
        self.succeed("config", "check", "team.yaml")
        self.write("five.yaml", "rules: five\nteam_size: 5\n")
        line = ("team.yaml:13:33: roles.playing.0.robot: the role goalkeeper is for robot 6, a team has 5 robots by the "
                "rules five")
        self.assertEqual(self.refused("config", "check", "team.yaml", "--rules", "five.yaml"), line)
        self.assertEqual(self.refused("match", "team.yaml", "small.yaml", "--rules", "five.yaml", "--limit", "1"), line)
        self.assertEqual(self.refused("tournament", "--team", "team.yaml", "--team", "small.yaml", "--rules", "five.yaml",
                                      "--pairs", "1", "--results", "results.db"), line)

    def test_robots_that_will_stand(self):
        kept = program.TEAM.format(name="few").splitlines(keepends=True)
        self.write("few.yaml", "".join(each for each in kept if "name: front" not in each and "name: left" not in each))
        warning = ("few.yaml:12:3: warning: roles.playing: roles for 5 of 7 robots in context playing: 2 robots will "
                   "stand")
        done = self.run_program("config", "check", "few.yaml")
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (0, "few.yaml: team, sound\n", f"regista: {warning}\n"))
        done = self.run_program("match", "few.yaml", "few.yaml", "--limit", "1", "--quiet")
        self.assertEqual(done.returncode, 0)
        self.assertEqual(done.stderr.splitlines().count(f"regista: {warning}"), 1)
        self.write("five.yaml", "rules: five\nteam_size: 5\n")
        self.assertEqual(self.run_program("config", "check", "few.yaml", "--rules", "five.yaml").stderr, "")
        found = json.loads(self.succeed("config", "check", "few.yaml", "--json"))["documents"][0]
        self.assertEqual([(each["line"], each["column"]) for each in found["warnings"]], [(12, 3), (8, 5)])  # and NO_ROLE
        self.assertTrue(found["sound"])

    def test_what_is_hardly_meant(self):
        """A list that no context plays, one robot for two roles, a target off the field: `match` warns as well."""
        page = program.TEAM.format(name="odd").replace("name: left,", "name: left, robot: 1,")
        self.write("odd.yaml", page.replace("utility:", "  spare:\n    - {name: only, target: {at: ball}}\nutility:"))
        done = self.run_program("config", "check", "odd.yaml")
        self.assertEqual((done.returncode, done.stdout), (0, "odd.yaml: team, sound\n"))
        self.assertIn("goalkeeper and left are both for robot 1, which takes one role at a time\n", done.stderr)
        self.assertIn("roles.spare: no context plays this list: add use: {roles: spare} to one\n", done.stderr)
        played = self.run_program("match", "odd.yaml", "odd.yaml", "--limit", "1", "--quiet")
        self.assertEqual(played.stderr, done.stderr)
        self.assertIn("is off the field, which with its border reaches", self.run_program(
            "match", "small.yaml", "small.yaml", "--limit", "1", "--quiet",
            "--set", "a.roles.playing.striker.target={at: [-42, 0]}").stderr)

    def test_utilities_that_cannot_be_tried(self):
        for name, folder, why in (
                ("scores_nan", "bad_values", r"plugin scores_nan \(.*\) of team bad, robot 7.*: score: .*"),
                ("dies_scoring", "deaths", r"Aborted, in .*deaths\.so, in score of plugin dies_scoring"
                                           if not program.SANITIZED else ".*")):
            self.write("bad.yaml", program.TEAM.format(name="bad").replace(
                "{plugin: nearness, weight: 1, params: {scale: 2}}", f"{{plugin: {name}}}"))
            done = self.run_program("config", "check", "bad.yaml", "--plugins", program.TEST_PLUGINS / folder)
            self.assertEqual((done.returncode, done.stdout), (0, "bad.yaml: team, sound\n"))
            self.assertRegex(done.stderr, rf"(?m)^regista: bad\.yaml:1:1: warning: utility: its terms could not be tried on "
                                          rf"scenes: {why}\n\Z")

    def test_contexts_that_cannot_be_tried(self):
        self.write("bad.yaml", program.TEAM.format(name="bad").replace("ball_seen", "aborts"))
        done = self.run_program("config", "check", "bad.yaml", "--plugins", program.TEST_PLUGINS / "deaths")
        self.assertEqual((done.returncode, done.stdout), (0, "bad.yaml: team, sound\n"))
        why = r"Aborted, in .*deaths\.so, in holds of plugin aborts" if not program.SANITIZED else ".*"
        self.assertRegex(done.stderr, rf"(?m)^regista: bad\.yaml:1:1: warning: contexts: could not be tried on scenes: {why}\n\Z")

    def test_shipped_documents_are_sound_without_warnings(self):
        for kind in ("rules", "robots", "disturbances", "openings"):
            files = sorted((program.SOURCE / "configs" / kind).glob("*.yaml"))
            said = self.run_program("config", "check", *files).stderr.splitlines()
            self.assertEqual([line for line in said if "hsl2026.yaml:2:1: warning: a sketch: " not in line], [])

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


class PluginThatRefusesItsFile(program.Case):
    plugins = (*program.Case.plugins, program.TEST_PLUGINS.parent / "plugins" / "delaunay_formation.so")

    def test_its_use_is_named(self):
        uses = "positioner: {plugin: delaunay_formation, params: {file: f.conf}}"
        base = program.TEAM.format(name="base").replace("positioner: {plugin: at_the_ball}", uses)
        line = base[:base.index(uses)].count("\n") + 1
        self.write("base.yaml", base)
        self.write("team.yaml", "extends: base.yaml\nteam: team\n")
        self.write("f.conf", '{"method": "Static", "data": [],\n "data": []}')
        end = rf"create: formation: line 2, column 2: \"data\" is given twice; file: {self.folder}/f\.conf"
        for file in ("base.yaml", "team.yaml"):
            told = self.refused("config", "check", file)
            self.assertRegex(told, rf"^base\.yaml:{line}:13: plugin delaunay_formation \([^)]+\) of team \w+, robot 1, "
                                   rf"tick 0: {end}$")
            done = self.run_program("config", "check", file, "--json")
            mistake, = json.loads(done.stdout)["documents"][0]["mistakes"]
            self.assertEqual((mistake["file"], mistake["line"], mistake["column"]), ("base.yaml", line, 13))
            self.assertRegex(mistake["message"], rf"^plugin delaunay_formation .*{end}$")


if __name__ == "__main__":
    unittest.main()
