# SPDX-License-Identifier: MIT
"""A study that the program does not know has all that the others have: workers, results that are continued, a report in
every form, a page beside the results, matches that are played again, and refusals of what does not fit."""

import csv
import io
import json
import unittest

import tournament


class FifthStudy(tournament.Tournament):
    def count(self, *more, pairs=3, results="count.db"):
        return ["count-goals", "--team", "small.yaml", "--team", "other.yaml", "--openings", "scenes", "--results",
                results, "--quiet", "--pairs", pairs, *more]

    def test_has_all_that_studies_have(self):
        told = self.succeed(*self.count())
        matches = sum(int(line.split()[2]) for line in told.splitlines())
        self.assertGreater(matches, 0)
        self.assertEqual(self.succeed("report", "count.db"), told)
        self.assertEqual(self.succeed(*self.count("--resume")), told)
        self.assertEqual(self.succeed(*self.count("--workers", "1", "--no-page", results="one.db")), told)
        self.assertEqual(sum(json.loads(self.succeed("report", "count.db", "--json")).values()), matches)
        table = list(csv.DictReader(io.StringIO(self.succeed("report", "count.db", "--csv"))))
        self.assertEqual([row["row"] for row in table], [str(i + 1) for i in range(matches)])
        self.assertIn(f"<p>{matches} of 6 matches", (self.folder / "count.html").read_text())
        again = json.loads(self.succeed("match", "--from", "count.db", "--row", "1", "--json", "--quiet"))
        self.assertEqual(str(sum(again["score"])), table[0]["goals"])

    def test_is_not_taken_for_another_study(self):
        self.succeed(*self.count(pairs=1))
        self.assertIn("pairs: was 1, now 2", self.refused(*self.count("--resume", pairs=2)).replace("--pairs", "pairs"))
        line = self.refused(*self.arguments("--quiet", "--resume", "--results", "count.db", pairs=1))
        self.assertIn("it was a count of goals, now a tournament", line)

    def test_what_is_missing_is_told(self):
        self.succeed(*self.count(pairs=2))
        self.change("DELETE FROM metrics WHERE row = 1", "count.db")
        self.change("DELETE FROM matches WHERE row = 1", "count.db")
        done = self.run_program("report", "count.db")
        self.assertEqual((done.returncode, done.stdout), (0, ""))
        self.assertIn("count.db holds 0 matches: the count is not at its end", done.stderr)


if __name__ == "__main__":
    unittest.main()
