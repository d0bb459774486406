# SPDX-License-Identifier: MIT
"""What shells complete, asked of the shells themselves."""

import os
import pty
import re
import select
import shutil
import subprocess
import time
import unittest

import program


class Completion(program.Case):
    def setUp(self):
        super().setUp()
        (self.folder / "scenes").mkdir()
        for name in ("b team.yaml", "notes.txt", "t.db"):
            self.write(name, "")

    def script(self, shell):
        done = self.run_program("completion", shell)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout

    def bash(self, *words):
        """What bash would offer for the last of these words."""
        self.write("completion.bash", self.script("bash"))
        quoted = " ".join(f"'{word}'" for word in words)
        done = subprocess.run(
            ["bash", "--norc", "-c", f"source completion.bash; COMP_WORDS=(regista {quoted}); "
             f"COMP_CWORD={len(words)}; _regista 2> /dev/null; printf '%s\\n' \"${{COMPREPLY[@]}}\""],
            cwd=self.folder, text=True, capture_output=True, check=True)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split("\n")) - {""}

    def test_bash_knows_commands_options_choices_and_files(self):
        self.assertTrue({"match", "tournament", "help"} <= self.bash(""))
        self.assertNotIn("play-one", self.bash(""))
        self.assertEqual(self.bash("plugin", ""), {"list", "info", "new", "check", "reference"})
        self.assertEqual(self.bash("plugin", "new", "p"), {"predictor", "positioner"})
        self.assertEqual(self.bash("plugin", "new", "sender", "x", "-o", "s"), {"scenes"})
        self.assertEqual(self.bash("help", "plugin", "l"), {"list"})
        self.assertEqual(self.bash("match", "--home"), {"--home-disturbance"})
        self.assertEqual(self.bash("tournament", "--format", ""), {"round_robin", "gauntlet", "swiss", "knock_out"})
        self.assertEqual(self.bash("config", "schema", "t"), {"team", "tournament", "tuning"})
        self.assertEqual(self.bash("match", "b t"), {"b team.yaml"})
        self.assertTrue({"b team.yaml", "small.yaml", "scenes"} <= self.bash("match", ""))
        self.assertFalse({"notes.txt", "t.db"} & self.bash("match", ""))
        self.assertEqual(self.bash("report", "t"), {"t.db"})
        self.assertEqual(self.bash("match", "--seed", ""), set())
        self.assertEqual(self.bash("tournament", "--plugins", "s"), {"scenes"})

    def test_bash_completes_every_option_of_every_command(self):
        for command in ("match", "tournament", "experiment", "tune", "report", "config check"):
            help_page = self.run_program("help", *command.split()).stdout
            options = set(re.findall(r"^  (?:-\w, )?(--[a-z-]+)", help_page, re.MULTILINE))
            self.assertGreater(len(options), 3)
            self.assertEqual(self.bash(*command.split(), "--"), options - {"-h"} | {"--help"})

    @unittest.skipIf(shutil.which("zsh") is None, "zsh is not installed")
    def test_zsh(self):
        functions = self.folder / "functions"
        functions.mkdir()
        (functions / "_regista").write_text(self.script("zsh"))
        process, terminal = pty.fork()
        if process == 0:
            os.chdir(self.folder)
            os.environ.update(TERM="dumb", PS1="> ", HOME=str(self.folder))
            os.execvp("zsh", ["zsh", "-f", "-i"])
        try:
            def until(pattern):
                text, end = "", time.monotonic() + 30
                while not re.search(pattern, text):
                    self.assertLess(time.monotonic(), end, text)
                    if select.select([terminal], [], [], 0.2)[0]:
                        text += os.read(terminal, 65536).decode(errors="replace")
                return text

            def typed(words):
                os.write(terminal, words.encode())

            until("> ")
            typed(f"fpath=({functions} $fpath); autoload -U compinit; compinit -u -D; unsetopt beep; print rea''dy\n")
            until(r"ready\s")
            for words, completed in (("regista tourn\t", "tournament "), ("regista plugin ref\t", "reference "),
                                     ("regista match --home-d\t", "--home-disturbance "),
                                     ("regista tournament --format rou\t", "round_robin "),
                                     ("regista config schema tu\t", "tuning "), ("regista report t\t", "t.db"),
                                     ("regista match b\\ t\t", r"b\\ team.yaml"),
                                     ("regista help conf\t", "config ")):
                typed(words)
                until(re.escape(completed) if "\\" not in completed else completed)
                typed("\x15")
        finally:
            os.close(terminal)
            os.waitpid(process, 0)

    @unittest.skipIf(shutil.which("fish") is None, "fish is not installed")
    def test_fish(self):
        self.write("completion.fish", self.script("fish"))
        environment = {**os.environ, "HOME": str(self.folder), "XDG_CONFIG_HOME": str(self.folder)}

        def fish(words):
            done = subprocess.run(["fish", "--private", "--no-config", "-c", "source completion.fish; complete -C $argv[1]", words],
                                  cwd=self.folder, env=environment, text=True, capture_output=True, check=True)
            self.assertEqual(done.stderr, "")
            return {line.split("\t")[0] for line in done.stdout.splitlines()}

        self.assertTrue({"match", "tournament", "help"} <= fish("regista "))
        self.assertNotIn("play-one", fish("regista "))
        self.assertEqual(fish("regista plugin "), {"list", "info", "new", "check", "reference"})
        self.assertEqual(fish("regista plugin new p"), {"predictor", "positioner"})
        self.assertEqual(fish("regista help plugin l"), {"list"})
        self.assertEqual(fish("regista match --home"), {"--home-disturbance"})
        self.assertEqual(fish("regista tournament --format "), {"round_robin", "gauntlet", "swiss", "knock_out"})
        self.assertEqual(fish("regista report t"), {"t.db"})
        self.assertEqual(fish("regista match b"), {"b team.yaml", "bin/"})
        self.assertEqual(fish("regista match --seed "), set())
        self.assertEqual(fish("regista tournament --plugins s"), {"scenes/"})

    def test_shells_that_are_not_known(self):
        for words, line in ((("tcsh",), 'unknown shell "tcsh"; nearest: "bash"; known: bash, zsh, fish'),
                            ((), "which shell? There are: bash, zsh, fish")):
            done = self.run_program("completion", *words)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (2, "", f"regista: completion: {line}\n"))


if __name__ == "__main__":
    unittest.main()
