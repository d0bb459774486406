// SPDX-License-Identifier: MIT
// Tables as people and programs write them: what is read, and the line that refuses what is no table. Results of teams
// in all their forms: the same games give the same counts.
#include "study/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/table/table_from_bytes.hpp"

namespace regista::study {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Row = std::vector<std::string>;

class Tables : public testing::Test {
 protected:
  Tables() : file_(fs::temp_directory_path() / ("regista_table_" + std::to_string(getpid()) + ".csv")) {}
  ~Tables() override { fs::remove(file_); }

  const fs::path& write(const std::string& text) const {
    std::ofstream(file_, std::ios::binary) << text;
    return file_;
  }

  // All rows, that of the names first.
  std::vector<Row> rows(const std::string& text) const {
    Table table(write(text));
    std::vector<Row> out{{table.columns().begin(), table.columns().end()}};
    while (table.next()) {
      Row& row = out.emplace_back();
      for (std::size_t i = 0; i < table.columns().size(); ++i) row.emplace_back(table.text(i));
    }
    return out;
  }

  ResultsOfTeams results(const std::string& text) const { return read_results_of_teams(write(text)); }

  // What is said, from the line on: "2:5: ...".
  std::string complaint(const std::string& text) const {
    try {
      results(text);
    } catch (const config::Error& error) {
      const std::string said = error.what();
      EXPECT_EQ(said.find('\n'), std::string::npos);
      return said.substr(file_.string().size() + 1);
    }
    return "";
  }

