// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "course.hpp"
#include "report/number.hpp"
#include "report/tournament_report.hpp"

namespace regista::report {
namespace {

// Of a table without metrics.
std::string line(const Course& course, std::uint64_t index, const campaign::MatchResult& decided) {
  match::MetricColumns none;
  return csv_line(course.view(), index, decided, none);
}

TEST(CsvText, FieldsThatASpreadsheetWouldRun) {
  for (const char* each : {"=1+1", "+1", "-1", "@x", "\tx"}) EXPECT_EQ(csv_field(each), std::string("'") + each);
  EXPECT_EQ(csv_field("\rx"), "\"'\rx\"");
  EXPECT_EQ(csv_field("=a,\"b\""), "\"'=a,\"\"b\"\"\"");
  EXPECT_EQ(csv_field("a-b=c"), "a-b=c");
  EXPECT_EQ(csv_field(""), "");
}

TEST(TournamentCsv, Head) {
  EXPECT_EQ(csv_head({}),
            "row,pair,seed,opening,home,away,home_goals,away_goals,ended,state_hash,forfeited_by,plugin,call,why\n");
  EXPECT_THAT(csv_head({.of_teams = {"packets", "a,b"}, .of_match = {"ball_rests", "c,d"}}),
              testing::EndsWith(",why,home.packets,away.packets,\"home.a,b\",\"away.a,b\",ball_rests,\"c,d\"\n"));
}

TEST(TournamentCsv, ALineForAMatch) {
  Course course({"new", "old"}, 10);
  course.plan.asked.seed = 7;
  course.tournament.emplace(course.plan);
  EXPECT_EQ(line(course, 3, match(2, 1)), "4,2,8,,old,new,2,1,full_time,9f2c,,,,\n");
  EXPECT_EQ(line(course, 2, failed(1)),
            "3,2,8,,new,old,10,0,forfeit,,away,greedy,assign,Segmentation "
            "fault\n");
}

TEST(TournamentCsv, OpeningsAreCalledByTheNamesOfTheirFiles) {
  Course course({"new", "old"}, 10);
  course.plan.openings = {{"openings/corner kick.yaml", {}}, {"a,b.yaml", {}}};
  course.tournament.emplace(course.plan);
  EXPECT_EQ(line(course, 0, match(0, 0)), "1,1,1,corner kick,new,old,0,0,full_time,9f2c,,,,\n");
  EXPECT_EQ(line(course, 2, match(0, 0)), "3,2,2,\"a,b\",new,old,0,0,full_time,9f2c,,,,\n");
}

TEST(TournamentCsv, FieldsThatHoldSignsOfATable) {
  Course course({"a, \"b\"", "c\nd"}, 10);
  EXPECT_EQ(line(course, 0, failed(0, "x\r\ny,\"z\"")),
            "1,1,1,,\"a, \"\"b\"\"\",\"c\nd\",0,10,forfeit,,home,greedy,assign,\"x\r\ny,\"\"z\"\"\"\n");
}

TEST(TournamentCsv, MetricsOfBothSidesAndNothingWhereThereAreNone) {
  Course course({"a", "b"}, 10);
  const campaign::MatchResult decided = match(0, 0, R"({"packets":[3,0.1],"agreement":[null,1e300]})");
  match::MetricColumns columns({.of_teams = {"packets", "agreement"}, .of_match = {}});
  EXPECT_EQ(csv_line(course.view(), 0, decided, columns), "1,1,1,,a,b,0,0,full_time,9f2c,,,,,3,0.1,,1e+300\n");
  EXPECT_EQ(csv_line(course.view(), 0, failed(0), columns),
            "1,1,1,,a,b,0,10,forfeit,,home,greedy,assign,Segmentation fault,,,,\n");
}

TEST(TournamentCsv, MetricsOfTheMatchStandOnceAfterThoseOfTheTeams) {
  Course course({"a", "b"}, 10);
  const campaign::MatchResult decided = match(0, 0, R"({"packets":[3,4],"ball_rests":17,"ball_rest_seconds":null})");
  match::MetricColumns columns(
      {.of_teams = {"packets"}, .of_match = {"ball_rests", "ball_rest_seconds", "ball_crowd_seconds"}});
  EXPECT_EQ(csv_line(course.view(), 0, decided, columns), "1,1,1,,a,b,0,0,full_time,9f2c,,,,,3,4,17,,\n");
  EXPECT_EQ(csv_line(course.view(), 0, failed(0), columns),
            "1,1,1,,a,b,0,10,forfeit,,home,greedy,assign,Segmentation fault,,,,,\n");
}

}  // namespace
}  // namespace regista::report
