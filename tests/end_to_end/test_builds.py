# SPDX-License-Identifier: MIT
"""Plugins that are built by hand, without the flags of the SDK's CMake function: an old and a new build of one plugin,
each in a team of its own, play each their own code."""

import shutil
import subprocess
import unittest

import program
import tournament

COMPILERS = ("g++", "clang++")
PLUGIN = """
#include <regista/utility.hpp>
struct Mine {
  static constexpr auto id = "mine", version = "1.0.0", summary = "Likes tasks in some order";
  double factor = FACTOR;
  static constexpr std::tuple parameters{regista::real("factor", &Mine::factor, {-9.0, 9.0}, "1", "of a task's number")};
  void score(const regista::Frame&, regista::Utilities out) {
    for (std::size_t i = 0; i < out.rows(); ++i) {
      for (std::size_t j = 0; j < out.columns(); ++j) out(i, j) = 50.0 + FACTOR * static_cast<double>(i * j);
    }
  }
};
REGISTA_PLUGIN(Mine, regista::utility)
"""
# A table of all robots, as a template has it: one for the whole process, whichever file is used.
SHARES = """
template <class T> struct Table { static inline T taken[8] = {}; };
int taken_by(int robot) { return ++Table<int>::taken[robot]; }
"""


class Builds(tournament.Tournament):
    plugins = (*tournament.Tournament.plugins, program.TEST_PLUGINS.parent / "plugins" / "greedy.so")

    def build(self, compiler, name, factor, more="", flags=()):
        if shutil.which(compiler) is None:
            self.skipTest(f"{compiler} is not there")
        self.write(f"{name}.cpp", PLUGIN + more)
        subprocess.run([compiler, "-std=c++20", "-shared", "-fPIC", "-O1", f"-DFACTOR={factor}", *flags, "-I",
                        program.SOURCE / "sdk" / "include", f"{name}.cpp", "-o", f"{name}.so"], check=True,
                       cwd=self.folder)

    def team(self, name):
        text = program.TEAM.format(name=name)
        for sound, its in (("{plugin: nearness, weight: 1, params: {scale: 2}}",
                            f"{{plugin: mine, file: {name}.so, weight: 1}}"), ("first_free", "greedy")):
            self.assertIn(sound, text)
            text = text.replace(sound, its)
        self.write(f"{name}.yaml", text)

    def hash_of(self, home, away):
        said = self.succeed("match", f"{home}.yaml", f"{away}.yaml", "--limit", 60, "--seed", 3)
        return said.split("state hash")[1].split()[0]

    def test_each_team_plays_its_own_code(self):
        for compiler in COMPILERS:
            with self.subTest(compiler):
                self.build(compiler, "old", "1.0")
                self.build(compiler, "new", "-1.0")
                for name in ("old", "new"):
                    self.team(name)
                hashes = {pair: self.hash_of(*pair) for pair in
                          (("old", "old"), ("old", "new"), ("new", "old"), ("new", "new"))}
                self.assertEqual(len(set(hashes.values())), 4, hashes)
                report = self.succeed("tournament", "--team", "old.yaml", "--team", "new.yaml", "--pairs", 1, "--limit", 30,
                                      "--no-page", "--quiet", "--results", f"{compiler}.db")
                self.assertNotIn("decide alone", report)
                self.assertNotIn("reproducible", report)

    def test_a_variable_of_all_files_is_refused(self):
        self.build("g++", "shares", "1.0", SHARES)
        self.team("shares")
        line = self.refused("match", "shares.yaml", "shares.yaml", "--limit", 1)
        self.assertIn("shares a variable with every other build of it that is loaded: Table<int>::taken (STB_GNU_UNIQUE); "
                      "build it with -fvisibility=hidden, or -fno-gnu-unique", line)
        for flag in ("-fvisibility=hidden", "-fno-gnu-unique"):
            with self.subTest(flag):
                self.build("g++", "shares", "1.0", SHARES, [flag])
                self.succeed("match", "shares.yaml", "shares.yaml", "--limit", 1)


if __name__ == "__main__":
    unittest.main()