  fs::path file_;
};

// --- Fields. The examples of RFC 4180, section 2, are among them.

TEST_F(Tables, FieldsInQuotes) {
  EXPECT_THAT(rows("a,b,c\r\n\"aaa\",\"bbb\",\"ccc\"\r\nzzz,yyy,xxx\r\n"),
              ElementsAre(Row{"a", "b", "c"}, Row{"aaa", "bbb", "ccc"}, Row{"zzz", "yyy", "xxx"}));
  EXPECT_THAT(rows("a,b,c\n\"aaa\",\"b\r\nbb\",\"ccc\"\r\n"), ElementsAre(testing::_, Row{"aaa", "b\r\nbb", "ccc"}));
  EXPECT_THAT(rows("a,b,c\n\"aaa\",\"b\"\"bb\",\"ccc\""), ElementsAre(testing::_, Row{"aaa", "b\"bb", "ccc"}));
  EXPECT_THAT(rows("\"a\",\"b, c\"\n\"\",\"\"\"\"\n\",\",\"\n\"\n"),
              ElementsAre(Row{"a", "b, c"}, Row{"", "\""}, Row{",", "\n"}));
}

TEST_F(Tables, BlanksAroundFieldsAndBlankLines) {
  EXPECT_THAT(rows("\xef\xbb\xbf\n  \n a , b\n\n\t\n 1\t,\" 2 \" \r\n \t \r\n,\n"),
              ElementsAre(Row{"a", "b"}, Row{"1", " 2 "}, Row{"", ""}));
}

TEST_F(Tables, EachFieldKnowsItsPlace) {
  Table table(write("a,b\n\n\"x\ny\"\"\", \"z\"\n1 ,\n"));
  const auto place = [&](std::size_t column) {
    return std::pair(table.where(column).line, table.where(column).column);
  };
  EXPECT_EQ(place(1), std::pair(1, 3));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(place(0), std::pair(3, 1));
  EXPECT_EQ(place(1), std::pair(4, 7));
  ASSERT_TRUE(table.next());
  EXPECT_EQ(place(1), std::pair(5, 4));
  EXPECT_FALSE(table.next());
}

TEST_F(Tables, NumbersAsProgramsWriteThem) {
  Table table(write("a,b,c,d,e,f\n1.0,.5,0.50,1e0,+1,-.25e1\n3,3.0,+3,3e0,30e-1,\"3\"\n"));
  ASSERT_TRUE(table.next());
  const std::vector<double> wanted{1.0, 0.5, 0.5, 1.0, 1.0, -2.5};
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(table.number(i), wanted[i]);
  ASSERT_TRUE(table.next());
  for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_EQ(table.count(i, 3), 3);
  for (const char* each : {"nan", "inf", "-inf", "1.5", "-1", "4", "NA", "+-1", "0x1", "1e999", "\"\"", "1 0", "+"}) {
    Table other(write("a\n" + std::string(each) + '\n'));
    ASSERT_TRUE(other.next());
    EXPECT_THROW(other.count(0, 3), config::Error) << each;
  }
  Table other(write("a\nnan\n"));
  ASSERT_TRUE(other.next());
  EXPECT_THROW(other.number(0), config::Error);
}

TEST_F(Tables, ThatAreNone) {
  EXPECT_EQ(complaint("first,second,score\nA,B\"C\",1\n"),
            "2:4: a quote inside a field; expected the whole field in quotes, each quote inside it doubled");
  EXPECT_THAT(complaint("first,second,score\n\"A\"2,B,1\n"), HasSubstr("2:4: a quote inside a field"));
  EXPECT_EQ(complaint("first,second,score\nA,\"B,1\nB,A,1\n"),
            "2:3: this field begins with a quote that is not closed");
  EXPECT_EQ(complaint("first,second,score\nA,\"B\n" + std::string(70'000, '\n')),
            "2:3: this field begins with a quote that is not closed");
  EXPECT_EQ(complaint("first;second;score\nA;B;1\n"), "1:6: semicolons between columns; expected commas");
  EXPECT_EQ(complaint("first,second,score\nA,\xc3\xa9,1\nA,M\xfcller,1\n"),
            "3:4: byte 0xfc is not UTF-8; save the file as UTF-8");
  EXPECT_EQ(complaint(std::string("\xff\xfe"
                                  "f\0i\0",
                                  6)),
            "1:1: is UTF-16 text; save the file as UTF-8");
  EXPECT_EQ(complaint(std::string("\xfe\xff"
                                  "\0f\0i",
                                  6)),
            "1:1: is UTF-16 text; save the file as UTF-8");
  EXPECT_EQ(complaint(std::string("f\0i\0", 4)), "1:2: byte 0x00 is not text; is this a binary file?");
  EXPECT_EQ(complaint("first,second,score\nA,B\n"), "2:1: 2 values, but the first line names 3 columns");
  EXPECT_EQ(complaint("\n \n"), " is empty; expected a first line with the names of columns");
}

// --- Results of teams.

TEST_F(Tables, OneTeamWithAndWithoutQuotes) {
  for (const char* text :
       {"first,second,score\n\"A\",B,1\nA,B,0\n", "\"first\",\"second\",\"score\"\n\"A\",\"B\",1.0\n A ,B,0.0\n",
        "\"\",\"first\",\"second\",\"score\"\n\"1\",\"A\",\"B\",1\n\"2\",\"A\",\"B\",0\n",
        "Unnamed: 0,score,second,first\n0,+1,B,A\n1,.0,B,A\n"}) {
    const ResultsOfTeams read = results(text);
    EXPECT_THAT(read.remarks, IsEmpty());
    ASSERT_EQ(read.teams.size(), 2u) << text;
    ASSERT_EQ(read.encounters.size(), 1u);
    EXPECT_EQ(read.encounters[0].games, (statistics::GameCounts{{1, 0, 1}})) << text;
  }
  EXPECT_THAT(results("first,second,score\n\"B-Human, Bremen\",HULKs,1\n").teams,
              ElementsAre("B-Human, Bremen", "HULKs"));
}

TEST_F(Tables, CountsMayBeWrittenAsDecimals) {
  const ResultsOfTeams read = results("first,second,wins,draws,losses\nA,B,3.0,1e0,+2\n");
  EXPECT_EQ(read.encounters.at(0).games, (statistics::GameCounts{{2, 1, 3}}));
  EXPECT_EQ(complaint("first,second,wins,draws,losses\nA,B,3.5,1,2\n"),
            "2:5: wins: \"3.5\" is no whole number from 0 to 1000000000");
  EXPECT_EQ(complaint("first,second,score\nA,B,NA\n"),
            "2:5: score: \"NA\" is no score; expected 1, 0.5 or 0, or 1-0, 1/2-1/2 or 0-1");
  EXPECT_THAT(complaint("first,second,score\nA,B,nan\n"), HasSubstr("is no score"));
  EXPECT_THAT(complaint("first,second,score\nA,B,\n"), HasSubstr("2:5: score: \"\" is no score"));
}

TEST_F(Tables, GoalsOfHomeAndAway) {
  const std::string head = "pair,home,away,home_goals,away_goals\n";
  // A wins a pair of two wins, and one of a win and a draw; the third pair lacks a match, the fourth a result.
  const ResultsOfTeams read =
      results(head + "1,A,B,2,1\n1,B,A,0,3\n2,A,B,1,1\n2,B,A,0,1.0\n3,B,A,4,0\n4,A,B,,\n4,B,A,1,0\n");
  ASSERT_EQ(read.encounters.size(), 1u);
  EXPECT_EQ(read.encounters[0].pairs, (statistics::PairCounts{{0, 0, 0, 1, 1}}));
  EXPECT_EQ(read.encounters[0].games, (statistics::GameCounts{{1, 0, 0}}));
  EXPECT_THAT(read.remarks, ElementsAre("2 games are left out: without a result, or in a pair with such a game."));
  EXPECT_EQ(results("away_goals,home_goals,away,home\n2,0,A,B\n").encounters.at(0).games,
            (statistics::GameCounts{{1, 0, 0}}));
  EXPECT_EQ(complaint(head + "1,A,B,2,\n"), "2:9: away_goals: \"\" is no whole number from 0 to 1000000000");
  EXPECT_EQ(
      complaint("home,away,home_goals,away_goal\nA,B,1,0\n"),
      "1:22: unknown column \"away_goal\"; nearest: \"away_goals\"; known: home, away, home_goals, away_goals, pair");
  EXPECT_THAT(complaint("home,away,score,away_goals\nA,B,1,0\n"), HasSubstr("1:1: two kinds of columns of results"));
  EXPECT_THAT(complaint("first,home,away,home_goals,away_goals\nA,A,B,1,0\n"),
              HasSubstr("1:1: unknown column \"first\""));
}

// As c-chess-cli and cutechess write them.
TEST_F(Tables, GamesInPgn) {
  const std::string one =
      "\n[Event \"?\"]\n[White \"engine \\\"A\\\"\"]\n[Black \"B\"]\n[Result \"1-0\"]\n[Termination \"normal\"]\n\n"
      "1. e4 {[%clk 0:01]\n[%eval 0.3]} e5 2. Qh5 1-0\n\n";
  const ResultsOfTeams read =
      results(one +
              "[Result \"1/2-1/2\"]\r\n[White \"B\"]\r\n[Black \"engine \\\"A\\\"\"]\r\n\r\n1/2-1/2\r\n\r\n"
              "[White \"B\"]\n[Black \"C\"]\n[Result \"*\"]\n\n*\n\n[White \"B\"]\n[Black \"C\"]\n[Result \"0-1\"]\n");
  EXPECT_THAT(read.teams, ElementsAre("engine \"A\"", "B", "C"));
  ASSERT_EQ(read.encounters.size(), 2u);
  EXPECT_EQ(read.encounters[0].games, (statistics::GameCounts{{0, 1, 1}}));
  EXPECT_EQ(read.encounters[1].games, (statistics::GameCounts{{1, 0, 0}}));
  EXPECT_THAT(read.remarks, ElementsAre("1 game is left out: without a result, or in a pair with such a game."));
  EXPECT_EQ(complaint(one + "[White \"A\"]\n[Black \"B\"]\n\n1. e4 1-0\n"), "11:1: this game has no header Result");
  EXPECT_EQ(complaint("[White \"A\"]\n[Black \"B\"]\n[White \"A\"]\n"),
            "3:1: a second header White of one game; expected a blank line before");
  EXPECT_EQ(complaint("[White \"A]\n[Black \"B\"]\n"), "1:8: this quote is not closed");
  EXPECT_EQ(complaint("[White \"A\"]\n[Black \"B\"]\n[Result \"2-0\"]\n"),
            "3:9: Result: \"2-0\" is no score; expected 1, 0.5 or 0, or 1-0, 1/2-1/2 or 0-1");
  EXPECT_EQ(complaint("[White \"A\"]\n[Black \"A\"]\n[Result \"1-0\"]\n"),
            "2:8: Black: \"A\" stands on both sides; expected two different teams");
  EXPECT_EQ(complaint("[Event \"x\"]\n\n*\n"), " holds no game");
}

TEST_F(Tables, OneNameInTwoFormsOfUnicode) {
  const std::string composed = "M\u00fcller", decomposed = "Mu\u0308ller";
  const ResultsOfTeams read = results("first,second,score\n" + composed + ",B,1\nB," + decomposed + ",1\n");
  EXPECT_EQ(read.teams.size(), 3u);
  EXPECT_THAT(read.remarks, ElementsAre("\"" + composed + "\" and \"" + decomposed +
                                        "\" are two teams, but one name in two forms of Unicode; use NFC."));
  EXPECT_THAT(results("first,second,score\n" + composed + ",Muller,1\n").remarks, IsEmpty());
}

// --- Any bytes are read, or refused in one line; written and read again they are the same. So does the fuzzer.

TEST_F(Tables, OfAnyBytes) {
  const std::vector<std::string> parts{"first,second,score\n",
                                       "A,B,1\n",
                                       "\"",
                                       "\"\"",
                                       ",",
                                       "\n",
                                       "\r\n",
                                       "\r",
                                       " ",
                                       "x",
                                       "\xc3\xa9",
                                       "\xff",
                                       "[White \"A\"]\n",
                                       "[Black \"B\"]\n",
                                       "[Result \"1-0\"]\n",
                                       "[",
                                       "\\",
                                       "\xef\xbb\xbf",
                                       std::string(1, '\0'),
                                       "1e999",
                                       "-",
                                       "home,away,home_goals,away_goals\n"};
  std::uint64_t state = 7;  // of a small generator: numbers alone must decide
  for (int round = 0; round < 500; ++round) {
    std::string text;
    for (int part = 0; part < 1 + round % 12; ++part) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      text += parts[(state >> 33) % parts.size()];
    }
    EXPECT_STREQ(check_table_from(file_, text), "") << testing::PrintToString(text);
  }
}

}  // namespace
}  // namespace regista::study
