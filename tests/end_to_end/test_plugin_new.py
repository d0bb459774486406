# SPDX-License-Identifier: MIT
"""`regista plugin new`: the folder of a new plugin. That what it makes builds and plays: tests/integration/made_plugins."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import program

KINDS = ("predictor", "context", "positioner", "utility", "assigner", "behaviour", "sender")
FILES = {"c++": {"algorithm.hpp", "plugin.cpp", "test.cpp"}, "c": {"plugin.c", "test.c"}}
NOBODY = 65534
SHARED = {"CMakeLists.txt", "README.md", "team.yaml"}


class New(program.Case):
    def setUp(self):
        super().setUp()
        share = self.folder / "share" / "regista"
        share.mkdir(parents=True)
        shutil.copytree(program.SOURCE / "configs", share / "configs")
        shutil.copytree(program.SOURCE / "sdk" / "templates", share / "templates")
        package = self.folder / "lib" / "cmake" / "regista"
        package.mkdir(parents=True)
        (package / "regista-config.cmake").touch()
        self.work = self.folder / "work"
        self.work.mkdir()

    def new(self, *words, **options):
        return self.succeed("plugin", "new", *words, "-o", "work", **options)

    def refused_new(self, *words, **options):
        before = sorted(self.folder.rglob("*"))
        line = self.refused("plugin", "new", *words, **options)
        self.assertEqual(sorted(self.folder.rglob("*")), before)
        self.assertTrue(line.startswith("plugin new: ") or line.startswith("cannot make ") or "exists already" in line or
                        line.startswith("cannot write "), line)
        return line

    def test_every_kind_in_every_language(self):
        for kind in KINDS:
            for language, sources in FILES.items():
                name = f"my_{kind}_{len(language)}"
                said = self.new(kind, name, "--lang", language)
                made = self.work / name
                self.assertEqual({each.name for each in made.iterdir()}, SHARED | sources)
                texts = {each.name: each.read_text() for each in made.iterdir()}
                for file, text in texts.items():
                    self.assertNotRegex(text, r"@\w+@", file)
                    self.assertTrue(text.endswith("\n") and not text.endswith("\n\n"), file)
                plugin = texts["plugin.cpp" if language == "c++" else "plugin.c"]
                self.assertEqual(plugin.count(f'id = "{name}"'), 1)
                self.assertIn(f"project({name} LANGUAGES {'CXX' if language == 'c++' else 'C'})", texts["CMakeLists.txt"])
                self.assertIn(f'find_package(regista 0.2 REQUIRED HINTS "{self.folder}")', texts["CMakeLists.txt"])
                self.assertIn("plugin check $<TARGET_FILE:" + name, texts["CMakeLists.txt"])
                self.assertIn(f"extends: \"{self.folder}/share/regista/configs/teams/paper.yaml\"\n", texts["team.yaml"])
                self.assertRegex(texts["team.yaml"], rf"(plugin|behaviour): {name}\b")
                self.assertIn(f"of the kind {kind}", texts["README.md"])
                # What is printed are the commands of the README, after the way there.
                commands = re.search(r"```sh\n(.*?)```", texts["README.md"], re.S)[1].splitlines()
                self.assertEqual(len(commands), 3)
                self.assertEqual(said.split("\nnext:\n")[1].splitlines(),
                                 [f"  cd work/{name}", *(f"  {line}" for line in commands)])
                self.assertEqual(commands[2], f"regista match team.yaml {self.folder}/share/regista/configs/teams/paper.yaml "
                                              "--plugins build")
        self.assertEqual(len(list(self.work.iterdir())), 2 * len(KINDS))

    def test_cplusplus_unless_it_is_said(self):
        self.new("sender", "one")
        self.assertTrue((self.work / "one" / "plugin.cpp").exists())
        self.succeed("plugin", "new", "sender", "here")
        self.assertTrue((self.folder / "here" / "plugin.cpp").exists())

    def test_a_name_that_yaml_takes_for_nothing(self):
        self.new("assigner", "null")
        self.assertIn('assigner: {plugin: "null"}', (self.work / "null" / "team.yaml").read_text())

    def test_a_program_of_a_build_folder_has_no_sdk_beside_it(self):
        shutil.rmtree(self.folder / "lib" / "cmake")
        said = self.new("sender", "one")
        self.assertIn(f"  cmake --install {self.folder} --prefix ~/regista --component sdk\n"
                      "  cmake -B build -DCMAKE_PREFIX_PATH=$HOME/regista && cmake --build build\n", said)
        self.assertIn("find_package(regista 0.2 REQUIRED)", (self.work / "one" / "CMakeLists.txt").read_text())

    def test_a_program_in_a_strange_place(self):
        home = self.folder / "it's \"my\" $HOME"
        home.mkdir()
        for each in ("bin", "lib", "share"):
            shutil.copytree(self.folder / each, home / each, symlinks=True)
        self.program = home / "bin" / "regista"
        said = self.new("sender", "one")
        quoted = str(home).replace("'", "'\\''")
        self.assertIn(f"team.yaml '{quoted}/share/regista/configs/teams/paper.yaml' --plugins build", said)
        escaped = str(home).replace('"', '\\"')
        self.assertIn(f'HINTS "{escaped}")'.replace("$", "\\$"), (self.work / "one" / "CMakeLists.txt").read_text())
        self.succeed("config", "show", "work/one/team.yaml", "--set", "sender.plugin=every_second")

    def test_names(self):
        for name in ("My", "2x", "a b", "../x", "a/b", "/tmp/x", "é", "a\nb", "x" * 65, "test", "all", "install", "clean",
                     "help", "package"):
            self.refused_new("sender", name)
        self.refused_new("sender", "--", "-x")
        self.refused("plugin", "new", "sender", "")
        self.assertIn("-x", self.refused("plugin", "new", "sender", "-x"))
        self.assertEqual(self.refused_new("sender", "2x"),
                         'plugin new: the name "2x" is not lower_snake_case; a name begins with a letter and has lower-case '
                         "letters, digits and underscores")
        self.assertEqual(self.refused_new("sender", "nearness"),
                         f"plugin new: there is a plugin nearness already, in {self.plugin_folder}/contract_good.so; choose "
                         "another name")
        self.new("sender", "x" * 64)

    def test_kinds_and_languages(self):
        self.assertIn('unknown kind "assign"', self.refused_new("assign", "x"))
        self.assertEqual(self.refused_new("asigner", "x"),
                         'plugin new: unknown kind "asigner"; nearest: "assigner"; known: ' + ", ".join(KINDS))
        self.assertEqual(self.refused_new("sender", "x", "--lang", "rust"),
                         'plugin new: unknown language "rust"; known: c++, c')
        self.assertIn("which kind?", self.refused_new())
        self.assertIn("needs a name", self.refused_new("sender"))
        self.assertIn("third", self.refused("plugin", "new", "sender", "x", "third"))

    def test_nothing_is_written_over(self):
        self.write("mine/my_work.txt", "kept")
        self.write("file", "kept")
        (self.folder / "empty").mkdir()
        (self.folder / "nowhere").symlink_to("gone")
        for name in ("mine", "file", "empty", "nowhere"):
            self.assertEqual(self.refused_new("sender", name), f"{name} exists already")
        self.assertEqual((self.folder / "mine" / "my_work.txt").read_text(), "kept")

    def test_places_where_it_cannot_be(self):
        self.write("file", "")
        self.assertEqual(self.refused_new("sender", "x", "-o", "gone"), "cannot make gone/x: there is no folder gone")
        self.assertEqual(self.refused_new("sender", "x", "-o", "file"), "cannot make file/x: there is no folder file")

    def test_a_folder_that_may_not_be_written(self):
        """Rights of files do not bind the superuser: where that one runs the tests, the program is run by nobody."""
        who = {}
        if os.geteuid() == 0:
            self.folder.chmod(0o755)
            who = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        self.work.chmod(0o555)
        self.addCleanup(self.work.chmod, 0o755)
        self.assertEqual(self.refused_new("sender", "x", "-o", "work", **who), "cannot make work/x: Permission denied")

    def test_a_program_without_templates_says_so(self):
        shutil.rmtree(self.folder / "share" / "regista" / "templates")
        self.assertIn("share/regista/templates is missing", self.refused_new("sender", "x"))

    def test_a_broken_template_says_so(self):
        (self.folder / "share" / "regista" / "templates" / "sender" / "team.yaml").write_text("@PLUGINS@")
        self.assertIn('unknown placeholder "PLUGINS"; nearest: "PLUGIN"', self.refused("plugin", "new", "sender", "x"))
        self.assertFalse((self.folder / "x").exists())

    @unittest.skipUnless(os.geteuid() == 0, "only root can mount a disk")
    def test_a_full_disk(self):
        with tempfile.TemporaryDirectory() as place:
            mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", place], check=False,
                                     capture_output=True)
            if mounted.returncode != 0:
                self.skipTest("a disk cannot be mounted here")
            try:
                line = self.refused("plugin", "new", "predictor", "x", "-o", place, code=1)
                self.assertRegex(line, r"^cannot write .*/x/\S+: No space left on device$")
                self.assertEqual(list(pathlib.Path(place).iterdir()), [])
            finally:
                subprocess.run(["umount", place], check=True)

    def test_help(self):
        page = self.succeed("plugin", "new", "--help")
        for words in ("regista plugin new predictor my_ball", "--lang c++|c", "-o, --output FOLDER", *KINDS):
            self.assertIn(words, page)


if __name__ == "__main__":
    unittest.main()
