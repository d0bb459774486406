# SPDX-License-Identifier: MIT
"""The block that shows the course of a tournament on a terminal: played back by a small terminal of our own."""

import re
import unittest

import program
import tournament

REWRITE = re.compile(r"\x1b\[(\d+)F\x1b\[J")


class Live(tournament.Tournament):
    pages = True

    def shown(self, *arguments, columns=80, terminal="xterm", **options):
        """What a terminal of so many columns got on standard error, and standard output."""
        return self.on_terminal(*self.arguments(*arguments, **options), columns=columns, terminal=terminal)

    def played_back(self, text, columns):
        """Every block that was on the screen, and what is left on it at the end."""
        blocks, screen = [], []
        rest = text
        while rest:
            move = REWRITE.match(rest)
            if move:
                self.assertEqual(int(move[1]), len(screen), "takes away more or less than it drew")
                blocks.append(screen)
                screen = []
                rest = rest[move.end():]
                continue
            line, end, rest = rest.partition("\r\n")
            self.assertEqual(end, "\r\n")
            self.assertNotIn("\x1b", line)
            self.assertLess(len(line.encode()), columns, "a line that wraps is two")
            screen.append(line)
        return blocks, screen

    def test_a_block_rewritten_in_place_and_gone_at_the_end(self):
        pairs = 12 if program.SANITIZED else 40
        text, out = self.shown(pairs=pairs)
        blocks, screen = self.played_back(text, 80)
        self.assertEqual(blocks.pop(0), [f"0 of {2 * pairs} matches, the first is being played"])
        self.assertGreater(len(blocks), 2)
        done = []
        for block in blocks:
            self.assertRegex(block[0], rf"^small vs other \(\d+ pairs?( of {pairs})?, seeds from 1, 2 scenes of about 10 s\)$")
            self.assertTrue(any(re.match(r"Games: \d+, Wins: \d+, ", line) for line in block), block)
            self.assertTrue(any(line.startswith("Ptnml(0-2): [") for line in block), block)
            last = re.match(rf"(\d+) of {2 * pairs} matches, \d+\.\d\d matches/s(, at most .* left)?$", block[-1])
            self.assertTrue(last, block)
            done.append(int(last[1]))
        self.assertEqual(done, sorted(set(done)))
        # What stays is the line that sums it up, and where the page is; the report goes to standard output.
        self.assertEqual(len(screen), 2)
        self.assertEqual(screen[1], "page: tournament.html")
        self.assertRegex(screen[0], rf"^{2 * pairs} matches played in \d+ s, \d+\.\d\d matches/s$")
        self.assertEqual(out, self.succeed("report", "tournament.db"))

    def test_a_narrow_terminal(self):
        text, _ = self.shown("--sprt", "0,1", columns=20)
        summary = REWRITE.split(text)[-1]
        blocks, _ = self.played_back(text.removesuffix(summary), 20)
        self.assertGreater(len(blocks), 0)
        self.assertTrue(any(line.startswith("LLR: ") for line in blocks[-1]))
        self.assertEqual(max(len(line) for block in blocks for line in block), 19)

    def test_a_ranking(self):
        text, _ = self.shown(teams=("small.yaml", "other.yaml", "worse.yaml"), pairs=7, columns=120)
        blocks = self.played_back(text, 120)[0][1:]
        self.assertGreater(len(blocks), 0)
        for block in blocks:  # so few matches tell no margin, which is said once
            rows = [line for line in block if not line.startswith("No margin: ")]
            self.assertGreaterEqual(len(rows), len(block) - 1)
            self.assertTrue(rows[1].startswith("Rank  Team") and len(rows) == 6, blocks)

    def test_nothing_when_quiet_and_plain_lines_when_the_terminal_cannot(self):
        self.assertEqual(self.shown("--quiet", pairs=1)[0], "")
        text, _ = self.shown("--resume", terminal="dumb", pairs=1)
        self.assertNotIn("\x1b", text)
        self.assertRegex(text, r"^1 pair cannot give a verdict: at least 6 are needed\r\n0 matches played in \d+ s; 2 were played before\r\npage: tournament\.html\r\n$")
        text, _ = self.shown("--results", "dumb.db", terminal="dumb", pairs=1)
        self.assertEqual(len(re.findall(r"^match \d of 2, seed 1, \w+: ", text, re.MULTILINE)), 2)
        self.assertNotIn("\x1b", text)


if __name__ == "__main__":
    unittest.main()
