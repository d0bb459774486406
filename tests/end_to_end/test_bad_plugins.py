# SPDX-License-Identifier: MIT
"""Plugins that are wrong on purpose: refused when they are opened, or found out while a match is played. Whoever is to
blame is named: plugin, file, team, robot, tick, call and value."""

import shutil
import unittest

import program

# What a team says where a bad plugin takes the place of a sound one.
PLACES = {
    "assigner": ("assigner: {plugin: first_free}", "assigner: {{plugin: {}}}"),
    "positioner": ("positioner: {plugin: at_the_ball}", "positioner: {{plugin: {}}}"),
    "sender": ("sender: {plugin: every_second}", "sender: {{plugin: {}}}"),
    "context": ("plugin: ball_seen", "plugin: {}"),
    "utility": ("{plugin: nearness, weight: 1, params: {scale: 2}}", "{{plugin: {}, weight: 1}}"),
    "predictor": ("ball:      {plugin: last_news}", "ball:      {{plugin: {}}}"),
}


class BadPlugins(program.Case):
    def folder_of(self, name):
        folder = program.TEST_PLUGINS / name
        self.assertTrue((folder / f"{name}.so").exists(), f"{folder} is not built")
        return folder

    def play_with(self, kind, name, file=None):
        sound, bad = PLACES[kind]
        # Without a role that is one robot's own, so that no pair is forbidden.
        text = program.TEAM.format(name="broken").replace("robot: 1, ", "")
        self.assertIn(sound, text)
        self.write("broken.yaml", text.replace(sound, bad.format(name)))
        folder = self.folder_of(file or name)
        return self.refused("match", "small.yaml", "broken.yaml", "--limit", "60", "--plugins", folder)

    def blamed(self, kind, name, file=None):
        """What went wrong, after who did it. file: of the plugin, where its name is another."""
        file = file or name
        line = self.play_with(kind, name, file)
        who = rf"^plugin {name} \({self.folder_of(file)}/{file}\.so\) of team broken, robot [1-7], tick \d+: "
        self.assertRegex(line, who)
        return line.split(": ", 1)[1]

    def test_throws(self):
        for kind, call in (("assigner", "assign"), ("positioner", "place"), ("sender", "decide"),
                           ("context", "holds"), ("utility", "score")):
            self.assertEqual(self.blamed(kind, "throws"), f"{call}: fell in {call}")

    def test_a_predictor_throws(self):
        self.assertRegex(self.blamed("predictor", "throws"), r"^(predict|correct|tracks): fell in \1$")

    def test_no_number(self):
        self.assertEqual(self.blamed("utility", "scores_nan", "bad_values"), "score: row 1, column 0 is nan")
        self.assertEqual(self.blamed("positioner", "returns_nan"), "place: point 0 at (1, nan) is outside the field")
        self.assertEqual(self.blamed("predictor", "returns_nan"), "tracks: vx of label 0 is nan")

    def test_a_task_given_twice(self):
        # Rows are the robots that the blamed one knows to be active: fewer than seven at first.
        self.assertRegex(self.blamed("assigner", "assigns_twice"), r"^assign: column 2 given to rows 0 and [1-6]$")

    def test_index_out_of_range(self):
        line = self.blamed("assigner", "assigns_beyond", "bad_values")
        self.assertRegex(line, r"^assign: row 1 got column \d of \d$")
        column, columns = int(line.split()[5]), int(line.split()[7])
        self.assertEqual(column, columns + 2)

    def test_create_refuses(self):
        self.assertIn("returns_null", self.play_with("assigner", "returns_null"))

    def test_damaged_file_in_a_folder_that_was_asked_for(self):
        self.write("more/damaged.so", "not a shared object")
        done = self.run_program("match", "small.yaml", "small.yaml", "--limit", "5", "--quiet", "--plugins", "more")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"^regista: not used: more/damaged\.so: ")

    def test_another_interface(self):
        line = self.play_with("assigner", "wrong_major")
        self.assertIn(f"{self.folder_of('wrong_major')}/wrong_major.so: built for Regista plugin interface", line)

    def test_the_same_id_twice(self):
        for name in ("yesterday", "today"):
            (self.folder / name).mkdir()
            shutil.copy2(program.SOUND, self.folder / name)
        self.plugin_folder.joinpath(program.SOUND.name).unlink()
        line = self.refused("match", "small.yaml", "small.yaml", "--plugins", "yesterday", "--plugins", "today")
        build = r"\(1\.0\.0, [^)]+\)"
        self.assertRegex(line, r'^small\.yaml:3:\d+: plugin "last_news" exists 2 times: '
                               rf"yesterday/contract_good\.so {build}, today/contract_good\.so {build}; "
                               r"pin one by its file: \{plugin: last_news, file: yesterday/contract_good\.so\}$")
        for name in ("first_free", "nearness", "ball_seen", "at_the_ball", "every_second", "last_news"):
            pinned = f"plugin: {name}, file: yesterday/contract_good.so"
            text = (self.folder / "small.yaml").read_text()
            self.write("small.yaml", text.replace(f"plugin: {name}", pinned))
        folders = ("--plugins", "yesterday", "--plugins", "today")
        self.succeed("match", "small.yaml", "small.yaml", "--limit", "1", *folders)


if __name__ == "__main__":
    unittest.main()
