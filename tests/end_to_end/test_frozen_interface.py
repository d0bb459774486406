# SPDX-License-Identifier: MIT
"""Plugins that were built against copies of abi.h: while the major version is 0, those of the present minor version
play, and those of older ones are refused with both versions named. abi.h cannot change without its number."""

import json
import pathlib
import re
import unittest

import program

COPIES = program.SOURCE / "tests" / "contract" / "frozen"
PRESENT = program.SOURCE / "sdk" / "include" / "regista" / "abi.h"
PLUGINS = program.TEST_PLUGINS / "frozen"


def code(header: pathlib.Path):
    """The text without comments and layout."""
    return re.sub(r"\s+", " ", re.sub(r"/\*.*?\*/", " ", header.read_text(), flags=re.S)).strip()


def version(header):
    return tuple(int(re.search(rf"#define REGISTA_ABI_{part} (\d+)u", header.read_text()).group(1))
                 for part in ("MAJOR", "MINOR"))


class FrozenInterface(program.Case):
    plugins = (program.SOUND, *program.BEHAVIOURS)

    def test_the_present_version_has_a_copy_and_is_as_it_was(self):
        copy = COPIES / "{}.{}".format(*version(PRESENT)) / "regista" / "abi.h"
        self.assertTrue(copy.exists(), f"{copy} is missing: a new version of the interface needs a copy of abi.h and a plugin")
        self.assertEqual(code(copy), code(PRESENT), "abi.h has changed, so its version must")

    def test_each_copy_plays_or_is_refused_by_its_version(self):
        copies = sorted(COPIES.glob("*/regista/abi.h"))
        self.assertTrue(copies)
        for copy in copies:
            built = version(copy)
            name = "frozen_{}_{}".format(*built)
            self.assertTrue((PLUGINS / f"{name}.so").exists(), name)
            with self.subTest(name):
                self.write("old.yaml", program.TEAM.format(name="old").replace("plugin: first_free", f"plugin: {name}"))
                match = ("match", "old.yaml", "small.yaml", "--limit", 60, "--quiet", "--json", "--plugins", PLUGINS,
                         *program.PLAY_SOON)
                if built != version(PRESENT):
                    self.assertEqual(built[0], 0, "from 1.0 on, this test must hold older versions to be played")
                    self.assertIn("built for Regista plugin interface {}.{}".format(*built), self.refused(*match))
                    continue
                played = json.loads(self.succeed(*match))
                self.assertEqual(played["ended"], "limit")
                self.assertGreater(played["segments_heard"][0], 0, "its messages arrive")
                self.assertGreater(sum(played["roles"][0]["striker"]["robot_seconds"]), 0.0, "its tasks are taken")


if __name__ == "__main__":
    unittest.main()
