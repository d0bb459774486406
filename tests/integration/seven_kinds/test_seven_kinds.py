# SPDX-License-Identifier: MIT
"""A plugin of each of the seven kinds, in C and in C++, built by gcc and, with -O3 -march=native, by clang against an
installed SDK: all of them play in one match."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["REGISTA_BUILD"])
SOURCE = pathlib.Path(os.environ["REGISTA_SOURCE"])
PROGRAM = os.environ["REGISTA_PROGRAM"]
CMAKE = os.environ["REGISTA_CMAKE"]
PROJECT = pathlib.Path(__file__).parent / "project"
KINDS = ("predictor", "context", "positioner", "utility", "assigner", "behaviour", "sender")
COMPILERS = {"gcc": ("gcc", "g++", ""), "clang": ("clang", "clang++", "-O3 -march=native")}

TEAM = """\
team: {team}
predictors:
  self:      {{plugin: {predictor}}}
  ball:      {{plugin: {predictor}}}
  opponents: {{plugin: {predictor}}}
  teammates: {{plugin: {predictor}}}
contexts: [{{name: playing, plugin: {context}}}]
positioner: {{plugin: {positioner}}}
utility: {{terms: {{near: {{plugin: {utility}}}}}}}
assigner: {{plugin: {assigner}}}
sender: {{plugin: {sender}}}
behaviour_without_role: {behaviour}
roles:
  playing:
    - {{name: keeper, robot: 1, behaviour: {behaviour}, target: {{at: own_goal, shift: [0.4, 0]}}}}
    - {{name: striker, required: true, behaviour: {behaviour}, target: {{at: ball}}}}
    - {{name: left, behaviour: {behaviour}, target: {{at: [0, 2]}}}}
    - {{name: right, behaviour: {behaviour}, target: {{at: [0, -2]}}}}
    - {{name: back, behaviour: {behaviour}, target: {{at: [-3, 0]}}}}
    - {{name: front, behaviour: {behaviour}, target: {{at: [2, 0]}}}}
    - {{name: middle, behaviour: {behaviour}, target: {{at: [-1, 0]}}}}
"""


class SevenKinds(unittest.TestCase):
    def run_program(self, *arguments):
        done = subprocess.run([str(each) for each in arguments], cwd=self.folder, capture_output=True, text=True,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="regista-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.run_program(CMAKE, "--install", BUILD, "--prefix", "prefix", "--component", "sdk")
        self.plugins = []
        for name, (c_compiler, cxx_compiler, flags) in COMPILERS.items():
            self.run_program(CMAKE, "-S", PROJECT, "-B", name, "-D", "CMAKE_BUILD_TYPE=Release", "-D",
                             f"CMAKE_PREFIX_PATH={self.folder / 'prefix'}", "-D", f"CMAKE_C_COMPILER={c_compiler}",
                             "-D", f"CMAKE_CXX_COMPILER={cxx_compiler}", "-D", f"CMAKE_C_FLAGS={flags}", "-D",
                             f"CMAKE_CXX_FLAGS={flags}", "-D", f"BUILT_AS={name}")
            self.run_program(CMAKE, "--build", name)
            self.plugins += ["--plugins", self.folder / name / "plugins"]

    def team(self, name, builds):
        """NAME.yaml: its plugins come from the builds in turn."""
        ids = {kind: f"{builds[i % len(builds)]}_{kind}" for i, kind in enumerate(KINDS)}
        (self.folder / f"{name}.yaml").write_text(TEAM.format(team=name, **ids), encoding="utf-8")

    def test_all_of_them_play_in_one_match(self):
        listed = self.run_program(PROGRAM, "plugin", "list", *self.plugins)
        for build in ("gcc_c", "gcc_cpp", "clang_c", "clang_cpp"):
            for kind in KINDS:
                self.assertRegex(listed, rf"(?m)^{kind} +{build}_{kind} ")
        # All 28: the match's teams mix builds, so that each kind of each language is there by one compiler or the
        # other, and the second match has the rest.
        first, second = (("gcc_c", "clang_c"), ("gcc_cpp", "clang_cpp")), (("clang_cpp", "gcc_cpp"), ("clang_c", "gcc_c"))
        for home, away in (first, second):
            self.team("home", home)
            self.team("away", away)
            told = json.loads(self.run_program(PROGRAM, "match", "home.yaml", "away.yaml", "--seed", 3, "--limit", 300,
                                               "--json", *self.plugins))
            self.assertEqual(told["failures"], [])
            self.assertTrue(all(sent > 300 for sent in told["packets"]), told["packets"])
            for reasons in told["packets_by_reason"]:
                self.assertGreater(reasons["two_seconds"], 300)
            self.assertGreater(sum(told["kicks"]), 0)
            for side in told["robot_distance_metres"]:
                self.assertTrue(all(metres > 0.1 for metres in side), side)


if __name__ == "__main__":
    unittest.main()
