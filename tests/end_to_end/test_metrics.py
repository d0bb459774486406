# SPDX-License-Identifier: MIT
"""The numbers of a match: every one documented, the table of one match, and what must add up."""

import csv
import json
import re
import unittest

import program

MATCH = ("match", "small.yaml", "small.yaml", "--limit", "60", *program.PLAY_SOON, "--quiet")


def flat(value, path=""):
    """Paths and values below; elements of lists are counted from 1."""
    if isinstance(value, dict):
        for name, member in value.items():
            yield from flat(member, f"{path}.{name}" if path else name)
    elif isinstance(value, list):
        for i, member in enumerate(value, 1):
            yield from flat(member, f"{path}.{i}")
    else:
        yield path, value


def numbers(result):
    """(side, path) -> number or None, as docs/metrics.md says; side "" for the match."""
    out = {}
    for name, member in result.items():
        if isinstance(member, (int, float)):
            out["", name] = member
        elif isinstance(member, list) and len(member) == 2 and not isinstance(member[0], str):
            for side, of_side in zip(("home", "away"), member):
                for path, value in flat(of_side, "" if name == "roles" else name):
                    out[side, path] = value
    return out


class Metrics(program.Case):
    def setUp(self):
        super().setUp()
        self.result = json.loads(self.succeed(*MATCH, "--json", "--metrics", "numbers.csv"))

    def test_every_path_is_documented_and_every_documented_path_is_there(self):
        text = (program.SOURCE / "docs" / "metrics.md").read_text()
        documented = re.findall(r"^\| `([^`]+)` \|", text, re.MULTILINE)
        self.assertEqual(len(documented), len(set(documented)))
        roles = set(self.result["roles"][0])
        found = set()
        for _, path in numbers(self.result):
            path = re.sub(r"\.\d+$", "", path)
            role, _, rest = path.rpartition(".")
            if role in roles:
                path = f"<role>.{rest}"
            found.add(re.sub(r"^packets_by_reason\..+", "packets_by_reason.<event>", path))
        found -= {"wall_seconds", "seed"}
        # The match is shorter than a minute of the clock.
        of_plugins = {path for path in documented if path.endswith(".<plugin>.<metric>")}
        self.assertEqual(len(of_plugins), 2)
        self.assertEqual(set(documented) - {"budget_curve"} - of_plugins, found - {"budget_curve"})
        self.assertIn("budget_curve", documented)
        self.assertIn("budget_curve", self.result)

    def test_documentation_has_the_tables_of_the_program(self):
        page = program.SOURCE / "docs" / "metrics.md"
        self.assertEqual(self.succeed("metrics", "--page", page), page.read_text(),
                         "write it anew: regista metrics --page docs/metrics.md")
        rows = json.loads(self.succeed("metrics", "--json"))
        documented = re.findall(r"^\| `([^`]+)` \|", page.read_text(), re.MULTILINE)
        self.assertEqual([row["path"] for row in rows], documented)
        self.assertEqual([line.split()[0] for line in self.succeed("metrics").splitlines()], documented)

    def test_what_cannot_be_written_with_tables(self):
        self.assertIn("nobody.md: no such file", self.refused("metrics", "--page", "nobody.md"))
        self.write("page.md", "# Numbers\n")
        self.assertEqual(self.refused("metrics", "--page", "page.md"),
                         'page.md: there is no line "<!-- metrics: match -->"')
        self.write("page.md", "<!-- metrics: weather -->\n")
        self.assertIn('"weather" is no part of the metrics', self.refused("metrics", "--page", "page.md"))
        self.assertIn("--json and --page", self.refused("metrics", "--json", "--page", "page.md"))

    def test_table_holds_what_the_json_holds(self):
        with open(self.folder / "numbers.csv", newline="") as file:
            rows = list(csv.reader(file))
        self.assertEqual(rows[0], ["side", "metric", "value"])
        table = {(side, path): value for side, path, value in rows[1:]}
        self.assertEqual(len(table), len(rows) - 1)
        wanted = numbers(self.result)
        del wanted["", "wall_seconds"]
        self.assertEqual(set(table), set(wanted))
        for place, value in wanted.items():
            self.assertEqual(table[place], "" if value is None else table[place])
            if value is not None:
                self.assertEqual(float(table[place]), value, place)

    def test_same_match_same_table(self):
        self.succeed(*MATCH, "--metrics", "again.csv")
        self.assertEqual((self.folder / "again.csv").read_bytes(), (self.folder / "numbers.csv").read_bytes())

    def test_what_adds_up(self):
        result = self.result
        for side in (0, 1):
            for role in result["roles"][side].values():
                for name in ("overlap{}_seconds", "uncovered{}_seconds", "switches{}"):
                    self.assertAlmostEqual(role[name.format("")], role[name.format("_before_silence")] +
                                           role[name.format("_after_silence")])
            self.assertLessEqual(result["shots_scored"][side] + result["shots_saved"][side], result["shots"][side])
            self.assertAlmostEqual(result["distance_walked_metres"][side],
                                   sum(result["robot_distance_metres"][side]), 2)
            opponents = result["world_model"][side]["opponents"]
            self.assertAlmostEqual(opponents["ospa_metres"], opponents["ospa_location_metres"] +
                                   opponents["ospa_cardinality_metres"], 5)
            # Who assigns the same of the same tasks agrees.
            self.assertGreaterEqual(result["agreement"][side] + 1e-5, result["kept_tasks_agreement"][side] *
                                    (result["assignment_agreement_given_tasks"][side] or 0))
            self.assertLessEqual(result["ball_chased_by_several_seconds"][side], result["in_play_seconds"])
            if result["tenure_median_seconds"][side] is not None:
                self.assertLessEqual(result["tenure_10_percent_seconds"][side], result["tenure_median_seconds"][side])
            self.assertGreaterEqual(result["target_distance_least_metres"][side], 0)
            for value in (result["ball_seen_share"][side], result["agreement"][side], result["context_agreement"][side],
                          result["kept_tasks_agreement"][side], result["assignment_agreement_given_tasks"][side],
                          result["nearest_plays_ball"][side],
                          *(result["world_model"][side][what][share] for what in ("ball", "self", "teammates")
                            for share in ("known_share", "coverage_95"))):
                self.assertTrue(value is None or 0 <= value <= 1, value)
        self.assertLessEqual(result["ball_rest_seconds"], result["in_play_seconds"])
        x = [territory["ball_x_metres"] for territory in result["territory"]]
        self.assertAlmostEqual(x[0], -x[1], 5)

    def test_silence_begins_with_the_last_packet(self):
        """every_second sends until the budget is empty: at once, in the middle of the match, or near its end."""
        self.assertEqual(self.result["silent_seconds"], [0.0, 0.0])
        for budget, low, high in ((20, 1.0, 1.0), (180, 0.5, 0.7), (280, 0.0, 0.0)):
            with self.subTest(budget):
                result = json.loads(self.succeed(*MATCH, "--json", "--set", f"rules.messages.budget={budget}"))
                self.assertEqual(result["packets"], [budget, budget])
                for side in (0, 1):
                    share = result["silent_seconds"][side] / result["playing_seconds"]
                    self.assertTrue(low <= share <= high, share)
                    self.assertEqual(result["agreement_after_silence"][side] is None, high == 0.0)
                    self.assertEqual(result["agreement_before_silence"][side] is None, low == 1.0)

    def test_all_of_them_can_be_tested_in_a_tournament(self):
        """Also those that a match that was not played has no number of."""
        self.write("other.yaml", program.TEAM.format(name="other").replace("scale: 2", "scale: 3"))
        play = ("tournament", "--team", "small.yaml", "--team", "other.yaml", "--pairs", "2", "--limit", "10",
                *program.PLAY_SOON, "--quiet")
        for i, metric in enumerate(("world_model.ball.rmse_metres", "agreement_after_silence", "shots",
                                    "nearest_plays_ball", "tenure_median_seconds",
                                    "striker.overlap_before_silence_seconds", "packets_by_reason.period",
                                    "unplayed_seconds")):
            with self.subTest(metric):
                done = self.run_program(*play, "--metric", metric, "--results", f"{i}.db")
                self.assertIn(done.returncode, (0, 1), done.stderr)
                self.assertIn(f"{metric}: ", done.stdout)
        self.assertIn('nearest: "shots"', self.refused(*play, "--metric", "shotts", "--results", "none.db"))

    def test_what_may_be_replaced(self):
        self.succeed(*MATCH[:4], "1", *MATCH[5:], "--metrics", "numbers.csv")
        ask = lambda *words: self.refused(*MATCH[:4], "1", *MATCH[5:], *words)
        self.write("notes.txt", "not a table\n")
        self.assertIn("no table of metrics replaces", ask("--metrics", "notes.txt"))
        self.assertIn("is a file that this match reads", ask("--metrics", "small.yaml"))
        self.assertIn("--metrics nowhere/numbers.csv: cannot be written there", ask("--metrics", "nowhere/numbers.csv"))
        self.assertIn("both name new.csv", ask("--metrics", "new.csv", "--record", "new.csv"))
        self.assertIn("both name new.csv", ask("--metrics", "new.csv", "--decisions", "new.csv"))


if __name__ == "__main__":
    unittest.main()
