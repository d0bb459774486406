# SPDX-License-Identifier: MIT
"""`regista rank`: rankings from results of elsewhere, as text and as JSON, and one line for what cannot be used."""
import json
import unittest

import program

TRIANGLE = "first,second,wins,draws,losses\na,b,7,0,3\na,c,9,0,1\nb,c,6,0,4\n"
PAIRS = "first,second,LL,LD,DD,WD,WW\na,b,9,20,44,30,17\nc,a,25,30,40,15,10\nb,c,12,22,41,33,12\n"


class Rank(program.Case):
    plugins = ()

    def table(self, text):
        file = self.folder / "results.csv"
        file.write_bytes(text.encode())  # the ends of lines as they are
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

    def test_strengths_that_are_not_told(self):
        text = self.succeed("rank", self.table("first,second,wins,draws,losses\na,b,0,0,5\n"))
        self.assertIn("   1  b                    -           5          5.0  100.0 %\n", text)
        self.assertIn("The results do not tell the strengths: ", text)
        result = self.result("first,second,wins,draws,losses\na,b,0,0,5\n")
        self.assertEqual(result["ranking"][0], {"team": "b", "elo": None, "elo_interval": None, "games": 5, "points": 5.0})

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
        for word in ("-2", "1.5", "x", "", "1000000001", "nan", "1e3"):
            self.refuse(head + f"a,c,4,{word},6\n", f'3:7: draws: "{word}" {wanted}')
        self.refuse("first,second,LL,LD,DD,WD,WW\na,b,1,-1,0,0,0\n", f'2:7: LD: "-1" {wanted}')
        self.refuse(head + "a,b,1000000000,0,0\n",
                    '3:18: losses: "0" brings the sum of these teams above 1000000000')
        self.refuse("first,second,score\na,b,2\n", '2:5: score: "2" is no score; expected 1, 0.5 or 0')

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
        known = "known: first, second, wins, draws, losses, score, pair, LL, LD, DD, WD, WW"
        self.refuse("first,second,wins,drawz,losses\na,b,1,2,3\n",
                    f'1:19: unknown column "drawz"; nearest: "draws"; {known}')
        self.refuse("first,second,wins,wins,losses\na,b,1,2,3\n", '1:14: column "wins" stands twice')
        kinds = "LL, LD, DD, WD, WW (pairs), wins, draws, losses (games), or score (a game a line)"
        self.refuse("first,second\na,b\n", f"1:1: no columns of results; expected {kinds}")
        self.refuse("first,second,score,wins\na,b,1,2\n", f"1:1: two kinds of columns of results; expected {kinds}")
        self.refuse("first,second,wins,losses\na,b,1,2\n",
                    '1:1: no column "draws"; this file has: "first", "second", "wins", "losses"')
        self.refuse("first,second,wins,draws,losses,pair\na,b,1,2,3,4\n", '1:32: column "pair" needs a column "score"')

    def test_files_that_cannot_be_used(self):
        self.assertEqual(self.refused("rank"), "rank: expected one file of results, 0 given; see: regista rank --help")
        self.assertIn("none.csv: cannot be opened: No such file", self.refused("rank", "none.csv"))
        self.assertIn("is a folder, not a table", self.refused("rank", str(self.folder)))
        file = self.table("")
        self.assertEqual(self.refused("rank", file), f"{file}: is empty; expected a first line with the names of columns")


if __name__ == "__main__":
    unittest.main()
