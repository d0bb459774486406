# SPDX-License-Identifier: MIT
"""What is made from documents: copies of the shipped ones, pictures of roles, the reference."""

import filecmp
import json
import re
import shutil
import unittest
import xml.etree.ElementTree

import program

SVG = "{http://www.w3.org/2000/svg}"


class Copies(program.Case):
    def setUp(self):
        super().setUp()
        self.shipped = self.folder / "share" / "regista" / "configs"
        shutil.copytree(program.SOURCE / "configs", self.shipped)

    def test_all_documents_and_nothing_else(self):
        self.assertEqual(self.succeed("config", "copy", "mine"), "made the folder mine\n")
        compared = filecmp.dircmp(self.shipped, self.folder / "mine")
        while True:
            self.assertEqual((compared.left_only, compared.right_only, compared.diff_files), ([], [], []))
            if not compared.subdirs:
                break
            _, compared = compared.subdirs.popitem()
        self.assertEqual(self.succeed("config", "check", "mine/rules/spl2023.yaml"), "mine/rules/spl2023.yaml: rules, sound\n")

    def refused(self, *words):
        done = self.run_program("config", "copy", *words)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        return done.stderr

    def test_nothing_is_written_over(self):
        self.write("mine/teams/paper.yaml", "my work")
        self.assertEqual(self.refused("mine"), "regista: config copy: mine exists already; name another folder\n")
        self.assertEqual((self.folder / "mine/teams/paper.yaml").read_text(), "my work")
        (self.folder / "nowhere").symlink_to("gone")
        self.assertIn("exists already", self.refused("nowhere"))
        self.assertIn("cannot make a/b: No such file or directory", self.refused("a/b"))

    def test_a_program_without_documents_says_so(self):
        shutil.rmtree(self.shipped)
        self.assertIn("share/regista/configs is missing: this program was not installed as a whole", self.refused("mine"))


class Names(program.ShippedCase):
    """Shipped documents go by their names, wherever the program runs."""

    def setUp(self):
        super().setUp()
        self.shipped = self.folder / "share" / "regista" / "configs"
        shutil.copytree(program.SOURCE / "configs", self.shipped)

    def hash_of(self, *words):
        return json.loads(self.succeed("match", *words, "--limit", "20", "--json"))["state_hash"]

    def refused(self, *words):
        done = self.run_program(*words)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        return done.stderr

    def test_teams_rules_and_openings(self):
        teams = [self.shipped / "teams" / f"{name}.yaml" for name in ("paper", "fixed_rate")]
        by_path = self.hash_of(*teams, "--opening", self.shipped / "openings/corner_crowd_left.yaml")
        self.assertEqual(self.hash_of("paper", "fixed_rate", "--opening", "corner_crowd_left"), by_path)
        self.assertNotEqual(self.hash_of("paper", "fixed_rate"), by_path)
        self.write("mine.yaml", "extends: paper\nteam: mine\n")
        self.assertEqual(self.succeed("config", "check", "mine.yaml", "hulks"), "mine.yaml: team, sound\nhulks: team, sound\n")
        done = self.succeed("tournament", "--team", "paper", "--team", "mine.yaml", "--openings", "openings", "--pairs", "1",
                            "--limit", "1", "--results", "r.db", "--quiet")
        self.assertIn("mine", done)

    def test_a_file_of_the_user_comes_first(self):
        self.write("paper", "rules: paper\nfield: {length: 10}\n")
        self.assertEqual(self.succeed("config", "check", "paper"), "paper: rules, sound\n")

    def test_names_that_nothing_has(self):
        self.assertEqual(self.refused("config", "show", "papr"), 'regista: papr: no such file; nearest: "paper"\n')
        self.assertRegex(self.refused("config", "show", "qqqqqqqq"), "no such file; shipped teams: .*paper")
        self.write("mine.yaml", "extends: papr\nteam: mine\n")
        self.assertIn('no such file; nearest: "paper"', self.refused("config", "check", "mine.yaml"))
        self.assertIn("no such file; nearest: corner_crowd_left, corner_crowd_right\n",
                      self.refused("match", "paper", "paper", "--opening", "corner_crowd"))
        self.assertIn("this is an opening, and config draw draws a team",
                      self.refused("config", "draw", "corner_crowd_left", "-o", "scene.svg"))
        self.assertIn("there is no folder configs/teams; shipped documents go by their names: paper",
                      self.refused("config", "show", "configs/teams/paper.yaml"))

    def test_a_shipped_document_is_not_written_over(self):
        file = self.shipped / "teams/paper.yaml"
        before = file.read_bytes()
        self.assertIn("paper.yaml", self.refused("match", "paper", "fixed_rate", "--record", file, "--force"))
        self.assertEqual(file.read_bytes(), before)


