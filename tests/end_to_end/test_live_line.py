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

    def test_the_first_word_of_a_message_has_a_colour_where_it_may(self):
        def said(**options):
            text, out = self.on_terminal("match", "nothing.yaml", "small.yaml", status=2, **options)
            self.assertEqual(out, "")
            return text

        self.assertTrue(said().startswith("\x1b[1;31mregista:\x1b[0m nothing.yaml: no such file"), said())
        for options in ({"terminal": "dumb"}, {"environment": {"NO_COLOR": "1"}}):
            self.assertTrue(said(**options).startswith("regista: nothing.yaml: no such file"), said(**options))


if __name__ == "__main__":
    unittest.main()
