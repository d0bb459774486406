# SPDX-License-Identifier: MIT
"""What must agree when a version is released, and the lists that the scripts hold."""

import os
import pathlib
import re
import subprocess
import unittest

import yaml

SOURCE = pathlib.Path(os.environ["REGISTA_SOURCE"])
PROGRAM = os.environ["REGISTA_PROGRAM"]
VERSION = os.environ["REGISTA_VERSION"]


def packages(name):
    lines = (SOURCE / "scripts" / f"packages-{name}.txt").read_text().splitlines()
    return [line.split("#")[0].strip() for line in lines if line.split("#")[0].strip()]


class Version(unittest.TestCase):
    def test_program_says_it(self):
        said = subprocess.run([PROGRAM, "--version"], check=True, capture_output=True, text=True).stdout
        self.assertTrue(said.startswith(f"regista {VERSION} ("), said)

    def test_changelog_has_an_entry(self):
        self.assertIn(f"\n## [{VERSION}]", (SOURCE / "CHANGELOG.md").read_text())

    def test_citation(self):
        """What version 1.2.0 of the format asks for, and what would be wrong without anybody noticing."""
        citation = yaml.safe_load((SOURCE / "CITATION.cff").read_text())
        self.assertEqual(citation["cff-version"], "1.2.0")
        self.assertEqual(citation["version"], VERSION)
        for work in [citation, *citation["references"]]:
            self.assertIsInstance(work["title"], str)
            self.assertTrue(work["authors"])
            for author in work["authors"]:
                self.assertIn(set(author) - {"orcid"}, ({"name"}, {"given-names", "family-names"}))
        self.assertIn("message", citation)
        self.assertEqual(citation["license"], "MIT")  # a list would mean that one may choose


class Lists(unittest.TestCase):
    def test_no_package_is_listed_twice(self):
        listed = packages("build") + packages("test") + packages("check")
        self.assertEqual(sorted(listed), sorted(set(listed)))

    def test_the_demo_first_builds_the_plugins_of_its_teams(self):
        listed = re.search(r"^first_plugins=\(([^)]*)\)", (SOURCE / "scripts" / "demo").read_text(), re.M)[1].split()
        named = set()
        for team in ("paper", "fixed_rate"):
            shown = subprocess.run([PROGRAM, "config", "show", SOURCE / "configs" / "teams" / f"{team}.yaml"],
                                   check=True, capture_output=True, text=True).stdout
            # A behaviour that the page says nothing of is the plugin of its name.
            named |= set(re.findall(r"\b(?:plugin|behaviour|behaviour_without_role): (\w+)", shown))
        self.assertEqual(sorted(listed), sorted(named))


if __name__ == "__main__":
    unittest.main()