class Differences(program.Case):
    def diff(self, *words):
        done = self.run_program("config", "diff", *words)
        self.assertEqual(done.stderr, "")
        return done.returncode, done.stdout

    def test_values_in_force(self):
        self.write("other.yaml", "extends: small.yaml\nteammates_forgotten_after: 11\n"
                                 "roles:\n  playing:\n    striker: {offset: false}\n")
        self.assertEqual(self.diff("small.yaml", "small.yaml"), (0, ""))
        status, text = self.diff("small.yaml", "other.yaml")
        self.assertEqual(status, 1)
        self.assertEqual(text.splitlines(), ["roles.playing.striker.offset: true | false", "teammates_forgotten_after: 25 | 11"])
        found = json.loads(self.diff("small.yaml", "other.yaml", "--json")[1])
        self.assertEqual(found[1], {"path": "teammates_forgotten_after", "first": "25", "second": "11"})
        # Each path is one that --set takes.
        for each in found:
            self.succeed("config", "show", "small.yaml", "--set", f"{each['path']}={each['second']}")

    def test_a_role_of_one_document_alone(self):
        self.write("fewer.yaml", "extends: small.yaml\nroles:\n  playing:\n    supporter: ~\n")
        status, text = self.diff("small.yaml", "fewer.yaml")
        self.assertEqual(status, 1)
        self.assertRegex(text, r"^roles\.playing\.supporter: \{name: supporter, .*\} \| -\n$")

    def test_documents_of_two_kinds(self):
        self.write("rules.yaml", "rules: mine\n")
        done = self.run_program("config", "diff", "small.yaml", "rules.yaml")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "regista: config diff: small.yaml is of the kind team, and rules.yaml is of the kind rules\n"))


