# SPDX-License-Identifier: MIT
"""What plugins write to standard error while a study is played: kept with the match, bounded, and told on request."""

import json
import re
import unittest

import program
import tournament

FOLDER = program.TEST_PLUGINS / "talks"
MOST = 2 * 4096  # bytes that are kept


class PluginOutput(tournament.Tournament):
    def played(self, plugin, *more, pairs=2):
        self.with_context(plugin)
        # Nothing of it reaches the terminal.
        return self.play("--plugins", FOLDER, *more, teams=("bad.yaml", "small.yaml"), pairs=pairs)

    def test_it_is_kept_with_the_match(self):
        for more in (), ("--isolation", "always"), ("--play-once",):
            with self.subTest(more):
                text = self.played("whispers", *more)
                self.assertIn("\nplugins wrote to standard error in 4 matches, first in match 1; see: regista report FILE "
                              "--standard-error 1\n", text)
                for match in "1", "4":
                    # The terminal is not at its mercy.
                    self.assertEqual(self.succeed("report", "tournament.db", "--standard-error", match),
                                     "a word from whispers\\x1b[2J\n")
                report = json.loads(self.succeed("report", "tournament.db", "--json"))
                self.assertEqual(report["standard_error"], {"matches": 4, "listed": [1, 2, 3, 4]})
            (self.folder / "tournament.db").unlink()

    def test_it_is_bounded(self):
        self.played("babbles", "--play-once", pairs=1)
        kept = self.succeed("report", "tournament.db", "--standard-error", "1")
        first, left_out, last = re.fullmatch(r"(.*)\n\[(\d+) bytes are left out\]\n(.*)\n", kept, re.DOTALL).groups()
        # Seven robots, 10 s, ten decisions a second, one line for each.
        lines = sum(len(f"babbles: call {call}\n") for call in range(1, 96))
        self.assertAlmostEqual(len(first) + int(left_out) + len(last), 7 * lines, delta=0.1 * 7 * lines)
        self.assertLessEqual(len(first) + len(last) + 1, MOST)
        self.assertTrue(first.startswith("babbles: call 1\n"), first[:100])
        self.assertRegex(last, r"babbles: call \d+$")

    def test_of_a_match_in_which_nobody_wrote(self):
        self.play(pairs=1)
        self.assertEqual(self.refused("report", "tournament.db", "--standard-error", "2"),
                         "tournament.db: in match 2 no plugin wrote to standard error")
        self.assertEqual(self.refused("report", "tournament.db", "--standard-error", "3"),
                         "tournament.db holds no match 3")
        self.assertNotIn("standard error", self.succeed("report", "tournament.db"))


if __name__ == "__main__":
    unittest.main()
