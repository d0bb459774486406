# SPDX-License-Identifier: MIT
"""`regista rank`: rankings from results of elsewhere, as text and as JSON, and one line for what cannot be used."""
import json
import math
import unittest

import program

TRIANGLE = "first,second,wins,draws,losses\na,b,7,0,3\na,c,9,0,1\nb,c,6,0,4\n"
PAIRS = "first,second,LL,LD,DD,WD,WW\na,b,9,20,44,30,17\nc,a,25,30,40,15,10\nb,c,12,22,41,33,12\n"


class Rank(program.Case):
    plugins = ()

    def table(self, text):
        file = self.folder / "results.csv"
        file.write_bytes(text if isinstance(text, bytes) else text.encode())  # the ends of lines as they are
        return str(file)

    def result(self, text):
        return json.loads(self.succeed("rank", self.table(text), "--json"))

    def refuse(self, text, line):
        file = self.table(text)
        self.assertEqual(self.refused("rank", file), file + ":" + line)

    def test_published_triangle(self):
        result = self.result(TRIANGLE)
        self.assertEqual((result["games"], result["pairs"]), (30, 0))
        for row, team, elo in zip(result["ranking"], "abc", (163.921, -27.823, -136.098)):
            self.assertEqual((row["team"], row["games"]), (team, 20))
            self.assertAlmostEqual(row["elo"], elo, delta=0.0005)
            self.assertLess(row["elo_interval"][0], elo)
            self.assertGreater(row["elo_interval"][1], elo)

    def test_text(self):
        self.assertEqual(self.succeed("rank", self.table("first,second,LL,LD,DD,WD,WW\na,bcd,0,1,2,3,4\n")),
                         "Ranking of 2 teams by 20 games, 10 pairs:\n"
                         "rank  team               Elo       games       points    share\n"
                         "   1  a                 95.4          20         15.0   75.0 %\n"
                         "   2  bcd              -95.4          20          5.0   25.0 %\n"
                         "Elo: Bradley and Terry, sum 0. Margins hold with 95 % and count pairs.\n"
                         "No margin: fewer than 10 pairs of the team were uneven, or it won or lost all.\n")
        text = self.succeed("rank", self.table(TRIANGLE))
        self.assertIn("Margins hold with 95 % if all games are independent: the results name no pairs.\n", text)
        self.assertIn(" +/- ", text)

    def test_strengths_that_are_not_determined(self):
        text = self.succeed("rank", self.table("first,second,wins,draws,losses\na,b,0,0,5\n"))
        self.assertIn("   1  b                    -           5          5.0  100.0 %\n", text)
        self.assertIn("The results do not determine all strengths: ", text)
        result = self.result("first,second,wins,draws,losses\na,b,0,0,5\n")
        self.assertEqual(result["ranking"][0], {"team": "b", "group": 1, "elo": None, "elo_interval": None, "games": 5, "points": 5.0})

    def test_groups_that_never_met(self):
        # Of two teams, Elo is 400 log10(points / points of the other), half of it above 0.
        groups = {"A": ("B", 7, 3), "C": ("D", 6, 2)}
        lines = "".join(f"{one},{other},{won},0,{lost}\n" for one, (other, won, lost) in groups.items())
        result = self.result("first,second,wins,draws,losses\n" + lines + "D,E,0,0,0\n")
        self.assertEqual([(row["team"], row["group"]) for row in result["ranking"]],
                         [("A", 1), ("B", 1), ("C", 2), ("D", 2), ("E", 3)])
        for row in result["ranking"][:4]:
            won, lost = next(numbers[1:] if row["team"] == one else (numbers[2], numbers[1])
                             for one, numbers in groups.items() if row["team"] in (one, numbers[0]))
            self.assertAlmostEqual(row["elo"], 200 * math.log10(won / lost), delta=1e-6)
        self.assertIsNone(result["ranking"][4]["elo"])
        text = self.succeed("rank", self.table("first,second,score\nA,B,1\nB,A,1\nC,D,1\nD,C,0\n"))
        self.assertEqual(text, "Ranking of 4 teams by 4 games, in 2 groups that never met each other:\n"
                               "rank  team               Elo       games       points    share\n"
                               "   1  A                  0.0           2          1.0   50.0 %\n"
                               "   2  B                  0.0           2          1.0   50.0 %\n"
                               "\n"
                               "   1  C                    -           2          2.0  100.0 %\n"
                               "   2  D                    -           2          0.0    0.0 %\n"
                               "The results do not determine all strengths: some teams have no game, took no point from the "
                               "others, or lost none to them.\n"
                               "Elo: Bradley and Terry, sum 0 in each group. Margins hold with 95 % if all games are "
                               "independent: the results name no pairs.\n"
                               "No margin: fewer than 10 pairs of the team were uneven, or it won or lost all.\n")

    # What people, pandas, R and chess programs write: the same games, the same ranking.
    def test_forms_of_one_table(self):
        wanted = self.result("first,second,score\nA,B,1\nA,B,0\nB,A,0.5\n")
        self.assertEqual(wanted["games"], 3)
        self.assertEqual(len(wanted["ranking"]), 2)
        for text in ('first,second,score\n"A",B,1\nA,"B",0\nB,A,.5\n',
                     '"first","second","score"\r\n"A","B","1"\r\n \r\n"A","B","0"\r\n\t\r\n"B","A","0.50"\r\n',
                     '"","first","second","score"\n"1","A","B",1\n"2","A","B",0\n"3","B","A",0.5\n',
                     "Unnamed: 0,first,second,score\n0,A,B,1.0\n1,A,B,0.0\n2,B,A,0.5\n",
                     "\ufeffscore,first,second\n1e0,A,B\n0,A,B\n5e-1,B,A\n",
                     "home,away,home_goals,away_goals\nA,B,2,0\nA,B,1.0,2.0\nB,A,3,3\n",
                     '[White "A"]\n[Black "B"]\n[Result "1-0"]\n\n1-0\n\n[Black "B"]\n[White "A"]\n[Result "0-1"]\n\n'
                     '1. e4 0-1\n\n[White "B"]\n[Black "A"]\n[Result "1/2-1/2"]\n'):
            self.assertEqual(self.result(text), wanted, text)

    def test_encodings(self):
        latin = "first,second,score\nMüller,Möller,1\nMöller,B,1\nB,Müller,1\n"
        self.assertEqual([row["team"] for row in self.result(latin)["ranking"]], ["Müller", "Möller", "B"])
        self.refuse(latin.encode("latin-1"), "2:2: byte 0xfc is not UTF-8; save the file as UTF-8")
        for utf16 in ("utf-16-le", "utf-16-be"):
            self.refuse(("\ufeff" + latin).encode(utf16), "1:1: is UTF-16 text; save the file as UTF-8")
        forms = "first,second,score\nMüller,B,1\nB,Mu\u0308ller,1\n"
        remark = '"Müller" and "Mu\u0308ller" are two teams, but one name in two forms of Unicode; use NFC.'
        self.assertEqual(self.result(forms)["remarks"], [remark])
        self.assertTrue(self.succeed("rank", self.table(forms)).endswith(remark + "\n"))

    def test_games_without_a_result(self):
        text = '[White "A"]\n[Black "B"]\n[Result "1-0"]\n\n1-0\n\n[White "A"]\n[Black "B"]\n[Result "*"]\n\n*\n'
        result = self.result(text)
        self.assertEqual(result["games"], 1)
        self.assertEqual(result["remarks"], ["1 game is left out: without a result, or in a pair with such a game."])

    # The same results in all ways to write them.
    def test_layouts_agree(self):
        as_counts = self.result(PAIRS)
        outcomes = {"LL": ("0", "0"), "LD": ("0", "0.5"), "DD": ("1", "0"), "WD": ("1", "0.5"), "WW": ("1", "1")}
        opposite = {"0": "1", "0.5": "0.5", "1": "0"}
        names = PAIRS.split("\n")[0].split(",")[2:]
        openings, answers = [], []
        for line in PAIRS.split()[1:]:
            first, second, *counts = line.split(",")
            for name, count in zip(names, counts):
                for number in range(int(count)):
                    one, other = outcomes[name]
                    openings.append(f"{name}{number},{one},{first},{second}")
                    answers.append(f"{name}{number},{opposite[other]},{second},{first}")
        # All second games stand after all first ones.
        as_games = self.result("pair,score,first,second\r\n" + "\r\n".join(openings + answers) + "\r\n")
        self.assertEqual(as_games, as_counts)
        # Without their pairs the points are the same, the margins are not.
        alone = self.result("pair,score,first,second\n" + "\n".join(f",{line.split(',', 1)[1]}" for line in openings + answers))
        self.assertEqual([row["points"] for row in alone["ranking"]], [row["points"] for row in as_counts["ranking"]])
        self.assertAlmostEqual(alone["ranking"][0]["elo"], as_counts["ranking"][0]["elo"], delta=1e-9)
        self.assertNotAlmostEqual(alone["ranking"][0]["elo_interval"][0], as_counts["ranking"][0]["elo_interval"][0],
                                  delta=0.1)

    # Who stands first in a line of counts changes nothing.
    def test_lines_of_counts_may_be_turned_round(self):
        self.assertEqual(self.result("first,second,wins,draws,losses\na,b,4,0,1\nb,a,2,0,3\na,c,9,0,1\nc,b,4,0,6\n"),
                         self.result(TRIANGLE))

    def test_counts_that_cannot_be_used(self):
        head = "first,second,wins,draws,losses\na,b,1,2,3\n"
        wanted = "is no whole number from 0 to 1000000000"
        for word in ("-2", "1.5", "x", "", "1000000001", "nan", "1e10"):
            self.refuse(head + f"a,c,4,{word},6\n", f'3:7: draws: "{word}" {wanted}')
        self.refuse("first,second,LL,LD,DD,WD,WW\na,b,1,-1,0,0,0\n", f'2:7: LD: "-1" {wanted}')
        self.refuse(head + "a,b,1000000000,0,0\n",
                    '3:18: losses: "0" brings the sum of these teams above 1000000000')
        self.refuse("first,second,score\na,b,2\n", '2:5: score: "2" is no score; expected 1, 0.5 or 0, or 1-0, 1/2-1/2 or 0-1')

    def test_lines_that_cannot_be_used(self):
        head = "first,second,wins,draws,losses\n"
        self.refuse(head + "a,a,1,2,3\n", '2:3: second: "a" stands on both sides; expected two different teams')
        self.refuse(head + ",a,1,2,3\n", '2:1: first: "" is no name of a team')
        self.refuse(head + "a,b,1,2\n", "2:1: 4 values, but the first line names 5 columns")
        pairs = "first,second,score,pair\n"
        self.refuse(pairs + "a,b,1,x\nb,a,1,x\na,b,0,x\n", '4:7: pair: "x" has two games already; a pair is two games')
        self.refuse(pairs + "a,b,1,x\nb,a,1,x\na,b,0,y\na,c,0,x\n", "4:7: this pair has one game; expected two")
        for text in (head, head + "a,b,0,0,0\n"):
            file = self.table(text)
            self.assertEqual(self.refused("rank", file), f"{file}: holds no game")

    def test_columns_that_cannot_be_used(self):
        known = "known: first, second, losses, draws, wins"
        self.refuse("first,second,wins,drawz,losses\na,b,1,2,3\n",
                    f'1:19: unknown column "drawz"; nearest: "draws"; {known}')
        self.refuse("first,second,wins,wins,losses\na,b,1,2,3\n", '1:14: column "wins" stands twice')
        kinds = "LL, LD, DD, WD, WW (pairs), wins, draws, losses (games), or a game a line: score, or home_goals, away_goals"
        self.refuse("first,second\na,b\n", f"1:1: no columns of results; expected {kinds}")
        self.refuse("first,second,score,wins\na,b,1,2\n", f"1:1: two kinds of columns of results; expected {kinds}")
        self.refuse("first,second,wins,losses\na,b,1,2\n",
                    '1:1: unknown column "draws" in this file; known: first, second, wins, losses')
        self.refuse("first,second,wins,draws,losses,pair\na,b,1,2,3,4\n", f'1:32: unknown column "pair"; {known}')
        self.refuse("first;second;score\na;b;1\n", "1:6: semicolons between columns; expected commas")

    def test_quotes_that_cannot_be_used(self):
        self.refuse('first,second,score\nA,B "C" D,1\n',
                    "2:5: a quote inside a field; expected the whole field in quotes, each quote inside it doubled")
        self.refuse('first,second,score\nA,"B,1\nC,D,1\n', "2:3: this field begins with a quote that is not closed")

    def test_files_that_cannot_be_used(self):
        self.assertEqual(self.refused("rank"), "rank: expected one file of results, 0 given; see: regista rank --help")
        self.assertIn("none.csv: cannot be opened: No such file", self.refused("rank", "none.csv"))
        self.assertIn("is a folder, not a table", self.refused("rank", str(self.folder)))
        file = self.table("")
        self.assertEqual(self.refused("rank", file), f"{file}: is empty; expected a first line with the names of columns")


if __name__ == "__main__":
    unittest.main()