class Drawings(program.Case):
    def texts(self, *words):
        picture = xml.etree.ElementTree.fromstring(self.succeed("config", "draw", "small.yaml", "-o", "-", *words))
        return [text.text for text in picture.iter(SVG + "text")], picture

    def test_roles_of_a_list(self):
        names, picture = self.texts("--ball", "1,0.5")
        self.assertEqual(sorted(names), ["back", "front", "goalkeeper", "left", "right",
                                         "small: roles of the list playing", "striker", "supporter"])
        self.assertEqual(len([each for each in picture.iter(SVG + "circle") if each.get("class") == "marker"]), 7)

    def test_a_context_draws_the_targets_that_it_changes(self):
        self.write("corner.yaml", "extends: small.yaml\ncontexts:\n  corner: {before: playing, priority: 9, plugin: set_play,\n"
                                  "    use: {targets: {supporter: {at: [2, 0], lateral: -1}}}}\n")
        places = {}
        for words in ((), ("--context", "corner")):
            picture = xml.etree.ElementTree.fromstring(self.succeed(
                "config", "draw", "corner.yaml", "-o", "-", "--role", "supporter", "--ball", "3,2", *words))
            marker, = [each for each in picture.iter(SVG + "circle") if each.get("class") == "marker"]
            ball, = [each for each in picture.iter(SVG + "circle") if each.get("class") == "ball"]
            places[words] = [float(marker.get(axis)) - float(ball.get(axis)) for axis in ("cx", "cy")]
            title = "small: roles of the context corner" if words else "small: roles of the list playing"
            self.assertIn(title, [text.text for text in picture.iter(SVG + "text")])
        metre = -places[()][0]  # a metre behind the ball
        for axis, difference in zip((0, 1), (-1.0, 1.0)):  # (2, 1) and the ball at (3, 2); y of a picture goes down
            self.assertAlmostEqual(places["--context", "corner"][axis], difference * metre, delta=0.2)

    def test_one_role_for_several_balls(self):
        names, picture = self.texts("--role", "supporter", "--ball=-1,2", "--ball", "3,0")
        self.assertEqual(sorted(names), ["1", "2", "ball 1", "ball 2", "small: roles of the list playing", "supporter"])
        markers = [each for each in picture.iter(SVG + "circle") if each.get("class") == "marker"]
        balls = [each for each in picture.iter(SVG + "circle") if each.get("class") == "ball"]
        # A metre behind the ball, whose picture has the centre of the field at the same place whatever is drawn.
        metre = (float(balls[1].get("cx")) - float(balls[0].get("cx"))) / 4.0
        for ball, marker in zip(balls, markers):
            self.assertAlmostEqual(float(ball.get("cx")) - float(marker.get("cx")), metre, delta=0.2)
            self.assertEqual(ball.get("cy"), marker.get("cy"))

    def test_what_is_refused(self):
        for words, line in (
                (("--role", "strikr"), '--role: unknown role "strikr" in playing; nearest: "striker"; known: '),
                (("--list", "serching"), '--list: unknown list of roles "serching"; known: playing'),
                (("--context", "playin"), '--context: unknown context "playin"; nearest: "playing"; known: playing'),
                (("--context", "playing", "--list", "playing"), "--context and --list: one of them"),
                (("--ball", "1,x"), '--ball 1,x: where the ball is.1: "x" is not a number'),
                (("--ball", "1"), "--ball 1: where the ball is: "),
                (("--ball", "0,0", "--no-ball"), "--no-ball and --ball: one of them"),
                (("-o", "small.yaml", "--force"), "--output small.yaml: is a file that this command reads")):
            done = self.run_program("config", "draw", "small.yaml", *(() if "-o" in words else ("-o", "x.svg")), *words)
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertTrue(done.stderr.startswith(f"regista: {line}"), done.stderr)
        self.assertFalse((self.folder / "x.svg").exists())

    def test_a_role_of_another_list_is_found_there(self):
        self.write("two.yaml", program.TEAM.format(name="two").replace(
            "utility:", "  siege:\n    - {name: outlet, target: {at: ball}}\nutility:"))
        done = self.run_program("config", "draw", "two.yaml", "--role", "outlet", "-o", "-")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "regista: --role: outlet is in the list siege, not in playing; add --list siege\n"))
        self.succeed("config", "draw", "two.yaml", "--role", "outlet", "--list", "siege", "-o", "-")

    def test_a_ball_off_the_field_is_drawn_with_a_warning(self):
        done = self.run_program("config", "draw", "small.yaml", "--ball", "10,1", "-o", "far.svg")
        self.assertEqual((done.returncode, done.stdout), (0, "far.svg\n"))
        self.assertEqual(done.stderr, "regista: warning: --ball 10,1: off the field, which with its border reaches from -5.2 "
                                      "to 5.2 m in x and from -3.7 to 3.7 m in y\n")

    def test_a_drawing_replaces_a_drawing_and_nothing_else(self):
        draw = ("config", "draw", "small.yaml", "-o", "x.svg")
        self.succeed(*draw)
        first = (self.folder / "x.svg").read_text()
        self.succeed(*draw, "--ball", "2,1")
        self.assertNotEqual((self.folder / "x.svg").read_text(), first)
        self.write("x.svg", "<svg/>")
        self.assertEqual(self.run_program(*draw).stderr,
                         "regista: --output x.svg: exists already; --force replaces it\n")
        self.succeed(*draw, "--force")
        self.assertEqual((self.folder / "x.svg").read_text(), first)

    def test_nothing_is_replaced_without_force(self):
        self.write("x.svg", "mine")
        self.assertEqual(self.run_program("config", "draw", "small.yaml", "-o", "x.svg").returncode, 2)
        self.assertEqual((self.folder / "x.svg").read_text(), "mine")


class Reference(program.Case):
    def test_the_page_of_this_repository_is_up_to_date(self):
        written = (program.SOURCE / "docs" / "config-reference.md").read_text()
        self.assertEqual(self.succeed("config", "reference"), written,
                         "write it anew: regista config reference > docs/config-reference.md")

    def test_every_reference_leads_somewhere(self):
        page = self.succeed("config", "reference")
        headings = set(re.findall(r"^### (\w+)$", page, re.MULTILINE))
        self.assertEqual(set(re.findall(r"\(#(\w+)\)", page)), headings)
        for text in re.findall(r"^### \w+\n\n(.*)$", page, re.MULTILINE):
            self.assertGreater(len(text), 15)

    def test_kinds(self):
        page = self.succeed("config", "reference", "robot", "opening")
        self.assertEqual(re.findall(r"^## (\w+)$", page, re.MULTILINE), ["robot", "opening"])
        done = self.run_program("config", "reference", "robots")
        self.assertEqual(done.stderr, 'regista: config reference: unknown kind of document "robots"; nearest: "robot"; '
                                      "known: rules, robot, disturbance, opening, team, predictor_study, tournament, experiment, "
                                      "tuning\n")


if __name__ == "__main__":
    unittest.main()
