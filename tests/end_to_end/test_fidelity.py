# SPDX-License-Identifier: MIT
"""Each element of the paper does something in paper.yaml: without it the match is another one (docs/fidelity.md)."""

import json
import re
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"
PAGE = (program.SOURCE / "docs" / "fidelity.md").read_text()


def elements():
    """Pairs of an element and what the page says switches it off."""
    table = PAGE.split("<!-- elements -->")[1].strip().splitlines()[2:]
    for line in table:
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        yield cells[0], cells[-1]


class Fidelity(program.ShippedCase):
    def state_hash(self, *options):
        limit = "90" if program.SANITIZED else "300"
        played = self.run_program("match", TEAMS / "paper.yaml", TEAMS / "spqr2023.yaml", "--seed", "7", "--limit", limit,
                                  "--json", *options)  # it may warn: a list of roles that nobody plays any more
        self.assertEqual(played.returncode, 0, (options, played.stderr))
        return json.loads(played.stdout)["state_hash"]

    @unittest.skipIf(program.SANITIZED, "plays many matches, of which short ones lack set plays")
    def test_every_element_changes_the_match(self):
        with_all = self.state_hash()
        played = 0
        for element, off in elements():
            if off.startswith("test "):
                continue
            path = off.strip("`")
            if not path.startswith("rules."):
                path = "a." + path
            self.assertNotEqual(self.state_hash("--set", path), with_all, element)
            played += 1
        self.assertGreater(played, 20)

    def test_named_tests_are_there(self):
        sources = "".join(file.read_text() for file in (program.SOURCE / "tests" / "unit" / "mind").glob("*.cpp"))
        for element, off in elements():
            if named := re.fullmatch(r"test `(\w+)\.(\w+)`", off):
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
