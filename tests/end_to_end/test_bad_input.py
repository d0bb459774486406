# SPDX-License-Identifier: MIT
"""Input that cannot be used: one line says what is wrong and what there is instead, at once, with exit code 2."""

import time
import unittest

import program


class BadInput(program.Case):
    def refused_at_once(self, *arguments, **options):
        began = time.monotonic()
        line = self.refused(*arguments, **options)
        self.assertLess(time.monotonic() - began, program.AT_ONCE, arguments)
        return line

    def assert_refused(self, arguments, line):
        self.assertEqual(self.refused_at_once(*arguments), line)

    def assert_team_refused(self, change, line, team=None):
        text = team if team is not None else program.TEAM.format(name="bad")
        if change is not None:
            self.assertIn(change[0], text)
            text = text.replace(*change)
        self.write("bad.yaml", text)
        self.assert_refused(("match", "small.yaml", "bad.yaml"), line)
        # The same line from the command that checks, whose answer is no.
        self.assertEqual(self.refused("config", "check", "bad.yaml", code=1), line)


if __name__ == "__main__":
    unittest.main()
