// SPDX-License-Identifier: MIT
// What reports say of matches that could not be played, that were not reproducible, and in which plugins wrote to
// standard error.
#include "report/match_remarks.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

#include "course.hpp"
#include "report/standing.hpp"
#include "report/tournament_report.hpp"
#include "statistics/paired_tests.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Pairs that the first team wins, and pairs that cannot be played.
void take(Course& course, int won, int lost, int not_played) {
  const auto pair = [&](const campaign::MatchResult& first, const campaign::MatchResult& second) {
    course.take(first);
    course.take(second);
  };
  for (int i = 0; i < won; ++i) pair(match(1, 0), match(0, 1));
  for (int i = 0; i < lost; ++i) pair(match(0, 1), match(1, 0));
  for (int i = 0; i < not_played; ++i) pair(match(0, 0), unplayed("died\x1b[2J"));
}

std::string page_of(const Course& course) {
  TournamentHistory record(course.plan, *course.tournament);
  return tournament_page(course.view(), record);
}

TEST(Unplayed, WhatIsNotListedIsCounted) {
  for (const auto& [pairs, more] :
       {std::pair{100, ""}, {101, "  and 1 match more\n"}, {102, "  and 2 matches more\n"}}) {
    Course course({"new", "old"}, 200);
    take(course, 0, 0, pairs);
    EXPECT_THAT(section_text(unplayed_section(static_cast<std::uint64_t>(pairs), course.tournament->remarks())),
                EndsWith(std::string("died\\x1b[2J\n") + more))
        << pairs;
  }
}

TEST(Unplayed, AFixedNumberOfPairs) {
  // Twelve won pairs to none are found; with nine more lost by all that can be lost they are not.
  Course course({"new", "old"}, 21);
  take(course, 12, 0, 9);
  EXPECT_LT(statistics::sign_flip_p({{2, 12}}), 0.05);
  EXPECT_GT(statistics::sign_flip_p({{-20, 1}, {2, 12}}), 0.05);
  const TournamentVerdict verdict = tournament_verdict(course.view());
  EXPECT_EQ(plain(verdict.sentence), "No verdict: 9 pairs could not be played.");
  const std::string text = tournament_text(course.view());
  EXPECT_THAT(text, AllOf(HasSubstr("\nNo verdict: 9 pairs could not be played.\n"),
                          HasSubstr("  match 26: died\\x1b[2J\n"), HasSubstr("  match 42: died"), Not(HasSubstr("Elo")),
                          Not(HasSubstr("LOS")), Not(HasSubstr("Ptnml"))));
  ASSERT_EQ(verdict.beside.size(), 1u);
  EXPECT_THAT(plain(verdict.beside[0]), HasSubstr("9 pairs could not be played"));
  const auto json = nlohmann::json::parse(tournament_json(course.view()));
  EXPECT_EQ(json["unplayed"]["pairs"], 9);
  EXPECT_EQ(json["unplayed"]["listed"][0]["match"], 26);
  EXPECT_EQ(json["unplayed"]["listed"][0]["what"], "died\x1b[2J");
  EXPECT_EQ(json["pairings"][0]["verdict_prevented"], true);
  EXPECT_EQ(json["pairings"][0]["unplayed_pairs"], 9);
  for (const char* each : {"elo", "elo_interval", "nelo", "los"}) EXPECT_FALSE(json["pairings"][0].contains(each));
  EXPECT_EQ(json["matches"], 24);
  const std::string page = page_of(course);
  EXPECT_THAT(page, AllOf(HasSubstr("<h1 id=\"verdict\">No verdict: 9 pairs could not be played.</h1>"),
                          HasSubstr("id=\"unplayed\""), Not(HasSubstr("\x1b")), Not(HasSubstr("(LOS)")),
                          Not(HasSubstr("Normalised Elo"))));
}

TEST(Unplayed, AVerdictThatHoldsEitherWayIsGiven) {
  Course course({"new", "old"}, 41);
  take(course, 40, 0, 1);
  EXPECT_THAT(plain(tournament_verdict(course.view()).sentence), AllOf(HasSubstr("new"), HasSubstr(" beats ")));
  const PValues p = p_values(*course.tournament);
  EXPECT_EQ(p.single[0], statistics::sign_flip_p({{-20, 1}, {2, 40}}));
  EXPECT_FALSE(p.prevented[0]);
  EXPECT_THAT(
      tournament_text(course.view()),
      AllOf(HasSubstr("1 pair could not be played and is left out of every number"), Not(HasSubstr("No verdict"))));
}

