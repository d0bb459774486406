# SPDX-License-Identifier: MIT
"""`regista report`: what is stored says what the tournament said, whole, killed, under way or damaged."""

import contextlib
import json
import re
import sqlite3
import subprocess
import unittest

import results_file
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
        for row, metrics in zip(self.table(), self.metrics().values(), strict=True):
            for side, packets in zip(("home", "away"), metrics["packets"]):
                spent[row[side]].append(packets)
                self.assertEqual([float(row[f"{side}.{name}"]) for name in
                                  ("packets", "packets_share", "packets_over_share")], [packets, 10, packets - 10])
        teams = {team["name"]: team["packets_of_short_games"] for team in self.report("--resume", pairs=2)["teams"]}
        self.assertEqual(self.succeed("report", "tournament.db"), told)
        # Files that were begun before there was a table of them say the same, and go on.
        self.change("DROP TABLE packets", mend=False)
        self.change("DELETE FROM metrics WHERE row = 4", mend=False)
        self.change("DELETE FROM matches WHERE row = 4", mend=False)
        self.play("--resume", pairs=2)
        self.assertEqual(self.succeed("report", "tournament.db"), told)
        for name, packets in spent.items():
            mean = sum(packets) / 4
            self.assertGreater(mean, 10)
            self.assertEqual(teams[name], {"per_match": mean, "share": 10, "above_share": True})
            self.assertIn(f"\n{name} spent {mean:.4g} packets per match, more than the share of the budget for this length: 10.\n",
                          told)

    def test_the_program_of_a_plan_that_does_not_name_it(self):
        self.play(pairs=1)
        told = self.succeed("report", "tournament.db")
        self.assertRegex(told, r"\n  Regista \d+\.\d+\.\d+, program ")
        self.change("UPDATE meta SET value = json_remove(value, '$.program') WHERE name = 'schedule'")
        self.assertEqual(self.succeed("report", "tournament.db"), told)

    def test_no_team_is_above_a_budget_that_is_the_share(self):
        told = self.play("--set", "rules.messages.short_games=share", pairs=1)
        self.assertNotIn("more than the share", told)
        self.assertLessEqual(max(float(row["home.packets"]) for row in self.table()), 10)

    def test_a_table_with_all_metrics(self):
        self.play()
        plain, table = self.table(), self.table("--metrics")
        columns = [column for column in table[0] if column not in plain[0] or column.endswith(".packets")]
        self.assertEqual(len(columns), len(set(columns)))
        self.assertIn("home.striker.overlap_seconds", columns)
        for row, short, metrics in zip(table, plain, self.metrics().values(), strict=True):
            self.assertEqual({key: row[key] for key in short}, short)
            for side, name in enumerate(("home", "away")):
                self.assertEqual(float(row[f"{name}.packets"]), metrics["packets"][side])
                self.assertNotIn(f"{name}.ball_rests", row)
                for role, numbers in metrics["roles"][side].items():
                    for key in ("overlap_seconds", "uncovered_seconds", "switches"):
                        self.assertEqual(float(row[f"{name}.{role}.{key}"]), numbers[key])
            of_match = [name for name, value in metrics.items() if not isinstance(value, (list, dict))]
            self.assertIn("ball_rests", of_match)
            self.assertEqual(columns[-len(of_match):], of_match)  # last
            self.assertEqual([float(row[name]) for name in of_match], [metrics[name] for name in of_match])
            self.assertEqual([column for column in columns if row[column] == ""],
                             [column for column in columns if self.there_is_none(metrics, column)])

    @staticmethod
    def there_is_none(metrics, column):
        """Whether the match had no such number, as the error of a ball that nobody knew."""
        side, _, path = column.partition(".")
        if not path:
            return metrics[column] is None
        value = {name: member[("home", "away").index(side)] for name, member in metrics.items()
                 if isinstance(member, list) and len(member) == 2}
        names = path.split(".")
        value = {**value["roles"], **value}
        for name in names:
            value = value[name]
        return value is None

    def titled(self, name, title):
        text = (self.folder / "small.yaml").read_text()
        self.write(f"{name}.yaml", text.replace("team: small\n", f"team: {name}\ntitle: {json.dumps(title)}\n"))
        return f"{name}.yaml"

    def test_people_read_titles_and_programs_names(self):
        self.pages = True
        teams = self.titled("first", "The First, e.V."), self.titled("second", "Team <2>")
        text = self.play(teams=teams, pairs=1)
        self.assertIn("The First, e.V. vs Team <2> ", text.splitlines()[0])
        found = text[text.index("\nStanding\n"):]  # what was played names the files' words
        self.assertIn("\nNot decided between The First, e.V. and Team <2>.", found)
        self.assertNotRegex(found, r"\b(first|second)\b")
        report = json.loads(self.succeed("report", "tournament.db", "--json"))
        self.assertEqual([(team["name"], team["title"]) for team in report["teams"]],
                         [("first", "The First, e.V."), ("second", "Team <2>")])
        self.assertEqual(report["pairings"][0]["teams"], ["first", "second"])
        self.assertEqual([(row["home"], row["away"]) for row in self.table()], [("first", "second"), ("second", "first")])
        page = (self.folder / "tournament.html").read_text().replace("<wbr>", "")
        self.assertRegex(page, "<title>[^<]*The First, e.V. vs Team &lt;2&gt; ")
        self.assertIn('<h1 id="verdict">Not decided between <bdi>The First, e.V.</bdi> and <bdi>Team &lt;2&gt;</bdi>.', page)

    def test_equal_titles_are_followed_by_the_names(self):
        teams = self.titled("first", "Same"), self.titled("second", "Same"), "small.yaml", self.titled("third", "small")
        report = self.report(teams=teams, pairs=1)
        self.assertEqual([(team["name"], team["title"]) for team in report["teams"]],
                         [("first", "Same (first)"), ("second", "Same (second)"), ("small", "small"),
                          ("third", "small (third)")])
        text = self.succeed("report", "tournament.db")
        for shown in ("Same (first)", "Same (second)", "small", "small (third)"):
            self.assertRegex(text, rf"(?m)^ +\d  {re.escape(shown)}  ")

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
        self.assertIn(": its schema is 99, this program reads 2", changed("PRAGMA user_version=99"))
        self.assertIn("its plan is damaged", changed("UPDATE meta SET value = '{' WHERE name = 'schedule'"))
        self.assertIn("holds no study yet", changed("DELETE FROM meta WHERE name = 'schedule'"))
        self.assertIn("another study", changed("UPDATE meta SET value = replace(value, '\"tournament\"', '\"season\"')"))
        self.assertIn("damaged", changed("UPDATE matches SET failure = '{' WHERE row = 2"))
        self.assertIn("match 2: metrics: ", changed("UPDATE metrics SET numbers = x'00' WHERE row = 2", "--csv",
                                                    "--metrics"))
        self.assertIn("match 2: metrics: ", changed("UPDATE metrics SET names = 7 WHERE row = 2", "--csv", "--metrics"))
        (self.folder / "tournament.db").write_bytes(whole[:len(whole) // 2])
        self.assertIn("tournament.db", ask("tournament.db"))

    def test_a_plan_that_was_changed(self):
        self.play(pairs=4)
        whole = (self.folder / "tournament.db").read_bytes()
        fewer = "UPDATE meta SET value = replace(value, 'pairs: 4', 'pairs: 3') WHERE name = 'schedule'"
        for statement, line, mend in (
                (fewer, "the checksum of the plan of its study does not fit", False),
                # Written by somebody who knows the checksum, or in a file of an older program.
                (fewer, "match 7: the study did not plan it", True),
                ("UPDATE meta SET value = replace(value, 'seed: 1', 'seed: 2') WHERE name = 'schedule'",
                 "match 1: the study did not plan it", True),
                ("UPDATE matches SET row = 100 WHERE row = 8", "match 100: ", True),
                ("UPDATE meta SET value = '[]' WHERE name = 'documents'",
                 "the checksum of the teams' documents does not fit", False)):
            (self.folder / "tournament.db").write_bytes(whole)
            before = self.stored("SELECT * FROM meta ORDER BY name"), self.stored("SELECT * FROM matches")
            self.change(statement, mend=mend)
            self.assertNotEqual((self.stored("SELECT * FROM meta ORDER BY name"), self.stored("SELECT * FROM matches")),
                                before, statement)
            self.assertIn(line, self.refused("report", "tournament.db", "-o", "page.html"))
            if "documents" not in statement:  # of which it reads nothing
                self.assertIn("tournament.db", self.refused(*self.arguments("--resume", "--quiet", pairs=4)))

    def test_a_file_of_an_older_program_has_no_checksum_of_its_plan(self):
        text = self.play(pairs=2)
        self.change("ALTER TABLE meta DROP COLUMN checksum", mend=False)
        remark = ("regista: tournament.db: an older Regista wrote it: its plan has no checksum, so that a change of it is "
                  "not noticed\n")
        done = self.run_program("report", "tournament.db")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, text, remark))
        done = self.run_program(*self.arguments("--resume", "--quiet", pairs=2))
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, text, remark))
        self.assertEqual(self.succeed("report", "tournament.db"), text)

    def test_rows_that_are_not_what_was_written_are_named(self):
        self.play(pairs=2)
        with contextlib.closing(sqlite3.connect(self.folder / "tournament.db")) as database:
            self.assertEqual(results_file.unfit(database), [])
        whole = (self.folder / "tournament.db").read_bytes()
        for statement, line in (
                ("UPDATE matches SET home_goals = home_goals + 1 WHERE row = 2", "match 2: its checksum does not fit"),
                ("UPDATE matches SET seconds = 0.5 WHERE row > 1",
                 "match 2: its checksum does not fit; matches 3, 4 cannot be read either"),
                ("UPDATE metric_names SET names = replace(names, 'striker', 'stroker')",
                 "match 1: metrics: the checksum of metric names 1 does not fit; matches 2, 3, 4 cannot be read either"),
                ("UPDATE matches SET seed = seed + 7 WHERE row = 2", "match 2: its checksum does not fit"),
                ("UPDATE fixtures SET key = key || 'x' WHERE id = 1", "the checksum of fixture 1 does not fit"),
                ("DELETE FROM metrics WHERE row = 2", "match 2: its metrics are missing"),
                ("UPDATE metrics SET size = size + 1 WHERE row = 3",
                 "match 3: the checksum of its metrics does not fit"),
                ("UPDATE packets SET numbers = x'020202020202' WHERE row > 2",
                 "match 3: the checksum of its packets does not fit; match 4 cannot be read either")):
            (self.folder / "tournament.db").write_bytes(whole)
            self.change(statement, mend=False)
            # The numbers are read where they are told; packets of these games by every report.
            table = ("--csv", "--metrics")
            for more in ((), table) if re.match("UPDATE (matches|packets)", statement) else (table,):
                self.assertEqual(self.refused("report", "tournament.db", *more),
                                 "results in tournament.db are damaged: " + line)
        # Without a table of packets these are read among all numbers.
        (self.folder / "tournament.db").write_bytes(whole)
        self.change("DROP TABLE packets", mend=False)
        self.change("UPDATE metrics SET size = size + 1 WHERE row = 3", mend=False)
        self.assertEqual(self.refused("report", "tournament.db"), "results in tournament.db are damaged: match 3: the "
                         "checksum of its metrics does not fit")
        (self.folder / "tournament.db").write_bytes(whole)
        self.change("UPDATE fixtures SET job = replace(job, 'small', 'other')", mend=False)
        self.assertIn("match 1: the checksum of what was to be played does not fit",
                      self.refused("match", "--from", "tournament.db", "--row", "1"))

    def test_files_of_an_older_schema_are_refused(self):
        self.play(pairs=1)
        self.change("PRAGMA user_version=1", mend=False)
        for ask in (("report", "tournament.db"), self.arguments("--quiet", "--resume", pairs=1)):
            self.assertIn("tournament.db was written by an older Regista, ", self.refused(*ask))
            self.assertIn(": its schema is 1, this program reads 2", self.refused(*ask))

    def test_metrics_take_little_room(self):
        """At most 3 KB a match, names left aside: there is one text of them for all matches of these teams."""
        self.play(pairs=2)
        (names, matches, most), = self.stored("SELECT count(DISTINCT names), count(*), max(length(numbers)) FROM metrics")
        self.assertEqual(matches, 4)
        self.assertLessEqual(names, 2)
        self.assertLess(most, 3000)

    def test_damaged_metrics_of_a_tournament_that_tests_them(self):
        self.play("--metric", "packets", pairs=2)
        self.change("UPDATE metrics SET size = 7 WHERE row = 1")
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
