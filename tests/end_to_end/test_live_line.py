# SPDX-License-Identifier: MIT
"""The line that shows the course of a match on a terminal."""

import re
import unittest

import program

ERASE = "\r\x1b[K"


class LiveLine(program.Case):
    def shown(self, *arguments, terminal="xterm"):
        """What a terminal got."""
        limit = "100" if program.SANITIZED else "1000"
        return self.on_terminal("match", "small.yaml", "small.yaml", "--limit", limit, *arguments, terminal=terminal)[0]

    def test_one_line_rewritten_in_place_and_cleared(self):
        text = self.shown()
        self.assertTrue(text.startswith(ERASE), text)
        self.assertTrue(text.endswith(ERASE), text)
        self.assertNotIn("\n", text)
        drawings = text.split(ERASE)[1:-1]
        self.assertGreater(len(drawings), 1)
        for drawing in drawings:
            self.assertRegex(drawing, r"^half [12]  \d\d:\d\d  \d+:\d+  \d+ s/s  packets left \d+, \d+$")
        clocks = [re.search(r"\d\d:\d\d", drawing).group() for drawing in drawings if drawing.startswith("half 1")]
        self.assertEqual(clocks, sorted(clocks))

    def test_nothing_when_quiet_or_when_the_terminal_cannot(self):
        self.assertEqual(self.shown("--quiet"), "")
        self.assertEqual(self.shown(terminal="dumb"), "")


if __name__ == "__main__":
    unittest.main()