// By brute force over counts: found is what is found in all three ways, for the same team.
TEST(Unplayed, TheFindingOfAFixedNumberIsThatOfAllThreeWays) {
  std::array<int, 3> seen{};
  for (int won = 0; won <= 60; won += 6) {
    for (int lost = 0; lost <= 60; lost += 6) {
      for (const int not_played : {0, 1, 3, 12}) {
        if (won + lost == 0) continue;
        Course course({"a", "b"}, static_cast<std::uint64_t>(won + lost + not_played));
        take(course, won, lost, not_played);
        const auto found = [&](int unplayed) {
          const statistics::WholeCounts goals{{-2, lost}, {2, won}, {20 * (unplayed > 0 ? 1 : -1), std::abs(unplayed)}};
          const int more = 2 * (won - lost) + 20 * unplayed;
          return statistics::sign_flip_p(goals) < 0.05 ? (more > 0 ? 1 : -1) : 0;
        };
        const std::array<int, 3> ways{found(0), found(-not_played), found(not_played)};
        const bool same = ways[0] == ways[1] && ways[0] == ways[2];
        const PValues p = p_values(*course.tournament);
        EXPECT_EQ(p.adjusted[0] < 0.05, same && ways[0] != 0) << won << ' ' << lost << ' ' << not_played;
        EXPECT_EQ(p.prevented[0], !same) << won << ' ' << lost << ' ' << not_played;
        ++seen[!same ? 0 : ways[0] != 0 ? 1 : 2];
      }
    }
  }
  for (const int each : seen) EXPECT_GT(each, 10);
}

TEST(Unplayed, ASequentialTest) {
  Course course({"a", "b"}, 1000, sprt(0, 100));
  take(course, 0, 0, 40);
  take(course, 200, 0, 0);
  ASSERT_EQ(course.tournament->verdict(), study::Verdict::prevented);
  EXPECT_THAT(tournament_text(course.view()), HasSubstr("No verdict: 40 pairs could not be played.\n"));
  EXPECT_EQ(nlohmann::json::parse(tournament_json(course.view()))["verdict"], "NO_VERDICT");
  EXPECT_EQ(plain(tournament_verdict(course.view()).sentence), "No verdict: 40 pairs could not be played.");
}

// Who leads must lead with all of them lost, too.
TEST(Unplayed, NobodyLeadsByThem) {
  for (const bool by_them : {false, true}) {
    Course course({"a", "b", "c"}, 20);
    for (int pair = 0; pair < 20; ++pair) {
      for (const study::Pairing& pairing : course.tournament->calendar().pairings()) {
        // The team of the smaller number wins three of four pairs; half of the others' wins over it are not played.
        const bool wins = pair % 4 != 0;
        const bool lost_to_first = !wins && pairing.first == 0;
        course.take(by_them && (lost_to_first || pair % 2 == 1) ? unplayed() : wins ? match(1, 0) : match(0, 1));
        course.take(wins ? match(0, 1) : match(1, 0));
      }
    }
    const std::string sentence = plain(tournament_verdict(course.view()).sentence);
    if (by_them)
      EXPECT_THAT(sentence, StartsWith("No verdict: "));
    else
      EXPECT_THAT(sentence, HasSubstr("; a has the highest rating."));
  }
}

TEST(Remarks, StandAtTheTopAndAtTheEnd) {
  Course course({"a", "b"}, 2);
  campaign::MatchResult odd = match(1, 0), noisy = match(0, 1);
  odd.irreproducible = "tick 7 of robot 2: plugin dice";
  noisy.output = "hello";
  noisy.kept = "home: plugins keep in memory that all their instances share: greedy.so: taken";
  for (const campaign::MatchResult* each : {&odd, &noisy, &noisy, &odd}) course.take(*each);
  const std::string text = tournament_text(course.view());
  EXPECT_THAT(text,
              StartsWith("not reproducible: match 1: tick 7 of robot 2: plugin dice\nnot reproducible: match 4: "));
  EXPECT_THAT(
      text,
      HasSubstr(
          "\nmatch 2: home: plugins keep in memory that all their instances share: greedy.so: taken; nothing "
          "came of it in this match\nplugins wrote to standard error in 2 matches, first in match 2; see: regista "
          "report FILE "
          "--standard-error 2\n\n"
          "Not decided between a and b. 2 pairs cannot give a verdict: at least 6 are needed.\n"));
  const auto json = nlohmann::json::parse(tournament_json(course.view()));
  EXPECT_EQ(json["not_reproducible"]["listed"][1]["match"], 4);
  EXPECT_EQ(json["standard_error"], nlohmann::json::parse(R"({"matches": 2, "listed": [2, 3]})"));
  EXPECT_EQ(json["kept_outside"]["matches"], 2);
  const std::string page = page_of(course);
  EXPECT_LT(page.find("<strong>not reproducible:</strong>"), page.find("id=\"verdict\""));
  EXPECT_THAT(page, HasSubstr("plugins wrote to standard error in 2 matches"));
  Course quiet({"a", "b"}, 1);
  quiet.take(match(1, 0));
  quiet.take(match(1, 0));
  EXPECT_THAT(tournament_text(quiet.view()), AllOf(Not(HasSubstr("standard error")), Not(HasSubstr("reproducible")),
                                                   Not(HasSubstr("could not be played"))));
}

