# SPDX-License-Identifier: MIT
"""`regista report`: what is stored says what the tournament said, whole, killed, under way or damaged."""

import json
import subprocess
import unittest

import tournament

THREE = ("small.yaml", "worse.yaml", "other.yaml")


class Report(tournament.Tournament):
    def test_says_what_the_tournament_said(self):
        for number, options in enumerate((
                dict(more=(), pairs=4), dict(more=("--sprt", "0,200"), teams=("small.yaml", "worse.yaml"), pairs=200),
                dict(more=("--metric", "overlap_seconds"), pairs=4),
                dict(more=("--format", "gauntlet"), teams=THREE, pairs=2))):
            more = (*options.pop("more"), "--results", f"{number}.db")
            text = self.play(*more, **options)
            report = self.play(*more, "--resume", "--json", **options)
            self.assertEqual(self.succeed("report", f"{number}.db"), text)
            self.assertEqual(self.succeed("report", f"{number}.db", "--json"), report)
        self.assertEqual(sorted(file.name for file in self.folder.glob("*.db*")), ["0.db", "1.db", "2.db", "3.db"])

    def test_of_one_that_was_killed_says_how_far_it_came(self):
        self.kill_when(lambda: self.count() >= 9, *self.arguments("--quiet", "--workers", "1", pairs=400))
        done = self.run_program("report", "tournament.db", "--json")
        self.assertEqual(done.returncode, 0)
        report = json.loads(done.stdout)
        matches = report["matches"]
        self.assertGreaterEqual(matches, 9)
        self.assertEqual(matches, self.count())
        self.assertEqual(done.stderr, f"regista: tournament.db holds {matches} of 800 matches without a gap: the "
                                      "tournament is not at its end\n")
        self.assertEqual(sum(report["pairings"][0]["pentanomial"]), matches // 2)
        # A shorter one that nobody killed had said the same of these pairs.
        whole = self.only("--results", "whole.db", pairs=matches // 2)
        for key in ("pentanomial", "elo", "variance_ratio", "goals_per_match"):
            if matches % 2 == 0:
                self.assertEqual(whole[key], report["pairings"][0][key])
        self.assertEqual(self.rows("whole.db"), self.rows()[:matches - matches % 2])
        rows = self.run_program("report", "tournament.db", "--csv").stdout.count("\n") - 1
        self.assertEqual(rows, matches)

    def test_ends_at_a_gap(self):
        self.play(pairs=4)
        self.change("DELETE FROM metrics WHERE row = 6")
        self.change("DELETE FROM matches WHERE row = 6")
        done = self.run_program("report", "tournament.db", "--json")
        self.assertEqual((done.returncode, json.loads(done.stdout)["matches"]), (0, 5))
        self.assertIn("holds 5 of 8 matches without a gap", done.stderr)
        before = self.stored("SELECT hash FROM matches WHERE row = 5")
        self.play("--resume", pairs=4)
        self.assertEqual(len(self.table()), 8)
        self.assertEqual(self.stored("SELECT hash FROM matches WHERE row = 5"), before)

    def test_while_another_process_plays(self):
        with self.start(*self.arguments("--quiet", "--workers", "1", pairs=400), stdout=subprocess.DEVNULL,
                        stderr=subprocess.PIPE) as process:
            seen = [3]
            while len(seen) < 6:
                self.wait_for(lambda: self.count() > seen[-1])
                done = self.run_program("report", "tournament.db", "--json")
                self.assertEqual(done.returncode, 0, done.stderr)
                seen.append(json.loads(done.stdout)["matches"])
            self.assertIsNone(process.poll(), "ended before it was read")
            process.send_signal(2)
            _, err = process.communicate(timeout=20)
        self.assertEqual(seen, sorted(set(seen)))
        self.assertIn("interrupted after", err)  # the reader did not stand in the way of the writer

    def test_a_table(self):
        self.play("--seed", "5", pairs=4)
        table = self.table()
        stored = self.stored("SELECT row, seed, home_goals, away_goals, ended, hash FROM matches ORDER BY row")
        self.assertEqual(len(table), 8)
        for row, (number, seed, home, away, ended, state_hash) in zip(table, stored):
            self.assertEqual(list(row.values())[:14], [
                str(number), str((number + 1) // 2), str(seed), "left" if (number - 1) // 2 % 2 == 0 else "right",
                *(("small", "other") if number % 2 == 1 else ("other", "small")), str(home), str(away), ended,
                state_hash, "", "", "", ""])

    def test_packets_of_short_games_beside_their_share_of_the_budget(self):
        """Everywhere the same numbers, which are those of the matches: 10 s are 10 of 1200 packets."""
        told = self.play(pairs=2)
        spent = {"small": [], "other": []}
        for row, (metrics,) in zip(self.table(), self.stored("SELECT json FROM metrics ORDER BY row")):
            for side, packets in zip(("home", "away"), json.loads(metrics)["packets"]):
                spent[row[side]].append(packets)
                self.assertEqual([float(row[f"{side}.{name}"]) for name in
                                  ("packets", "packets_share", "packets_over_share")], [packets, 10, packets - 10])
        teams = {team["name"]: team["packets_of_short_games"] for team in self.report("--resume", pairs=2)["teams"]}
        self.assertEqual(self.succeed("report", "tournament.db"), told)
        for name, packets in spent.items():
            mean = sum(packets) / 4
            self.assertGreater(mean, 10)
            self.assertEqual(teams[name], {"per_match": mean, "share": 10, "overspent": True})
            self.assertIn(f"\n{name} spent {mean:.4g} packets per match; the share of the budget for this length is 10: "
                          "OVERSPENT\n", told)

    def test_a_budget_that_is_the_share_is_not_overspent(self):
        told = self.play("--set", "rules.messages.short_games=share", pairs=1)
        self.assertNotIn("OVERSPENT", told)
        self.assertLessEqual(max(float(row["home.packets"]) for row in self.table()), 10)

    def test_a_table_with_all_metrics(self):
        self.play()
        plain, table = self.table(), self.table("--metrics")
        columns = [column for column in table[0] if column not in plain[0] or column.endswith(".packets")]
        self.assertEqual(len(columns), len(set(columns)))
        self.assertIn("home.striker.overlap_seconds", columns)
        for row, short, (metrics,) in zip(table, plain, self.stored("SELECT json FROM metrics ORDER BY row")):
            self.assertEqual({key: row[key] for key in short}, short)
            metrics = json.loads(metrics)
            for side, name in enumerate(("home", "away")):
                self.assertEqual(float(row[f"{name}.packets"]), metrics["packets"][side])
                for role, numbers in metrics["roles"][side].items():
                    for key in ("overlap_seconds", "uncovered_seconds", "switches"):
                        self.assertEqual(float(row[f"{name}.{role}.{key}"]), numbers[key])
            self.assertEqual([column for column in columns if row[column] == ""],
                             [column for column in columns if self.there_is_none(metrics, column)])

    @staticmethod
    def there_is_none(metrics, column):
        """Whether the match had no such number, as the error of a ball that nobody knew."""
        side, _, path = column.partition(".")
        value = {name: member[("home", "away").index(side)] for name, member in metrics.items()
                 if isinstance(member, list) and len(member) == 2}
        names = path.split(".")
        value = {**value["roles"], **value}
        for name in names:
            value = value[name]
        return value is None

    def test_a_table_of_names_with_commas_quotes_and_newlines(self):
        # Teams of the same name are told apart by their files.
        odd = 'odd,\n"quoted".yaml'
        self.write(odd, (self.folder / "other.yaml").read_text().replace("team: other", "team: small"))
        names = ("small (small.yaml)", f"small ({odd})")
        self.play(teams=("small.yaml", odd), pairs=1)
        failure = json.dumps({"side": 0, "plugin": "a,b", "call": 'say "so"', "robot": 1, "tick": 2,
                              "what": "one\ntwo,\"three\""})
        self.change("DELETE FROM metrics WHERE row = 2")
        self.change(f"UPDATE matches SET failure = '{failure}', ended = 'forfeit', hash = NULL WHERE row = 2")
        for more in ((), ("--metrics",)):
            table = self.table(*more)
            self.assertEqual([(row["home"], row["away"]) for row in table], [names, names[::-1]])
            self.assertEqual([table[1][key] for key in ("state_hash", "forfeited_by", "plugin", "call", "why")],
                             ["", "home", "a,b", 'say "so"', "one\ntwo,\"three\""])
            self.assertEqual({value for key, value in table[1].items() if "seconds" in key}, {""} if more else set())

    def test_files_that_cannot_be_told_of(self):
        ask = lambda *words: self.refused("report", *words)
        self.assertIn("which results?", ask())
        self.assertIn("nobody.db: No such file", ask("nobody.db"))
        self.write("text.db", "not a database" * 100)
        self.assertIn("text.db: is no database", ask("text.db"))
        self.write("blank.db", "")
        self.assertIn("blank.db holds no results yet", ask("blank.db"))
        self.assertIn("bin", ask("bin"))
        self.play(pairs=1)
        self.assertIn("--csv and --json", ask("tournament.db", "--csv", "--json"))
        self.assertIn("--metrics adds columns to --csv", ask("tournament.db", "--metrics"))
        whole = (self.folder / "tournament.db").read_bytes()

        def changed(statement, *more):
            (self.folder / "tournament.db").write_bytes(whole)
            self.change(statement)
            line = ask("tournament.db", *more)
            self.assertIn("tournament.db", line)
            return line

        self.assertIn("database of another program", changed("PRAGMA application_id=7"))
        self.assertIn("was written by a newer Regista: schema 99", changed("PRAGMA user_version=99"))
        self.assertIn("its plan is damaged", changed("UPDATE meta SET value = '{' WHERE name = 'schedule'"))
        self.assertIn("holds no study yet", changed("DELETE FROM meta WHERE name = 'schedule'"))
        self.assertIn("another study", changed("UPDATE meta SET value = replace(value, '\"tournament\"', '\"season\"')"))
        self.assertIn("damaged", changed("UPDATE matches SET failure = '{' WHERE row = 2"))
        self.assertIn("damaged", changed("UPDATE metrics SET json = '{' WHERE row = 2", "--csv", "--metrics"))
        (self.folder / "tournament.db").write_bytes(whole[:len(whole) // 2])
        self.assertIn("tournament.db", ask("tournament.db"))

    def test_damaged_metrics_of_a_tournament_that_tests_them(self):
        self.play("--metric", "packets", pairs=2)
        self.change("UPDATE metrics SET json = 'nonsense' WHERE row = 1")
        self.assertIn("damaged", self.refused("report", "tournament.db"))
        self.assertIn("damaged", self.refused(*self.arguments("--quiet", "--metric", "packets", "--resume", pairs=2)))

    def test_a_reader_that_is_gone_or_a_full_disk(self):
        self.play(pairs=1)
        for more in ((), ("--json",), ("--csv",)):
            with open("/dev/full", "w") as full:
                done = self.run_program("report", "tournament.db", *more, stdout=full)
            self.assertEqual(done.returncode, 1)
            self.assertIn("cannot write to standard output", done.stderr)


if __name__ == "__main__":
    unittest.main()
