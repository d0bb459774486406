# SPDX-License-Identifier: MIT
"""Each element of the paper does what docs/fidelity.md claims: without it a measure rises or falls. scripts/prove paper finds
the directions with 20 pairs of matches; here each arm plays few short ones, so only nearly all directions must come out."""

import json
import pathlib
import re
import sys
import unittest

import program

sys.path.append(str(pathlib.Path(__file__).parents[1] / "prove"))
import paper

STUDY = program.SOURCE / "configs" / "studies" / "paper_elements.yaml"
PAGE = (program.SOURCE / "docs" / "fidelity.md").read_text()


class Fidelity(program.ShippedCase):
    @unittest.skipIf(program.SANITIZED, "plays many matches, of which short ones lack set plays")
    def test_nearly_all_directions_come_out(self):
        played = self.run_program("experiment", STUDY, "--matches", "4", "--limit", "240", "--json", "--no-page")
        self.assertEqual(played.returncode, 0, played.stderr)  # it may warn: a list of roles that nobody plays any more
        study = json.loads(played.stdout)
        claims = [(name, measure, direction) for name, _, measure, direction in paper.elements(program.SOURCE) if measure]
        self.assertGreater(len(claims), 18)
        wrong = [name for name, measure, direction in claims
                 if (paper.differences(study, measure)[name][0] > 0) != (direction == "rises")]
        self.assertLessEqual(len(wrong), 3, wrong)  # by chance alone half of them would be

    def test_the_study_switches_off_what_the_page_names(self):
        arms = dict(re.findall(r"- \{name: \"?(.+?)\"?, set: \{(.+)\}\}", STUDY.read_text()))
        of_page = {name: off.replace("=", ": ") for name, off, _, _ in paper.elements(program.SOURCE)
                   if not off.startswith("test ")}
        self.assertEqual(arms, of_page)

    def test_named_tests_are_there(self):
        sources = "".join(file.read_text() for file in (program.SOURCE / "tests" / "unit" / "mind").glob("*.cpp"))
        for element, off, _, _ in paper.elements(program.SOURCE):
            if named := re.fullmatch(r"test (\w+)\.(\w+)", off):
                self.assertRegex(sources, rf"TEST(_F)?\({named[1]}, {named[2]}\)", element)

    def test_named_files_are_there(self):
        symbols = PAGE.split("## The twelve symbols")[1].split("## The elements")[0]
        rows = [line for line in symbols.splitlines() if line.startswith("| `")]
        self.assertEqual(len(rows), 12)
        files = re.findall(r"`((?:host|plugins)/[\w/.]+)`", symbols)
        self.assertGreaterEqual(len(files), 12)
        for file in files:
            self.assertTrue((program.SOURCE / file).exists(), file)


if __name__ == "__main__":
    unittest.main()