TEST(Remarks, TheHeadlineSaysThatRobotsDoNotDecideAlone) {
  Course course({"a", "b"}, 2);
  campaign::MatchResult shared = match(1, 0), unproven = match(1, 0);
  shared.shared = "home, robot 2, tick 19 (1.94 s): plugin table answered assign otherwise";
  unproven.unproven = "this system does not confine processes (seccomp)";
  for (const campaign::MatchResult* each : {&shared, &unproven, &unproven, &unproven}) course.take(*each);
  const std::string text = tournament_text(course.view());
  EXPECT_THAT(text, StartsWith("robots do not decide alone: match 1: home, robot 2, tick 19 (1.94 s): plugin table "
                               "answered assign otherwise\nnot proven that robots decide alone: match 2: "));
  EXPECT_THAT(text, HasSubstr("\nNot a result of robots that decide alone: Not decided between "));
  const auto json = nlohmann::json::parse(tournament_json(course.view()));
  EXPECT_EQ(json["not_alone"]["matches"], 1);
  EXPECT_EQ(json["not_alone"]["listed"][0]["what"], shared.shared);
  EXPECT_EQ(json["not_proven"]["matches"], 3);
  EXPECT_EQ(json["not_reproducible"]["matches"], 0);
  const std::string page = page_of(course);
  EXPECT_LT(page.find("<strong>robots do not decide alone:</strong>"), page.find("id=\"verdict\""));
  EXPECT_THAT(page, HasSubstr("<h1 id=\"verdict\">Not a result of robots that decide alone: "));
}

TEST(Remarks, TheHeadlineSaysThatRobotsMayShareMemory) {
  EXPECT_EQ(caution({}, {}), "");
  EXPECT_EQ(caution({}, {.allow_shared_memory = true}), "Robots of a team may share memory here: ");
}

TEST(Remarks, AForfeitOfATeamWhosePluginIsNotKnown) {
  const campaign::Failure failure{0, "", "", 0, 0, "left 2 threads behind"};
  EXPECT_EQ(forfeit_text("small", failure), "forfeited by small: a plugin of small: left 2 threads behind");
  Course course({"small", "b"}, 1);
  course.take(campaign::forfeit(failure, 1.0));
  course.take(match(1, 0));
  EXPECT_THAT(tournament_text(course.view()),
              HasSubstr("forfeited by small: a plugin of small: left 2 threads behind; the first again: again 0\n"));
  EXPECT_THAT(page_of(course), HasSubstr("a plugin of <bdi>small</bdi>"));
}

// What a page tells of matches is that of the pairs that count.
TEST(Remarks, TheRecordOfACourseLeavesPairsOutThatCouldNotBePlayed) {
  const auto of = [](bool with) {
    Course course({"a", "b"}, 10);
    TournamentHistory record(course.plan, *course.tournament);
    const auto take = [&](const campaign::MatchResult& decided) {
      course.take(decided);
      record.take(&decided);
    };
    for (int i = 0; i < 5; ++i) {
      if (with) {
        take(i % 2 == 0 ? match(9, 0, R"({"packets":[7,8]})") : unplayed());
        take(i % 2 == 0 ? unplayed() : match(9, 0, R"({"packets":[7,8]})"));
      }
      take(match(i, 1, R"({"packets":[1,2]})"));
      take(match(1, 2, R"({"packets":[3,4]})"));
    }
    record.end();
    return std::tuple(record.goals_of(0).played, record.goals_of(1).played, record.numbers().find(0, "packets")->mean(),
                      record.numbers().find(0, "packets")->count());
  };
  EXPECT_EQ(of(false), of(true));
}

}  // namespace
}  // namespace regista::report
