# SPDX-License-Identifier: MIT
"""A planted problem: the weights of a shipped team are spoilt, and the tuner has to find good ones again."""

import json
import unittest

import program

STUDY = program.SOURCE / "configs" / "studies" / "tune_spoilt.yaml"
SHIPPED = program.PROGRAM.parent.parent / "lib" / "regista" / "plugins"


class Planted(program.Case):
    plugins = ()

    def setUp(self):
        super().setUp()
        self.plugin_folder.rmdir()
        self.plugin_folder.symlink_to(SHIPPED)

    @unittest.skipIf(program.SANITIZED, "four hundred matches take too long with sanitizers")
    def test_spoilt_weights_are_mended(self):
        report = json.loads(self.succeed("tune", STUDY, "--quiet", "--no-page", "--json", timeout=800))
        matches = report["matches"]
        self.assertLessEqual(sum(matches[each] for each in ("search", "selection", "verification", "slices")), 400)
        candidate, = report["verification"]["candidates"]
        self.assertEqual(candidate["finding"], "better", candidate)
        self.assertLessEqual(candidate["p_holm"], 0.05)
        self.assertGreaterEqual(candidate["interval"][0], 0.0)  # its ends are rounded outwards to a grid that has 0
        self.assertIn("VERIFIED better", (self.folder / "tune_spoilt.tuned.yaml").read_text().splitlines()[0])


if __name__ == "__main__":
    unittest.main()
