# SPDX-License-Identifier: MIT
"""A planted problem: the weights of a shipped team are spoilt, and the tuner has to find good ones again."""

import json
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"
SHIPPED = program.PROGRAM.parent.parent / "lib" / "regista" / "plugins"

# Robots that go to what lies ahead of them, however far. The objective is the goal difference against the spoilt team
# itself; a verified advantage is one over that team, playing it.
PLANTED = """\
tuning: planted
question: Are weights found that make up for the spoilt ones?
team: {teams}/paper.yaml
set:
  utility.terms.distance.weight: 0.02
  utility.terms.bearing.weight: 1
  opponent.utility.terms.distance.weight: 0.02
  opponent.utility.terms.bearing.weight: 1
opponents: [{{team: {teams}/paper.yaml}}]
parameters: [utility.terms.distance.weight, utility.terms.bearing.weight]
limit: 240
search: {{matches: 160}}
selection: {{finalists: 2, matches: 40}}
verification: {{matches: 200, against: base}}
slices: {{points: 0}}
"""


class Planted(program.Case):
    plugins = ()

    def setUp(self):
        super().setUp()
        self.plugin_folder.rmdir()
        self.plugin_folder.symlink_to(SHIPPED)

    @unittest.skipIf(program.SANITIZED, "four hundred matches take too long with sanitizers")
    def test_spoilt_weights_are_mended(self):
        self.write("planted.yaml", PLANTED.format(teams=TEAMS))
        report = json.loads(self.succeed("tune", "planted.yaml", "--quiet", "--no-page", "--json", timeout=280))
        matches = report["matches"]
        self.assertLessEqual(sum(matches[each] for each in ("search", "selection", "verification", "slices")), 400)
        candidate, = report["verification"]["candidates"]
        self.assertEqual(candidate["finding"], "better", candidate)
        self.assertLessEqual(candidate["p_holm"], 0.05)
        self.assertGreater(candidate["interval"][0], 0.0)
        self.assertIn("VERIFIED better", (self.folder / "planted.tuned.yaml").read_text().splitlines()[0])


if __name__ == "__main__":
    unittest.main()
