# SPDX-License-Identifier: MIT
"""A study that the program does not know, of a document, has all that the others have: workers, results that are continued, a report in
every form, a page beside the results, matches that are played again, and refusals of what does not fit."""

import csv
import io
import json
import unittest

import tournament


class SixthStudy(tournament.Tournament):
    def count(self, *more, pairs=3, results="count.db"):
        (self.folder / "goals.yaml").write_text("goal_count: goals\nhome: small.yaml\naway: other.yaml\nopenings: scenes\n")
        return ["run", "goals.yaml", "--results", results, "--quiet", "--set", f"pairs={pairs}", *more]

    def test_has_all_that_studies_have(self):
        told = self.succeed(*self.count())
        counted = json.loads(self.succeed("report", "count.db", "--json"))
        matches = sum(counted["goals"].values())
        self.assertGreater(matches, 0)
        self.assertTrue(told.startswith("Count of goals: goals of a match\n"), told)
        self.assertTrue(told.endswith(f"\n{matches} matches were counted.\n"), told)
        self.assertEqual(self.succeed("report", "count.db"), told)
        self.assertEqual(self.succeed(*self.count("--resume")), told)
        self.assertEqual(self.succeed("resume", "count.db", "--quiet"), told)
        self.assertEqual(self.succeed(*self.count("--workers", "1", "--no-page", results="one.db")), told)
        self.assertEqual([team["name"] for team in counted["played"]["teams"]], ["small", "other"])
        table = list(csv.DictReader(io.StringIO(self.succeed("report", "count.db", "--csv"))))
        self.assertEqual([row["row"] for row in table], [str(i + 1) for i in range(matches)])
        page = (self.folder / "count.html").read_text()
        self.assertIn(f"<h1 id=\"verdict\">{matches} matches were counted.</h1>", page)
        for section in ("played", "goals", "reproduction"):
            self.assertIn(f"<section id=\"{section}\">", page)
        again = json.loads(self.succeed("match", "--from", "count.db", "--row", "1", "--json", "--quiet"))
        self.assertEqual(str(sum(again["score"])), table[0]["goals"])

    def test_is_played_again_from_its_results(self):
        self.succeed(*self.count(pairs=2))
        counted = json.loads(self.succeed("report", "count.db", "--json"))
        self.assertEqual(counted["played"]["document"]["goal_count"], "goals")
        self.succeed("report", "count.db", "--study", "again")
        self.assertIn("goal_count: goals\n", (self.folder / "again" / "study.yaml").read_text())
        self.succeed("run", "again/study.yaml", "--results", "again.db", "--quiet")
        self.assertEqual(json.loads(self.succeed("report", "again.db", "--json"))["goals"], counted["goals"])
        self.assertEqual(self.succeed("report", "again.db", "--csv"), self.succeed("report", "count.db", "--csv"))

    def test_its_document_is_checked_shown_and_described(self):
        self.count()
        self.assertEqual(self.succeed("config", "check", "goals.yaml"), "goals.yaml: goal_count, sound\n")
        self.assertIn("pairs: 1", self.succeed("config", "show", "goals.yaml"))
        self.assertIn("pairs", json.loads(self.succeed("config", "schema", "goal_count"))["$defs"]["document"]["properties"])
        self.assertIn("## goal_count", self.succeed("config", "reference"))
        (self.folder / "goals.yaml").write_text("goal_count: goals\nhome: small.yaml\naway: small.yaml\n")
        self.assertIn("goals.yaml:3:7: away: the same team as home", self.refused("config", "check", "goals.yaml"))
        (self.folder / "goals.yaml").write_text("goal_count: goals\nhome: small.yaml\naway: nobody.yaml\n")
        self.assertIn("nobody.yaml", self.refused("config", "check", "goals.yaml"))

    def test_a_mistake_in_its_document_has_its_place(self):
        command = self.count()
        (self.folder / "goals.yaml").write_text("goal_count: goals\nhome: small.yaml\nawey: other.yaml\n")
        self.assertRegex(self.refused(*command), r"goals\.yaml:3:1: .*awey.*nearest: \"away\"")

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
        self.assertEqual(done.returncode, 0)
        self.assertIn("0 matches were counted.", done.stdout)
        self.assertIn("count.db holds 0 matches: the count is not at its end", done.stderr)


if __name__ == "__main__":
    unittest.main()
