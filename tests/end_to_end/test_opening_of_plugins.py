# SPDX-License-Identifier: MIT
"""Files in a plugin folder that do harm when they are opened: they are named, and every command works."""

import json
import time
import unittest

import program

# What is said of each. Where much else is to be done, a file that computes for ever has no two seconds in ten.
LATE = "could not be opened within 10 s"
REASONS = {
    "crash": "died when it was opened: Segmentation fault",
    "leave": "ended the process when it was opened (exit code 0)",
    "share_memory": "maps memory that processes share when it is opened",
    "sleep_on": "slept for 2 s when it was opened",
    "spin": "used more than 2 s of processor time when it was opened",
    "start_a_thread": "starts a thread when it is opened",
}
if program.SANITIZED:
    REASONS["crash"] = "ended the process when it was opened (exit code 1)"


def name_of(file):
    return file.rsplit("/", 1)[1].removesuffix(".so")


class OpeningOfPlugins(program.Case):
    def beside(self, *names):
        """Puts such files beside the sound ones."""
        for name in names:
            file = program.TEST_PLUGINS / f"when_opened_{name}" / f"{name}.so"
            self.assertTrue(file.exists(), f"{file} is not built")
            (self.plugin_folder / f"{name}.so").write_bytes(file.read_bytes())

    def refused_files(self):
        listed = json.loads(self.succeed("plugin", "list", "--json"))
        self.assertIn("last_news", [plugin["id"] for plugin in listed["plugins"]])
        return {name_of(each["file"]): each["reason"] for each in listed["refused"]}

    def test_each_is_named(self):
        for name, reason in REASONS.items():
            with self.subTest(name):
                self.beside(name)
                began = time.monotonic()
                try:
                    said = self.refused_files()
                finally:
                    (self.plugin_folder / f"{name}.so").unlink()
                if name == "spin" and said == {name: LATE}:
                    continue
                self.assertEqual(said, {name: reason})
                self.assertLess(time.monotonic() - began, 12)

    def test_a_child_that_is_killed_is_started_once_more(self):
        """Together with other files, by itself, and once more: a kill says nothing about the file."""
        self.beside("be_killed")
        for kills, refused in ((1, {}), (2, {}), (3, {"be_killed": "died when it was opened: Killed"})):
            (self.folder / "marks").unlink(missing_ok=True)
            listed = json.loads(self.succeed("plugin", "list", "--json", environment={"MOST_KILLS": str(kills)}))
            self.assertEqual({name_of(each["file"]): each["reason"] for each in listed["refused"]}, refused)
            self.assertEqual((self.folder / "marks").read_text(), kills * "killed\n")

    def test_every_command_works(self):
        """They stand before and after the sound ones in the order of names."""
        self.beside("crash", "leave", "start_a_thread")
        self.assertEqual(self.refused_files(), {name: REASONS[name] for name in ("crash", "leave", "start_a_thread")})
        played = self.run_program("match", "small.yaml", "small.yaml", "--limit", "5", "--quiet", "--json")
        self.assertEqual((played.returncode, played.stderr), (0, ""))
        self.assertEqual(self.run_program("config", "check", "small.yaml").returncode, 0)  # it is warned of
        for words in (("plugin", "info", "nearness"), ("plugin", "list"),
                      ("config", "show", "small.yaml"),
                      ("tournament", "--team", "small.yaml", "--team", "small.yaml", "--pairs", "1", "--limit", "5",
                       "--quiet", "--no-page")):
            with self.subTest(words):
                self.succeed(*words)

    def test_a_team_that_names_it(self):
        self.beside("crash")
        self.write("bad.yaml", program.TEAM.format(name="bad").replace("ball_seen", "crash"))
        line = self.refused("match", "bad.yaml", "small.yaml", "--limit", "5")
        self.assertIn('unknown context "crash"', line)
        self.assertIn(f"refused: {self.plugin_folder}/crash.so: {REASONS['crash']}", line)

    def test_arithmetic_that_is_changed_is_changed_back(self):
        for name, changed in (("flush_small_numbers", "how small numbers are treated (flush to zero)"),
                              ("round_upward", "the rounding mode")):
            with self.subTest(name):
                self.beside(name)
                remark = f"{self.plugin_folder}/{name}.so: changed {changed} when it was opened; that was undone\n"
                self.assertIn(f"remark: {remark}", self.succeed("plugin", "list"))
                # It plays for a team, and the match is that of a team whose plugins changed nothing.
                self.write("changes.yaml", program.TEAM.format(name="small").replace("ball_seen", name))
                self.write("sound.yaml", program.TEAM.format(name="small").replace("ball_seen", "nothing"))
                played = []
                for team in "changes.yaml", "sound.yaml":
                    done = self.run_program("match", team, "small.yaml", "--limit", "60", "--json", "--plugins",
                                            program.TEST_PLUGINS / "when_opened_nothing")
                    self.assertEqual((done.returncode, done.stderr), (0, f"regista: {remark}"))
                    played.append(json.loads(done.stdout)["state_hash"])
                self.assertEqual(*played)
                (self.plugin_folder / f"{name}.so").unlink()


if __name__ == "__main__":
    unittest.main()
