# SPDX-License-Identifier: MIT
"""A plugin of each kind as `regista plugin new` makes it, in C++ by g++ and in C by clang, against an installation of
program and SDK: each builds, passes its unit test, its team is sound and plays, and a plugin in C plays as that in C++
does, bit for bit. A team of the seven in C++ plays a match against a team of the seven in C.

MADE_CXX and MADE_C name other compilers. MADE_KINDS names kinds that alone are made: then no match is played.
"""

import json
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import time
import unittest

BUILD = pathlib.Path(os.environ["REGISTA_BUILD"])
CMAKE, CTEST = os.environ["REGISTA_CMAKE"], os.environ["REGISTA_CTEST"]
ALL_KINDS = ("predictor", "context", "positioner", "utility", "assigner", "behaviour", "sender")
KINDS = tuple(os.environ.get("MADE_KINDS", "").split()) or ALL_KINDS
# By language: what CMake calls it, and the compiler.
LANGUAGES = {"c++": ("CXX", os.environ.get("MADE_CXX", "g++")), "c": ("C", os.environ.get("MADE_C", "clang"))}

# What a unit test of a plugin may take to be compiled and linked, in seconds of the processor.
COMPILED_WITHIN = 6.0

MATCH = ("--seed", 1, "--limit", 30, "--set", "rules.durations.ready=3", "--set", "rules.durations.set=1")

# All plugins of a language are built as one project: CMake looks at a compiler once and not seven times.
PROJECT = """\
cmake_minimum_required(VERSION 3.25)
project(made LANGUAGES {language})
enable_testing()
foreach(kind {kinds})
  add_subdirectory(${{kind}})
endforeach()
"""


class MadePlugins(unittest.TestCase):
    def run_program(self, *arguments):
        """Standard output of what must succeed, without a word on standard error if it is ours."""
        began = time.monotonic()
        environment = {key: value for key, value in os.environ.items() if not key.startswith("REGISTA_")}
        done = subprocess.run([str(each) for each in arguments], cwd=self.folder, env=environment, capture_output=True,
                              text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        if arguments[0] == self.program:
            self.assertEqual(done.stderr, "", arguments)
        print(f"{time.monotonic() - began:5.1f} s: {pathlib.Path(arguments[0]).name} {' '.join(map(str, arguments[1:4]))}",
              flush=True)
        return done.stdout

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="regista-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name).resolve()
        self.program = self.folder / "prefix" / "bin" / "regista"
        for component in ("program", "sdk"):
            self.run_program(CMAKE, "--install", BUILD, "--prefix", "prefix", "--component", component)

    def make(self, language):
        """The project with the seven plugins of a language; the options that name their folders."""
        called, compiler = LANGUAGES[language]
        project = self.folder / called
        project.mkdir()
        for kind in KINDS:
            self.run_program(self.program, "plugin", "new", kind, f"{kind}_by_{called.lower()}", "--lang", language, "-o",
                             project)
            (project / f"{kind}_by_{called.lower()}").rename(project / kind)
        (project / "CMakeLists.txt").write_text(PROJECT.format(language=called, kinds=" ".join(KINDS)))
        build = project / "build"
        # Warnings of what is made would be the first that its author sees.
        self.run_program(CMAKE, "-S", project, "-B", build, "-G", "Ninja", "-D", f"CMAKE_{called}_COMPILER={compiler}", "-D",
                         f"CMAKE_{called}_FLAGS=-Wall -Wextra -Wpedantic -Werror")
        self.run_program(CMAKE, "--build", build, "-j2")
        tested = self.run_program(CTEST, "--test-dir", build, "--no-tests=error")
        self.assertIn(f"100% tests passed, 0 tests failed out of {2 * len(KINDS)}", tested)
        self.measure_a_unit_test(project, called)
        plugins = [word for kind in KINDS for word in ("--plugins", build / kind)]
        for kind in KINDS:
            team = project / kind / "team.yaml"
            self.assertEqual(self.run_program(self.program, "config", "check", team, *plugins), f"{team}: team, sound\n")
        return plugins

    def measure_a_unit_test(self, project, called):
        """All that it needs has been built, and it is new."""
        (source,) = (project / KINDS[0]).glob("test.*")
        later = time.time() + 2.0
        os.utime(source, (later, later))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        built = self.run_program(CMAKE, "-E", "env", "CCACHE_DISABLE=1", CMAKE, "--build", project / "build", "--target",
                                 f"unit_{KINDS[0]}_by_{called.lower()}")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertIn("Building", built)
        self.assertLess(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, COMPILED_WITHIN)

    def team(self, language):
        """A team with all seven: what their teams say beside what it is that they extend."""
        called = LANGUAGES[language][0]
        texts = [(self.folder / called / kind / "team.yaml").read_text() for kind in KINDS]
        extends = set(re.findall(r"(?m)^extends: .*\n", "".join(texts)))
        self.assertEqual(len(extends), 1)
        parts = [re.sub(r"(?m)^(#|extends:|team:).*\n", "", text) for text in texts]
        file = self.folder / f"{called}.yaml"
        file.write_text("".join([*extends, f"team: in_{called.lower()}\n", *parts]))
        return file

    def play(self, home, away, plugins):
        told = json.loads(self.run_program(self.program, "match", home, away, *plugins, *MATCH, "--json"))
        self.assertEqual(told["failures"], [])
        return told

    @unittest.skipIf(KINDS == ALL_KINDS, "those that play are built, too")
    def test_some_of_them_build(self):
        for language in LANGUAGES:
            self.make(language)

    @unittest.skipUnless(KINDS == ALL_KINDS, "a team needs all of them")
    def test_all_of_them_play(self):
        plugins = [word for language in LANGUAGES for word in self.make(language)]
        told = self.play(*(self.team(language) for language in LANGUAGES), plugins)
        self.assertTrue(all(sent > 0 for sent in told["packets"]), told["packets"])
        for side in told["robot_distance_metres"]:
            self.assertTrue(all(metres > 0.1 for metres in side), side)
        # What both languages say is the same, and it is not what the shipped team does.
        paper = self.folder / "prefix" / "share" / "regista" / "configs" / "teams" / "paper.yaml"
        undisturbed = self.play(paper, paper, plugins)["state_hash"]
        for kind in KINDS:
            in_cpp, in_c = (self.play(self.folder / called / kind / "team.yaml", paper, plugins)["state_hash"]
                            for called, _ in LANGUAGES.values())
            self.assertEqual(in_cpp, in_c, kind)
            self.assertNotEqual(in_cpp, undisturbed, kind)


if __name__ == "__main__":
    unittest.main()
