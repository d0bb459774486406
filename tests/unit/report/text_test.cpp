// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "course.hpp"
#include "report/standing.hpp"
#include "statistics/sequential_test.hpp"

namespace regista::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(TournamentText, ThePublishedPairsInTheFormThatPeopleKnow) {
  Course course({"new", "old"}, 290);
  course.plan.asked.seed = 7;
  course.plan.asked.settings.limit = 12.5;
  course.take_pairs({{34, 54, 63, 64, 75}});
  const std::string text = without_played(tournament_text(course.view()));
  // Won: 2 * 75 + 64 + 63, for the pairs that ended even are a win and a loss each.
  EXPECT_THAT(text, StartsWith("Tournament: new vs old (290 pairs, seeds from 7, 12.5 s a match)\n"
                               "\nStanding\n"
                               "Games: 580, Wins: 277, Losses: 185, Draws: 118, Points: 336.0 (57.93 %)\n"
                               "Goals: 277:185, per match +0.159 [0.081, 0.236], 95 % by Student's t\n"
                               "p 0.0001: exact sign flips of the pairs' goal differences\n"
                               "Ptnml(0-2): [34, 54, 63, 64, 75]\n"
                               "Elo: 55.58 +/- 27.82, nElo: 57.94 +/- 29.41\n"
                               "LOS: 100.00 %, DrawRatio: 21.72 %, PairsRatio: 1.58\n"));
  EXPECT_THAT(text, HasSubstr("\n\nnew beats old by 0.159 goals a match (95 % interval 0.081 to 0.236).\nAfter 290 "
                              "pairs of matches new has 336.0 of 580 points (58 %), "
                              "goals 277:185.\nIf the teams were equal, "));
  EXPECT_THAT(text, Not(HasSubstr("test accepted")));
}

TEST(TournamentText, TheRatioOfTheTestWithItsBounds) {
  Course course({"a", "b"}, 1000, sprt(0, 100));
  course.take_pairs({{3, 4, 6, 5, 4}});
  const auto ratio = statistics::log_likelihood_ratio(score_law(course.tournament->meetings().front().pairs),
                                                      statistics::Model::normalized, {0, 100});
  const std::string text = tournament_text(course.view());
  ASSERT_LT(ratio.value, 0.0);
  EXPECT_THAT(text, HasSubstr(fmt::format("LLR: {:.2f} ({:.1f} %) (-2.94, 2.94) [0.00, 100.00] normalized", ratio.value,
                                          ratio.value / 2.944439 * 100.0)));
  EXPECT_THAT(text, HasSubstr("\nNo verdict yet on a and b."));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("biased")), Not(HasSubstr("t test"))));
}

TEST(TournamentText, VerdictsInWords) {
  Course better({"a", "b"}, 1000, sprt(0, 100, statistics::Model::logistic));
  better.take_pairs({{0, 0, 1, 2, 97}});
  std::string text = tournament_text(better.view());
  EXPECT_THAT(
      text,
      HasSubstr("\nThe test accepted H1: the scores speak for a strength of 100 rather than 0 Elo; error rates "));
  EXPECT_THAT(text, HasSubstr("\nElo and the other estimates are biased towards the verdict"));
  EXPECT_THAT(text, HasSubstr("] logistic"));

  Course worse({"a", "b"}, 1000, sprt(0, 100));
  worse.take_pairs({{97, 2, 1, 0, 0}});
  text = tournament_text(worse.view());
  EXPECT_THAT(text, HasSubstr("\nThe test accepted H0: the scores speak for a strength of 0 rather than 100 nElo; "));
}

TEST(TournamentText, VerdictsOnValues) {
  for (const bool more : {true, false}) {
    Course goals({"a", "b"}, 1000, study::ValueTest{study::goals_value, 0.05});
    goals.take_pairs({more ? std::array{0, 0, 0, 0, 400} : std::array{400, 0, 0, 0, 0}});
    std::string text = tournament_text(goals.view());
    EXPECT_THAT(text, HasSubstr(more ? "\na scores more goals than b.\n" : "\nb scores more goals than a.\n"));

    Course metric({"a", "b"}, 1000, study::ValueTest{"packets", 0.05});
    const std::string less = R"({"packets":[3,5]})", greater = R"({"packets":[5,3]})";
    for (int i = 0; i < 40; ++i) {
      metric.take(match(0, 0, more ? greater : less));
      metric.take(match(0, 0, more ? less : greater));
    }
    text = tournament_text(metric.view());
    EXPECT_THAT(text,
                HasSubstr(more ? "\na mostly has more packets than b.\n" : "\na mostly has less packets than b.\n"));
    EXPECT_THAT(text, HasSubstr(more ? "packets: 5 and 3 per match, difference +2 ["
                                     : "packets: 3 and 5 per match, "
                                       "difference -2 ["));
    EXPECT_THAT(text, HasSubstr(more ? "a has less in 0, as much in 0, more in 40 pairs" : "a has less in 40, "));
    EXPECT_THAT(text, Not(HasSubstr("pairs without it")));
  }
}

// The test is one of signs: what it finds need not be what the means say.
TEST(TournamentText, AVerdictThatTheMeanContradictsSaysSo) {
  Course course({"a", "b"}, 1000, study::ValueTest{"packets", 0.05});
  for (int i = 0; i < 200 && course.tournament->verdict() == study::Verdict::inconclusive; ++i) {
    const bool rare = i % 8 == 0;
    course.take(match(0, 0, rare ? R"({"packets":[0,90]})" : R"({"packets":[5,4]})"));
    course.take(match(0, 0, rare ? R"({"packets":[90,0]})" : R"({"packets":[4,5]})"));
  }
  EXPECT_THAT(tournament_text(course.view()),
              AllOf(HasSubstr("\na mostly has more packets than b.\n"),
                    HasSubstr("\nBut the mean points the other way: a few pairs differ much in that direction.\n")));
}

TEST(TournamentText, PairsWithoutAMetricAreCounted) {
  Course course({"a", "b"}, 1000, study::ValueTest{"packets", 0.05});
  course.take(match(0, 0, R"({"packets":[3,5]})"));
  course.take(failed(0));
  EXPECT_THAT(tournament_text(course.view()),
              HasSubstr("1 pair without it: a match was forfeited, or has no such number\n"));
}

TEST(TournamentText, WhatNothingIsKnownOf) {
  Course course({"a", "b"}, 10);
  std::string text = without_played(tournament_text(course.view()));
  EXPECT_EQ(text,
            "Tournament: a vs b (0 pairs of 10, seeds from 1)\n\nStanding\n"
            "Games: 0, Wins: 0, Losses: 0, Draws: 0, Points: 0.0 (0.00 %)\n"
            "Goals: 0:0\nPtnml(0-2): [0, 0, 0, 0, 0]\n"
            "\nNo pair of matches has been played to its end yet: nothing can be said.\n");
  course.take_pairs({{0, 0, 0, 0, 1}});
  text = without_played(tournament_text(course.view()));
  EXPECT_THAT(text, HasSubstr("(1 pair of 10, seeds from 1)"));
  EXPECT_THAT(text, HasSubstr("Elo: at least -636.43, nElo: "));
  EXPECT_THAT(text, HasSubstr("PairsRatio: -\n"));
  EXPECT_THAT(text, HasSubstr("Variance ratio of pairing: - of scores, - of goals\n"));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

// A minus before nothing but zeros is a rounding that looks like a finding.
TEST(TournamentText, NoMinusBeforeNothing) {
  const auto nothing = testing::ContainsRegex("[^0-9]-0(\\.0+)?[^0-9.]");
  for (const std::array<int, 5>& counts :
       {std::array{0, 0, 50, 0, 0}, std::array{7, 9, 20, 9, 7}, std::array{3, 0, 90000, 1, 2},
        std::array{1, 0, 0, 0, 1}, std::array{20001, 0, 0, 0, 20000}, std::array{20000, 0, 0, 0, 20000}}) {
    for (const study::Objective& objective : {study::Objective(study::FixedNumber{}), study::Objective(sprt(-20, 20)),
                                              study::Objective(study::ValueTest{study::goals_value, 1e-9})}) {
      Course course({"a", "b"}, 100'000, objective);
      course.take_pairs({counts});
      EXPECT_THAT(tournament_text(course.view()), Not(nothing));
    }
  }
  Course three({"a", "b", "c"});
  three.take_pairs({{0, 0, 3, 0, 0}, {0, 0, 3, 0, 0}, {0, 0, 3, 0, 0}});
  EXPECT_THAT(tournament_text(three.view()), Not(nothing));
  Course metric({"a", "b"}, 100, study::ValueTest{"packets", 0.05});
  for (int i = 0; i < 10; ++i) metric.take(match(0, 0, R"({"packets":[5,5]})"));
  EXPECT_THAT(tournament_text(metric.view()), Not(nothing));
}

TEST(TournamentText, EqualTeamsAreCalledSo) {
  Course course({"a", "b"}, 10);
  course.plan.teams[1].inputs = course.plan.teams[0].inputs;
  EXPECT_THAT(tournament_text(course.view()),
              HasSubstr("\nA/A: a and b are equal, so every pair is a draw by construction\n"));
}

TEST(TournamentText, FailuresTellWhoAndHowToSeeItAgain) {
  Course course({"good", "bad"}, 20);
  course.plan.asked.failures_in_a_row = 3;
  for (int i = 0; i < 2; ++i) {
    course.take(failed(1, "Segmentation\nfault"));
    course.take(failed(0, "Segmentation\nfault"));
  }
  const std::string text = tournament_text(course.view());
  EXPECT_THAT(text, HasSubstr("\nbad was set aside after pair 2: its plugin greedy failed 4 times in a row.\n"));
  EXPECT_THAT(text, HasSubstr("\n\nForfeits\n  4 matches forfeited by bad: plugin greedy, assign: Segmentation"));
  EXPECT_THAT(text, HasSubstr("; the first again: again 0\n"));
  EXPECT_THAT(text, Not(HasSubstr("Segmentation\nfault")));
  EXPECT_THAT(text, HasSubstr("good vs bad (2 pairs of 20, "));
  Course once({"good", "bad"}, 20);
  once.take(failed(1));
  EXPECT_THAT(tournament_text(once.view()), HasSubstr("\n  1 match forfeited by bad: plugin greedy, assign: "));
}

TEST(TournamentText, OfManyReasonsAHundredAreToldAndTheOthersCounted) {
  Course course({"good", "bad"}, 60);
  course.plan.asked.failures_in_a_row = 0;
  int played = 0;
  const auto play = [&](int matches) {
    for (; played < matches; ++played) course.take(failed(1 - played % 2, fmt::format("reason {}", played)));
    return tournament_text(course.view());
  };
  EXPECT_THAT(play(100), Not(HasSubstr("for other reasons")));
  EXPECT_THAT(play(101), HasSubstr("\n  1 more match forfeited for other reasons\n"));
  EXPECT_THAT(play(104), HasSubstr("\n  4 more matches forfeited for other reasons\n"));
}

TEST(TournamentText, ThreeTeamsAreRanked) {
  Course course({"the longest name of all", "b", "c"}, 5);
  course.take_pairs({{1, 0, 1, 0, 3}, {0, 0, 1, 0, 4}, {2, 0, 0, 0, 3}});
  const std::string text = without_played(tournament_text(course.view()));
  EXPECT_THAT(text, StartsWith("Tournament: 3 teams, round robin (5 pairs each, seeds from 1)\n\nStanding\n"
                               "Rank  Team                     "));
  EXPECT_THAT(text, HasSubstr("Nash share"));
  const std::size_t first = text.find("\n   1  the longest name of all "), second = text.find("\n   2  b "),
                    third = text.find("\n   3  c ");
  ASSERT_NE(third, std::string::npos);
  EXPECT_LT(first, second);
  EXPECT_LT(second, third);
  EXPECT_THAT(text, testing::ContainsRegex("  \\+163.9 +1.00 +20 +16 +0 +4 +16.0 +16:4 +0\n"));
  EXPECT_THAT(text, HasSubstr("\nNo margin: fewer than 10 pairs of the team were uneven, or it won or lost all.\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\n\n3 pairings, from the point of view of the team named first; p: exact "
                                           "sign flips of the pairs' goal differences, corrected by Holm\n"
                                           "Pairing +Won - drawn - lost +Goals +Goals a match +p \\(Holm\\)\n"
                                           "the longest name of all - b +7 - 0 - 3 +7:3 "));
  EXPECT_THAT(text, testing::ContainsRegex("\nb - c +6 - 0 - 4 +6:4 "));
  std::size_t columns = 0;
  for (std::size_t begin = text.find("Rank"), line = 0; line < 4; ++line) {
    const std::size_t end = text.find('\n', begin);
    if (line > 0) {
      EXPECT_EQ(end - begin, columns) << "line " << line;
    }
    columns = end - begin;
    begin = end + 1;
  }
  Course longer({"a", "b", "c"}, 20);
  longer.take_pairs({{{3, 2, 4, 5, 6}}, {{2, 2, 2, 6, 8}}, {{3, 4, 2, 5, 6}}});
  EXPECT_THAT(tournament_text(longer.view()), testing::ContainsRegex("\n   1  a +\\+[0-9.]+ \\+/- [0-9.]+ "));
  EXPECT_THAT(tournament_text(longer.view()), Not(HasSubstr("No margin")));
  course.plan.asked.format = config::Tournament::Format::gauntlet;
  EXPECT_THAT(title(course.view()), StartsWith("3 teams, gauntlet ("));
}

TEST(TournamentText, TeamsThatNeverMetHaveNoNashShare) {
  Course course({"a", "b", "c"}, 5);
  course.plan.asked.format = config::Tournament::Format::gauntlet;
  course.tournament.emplace(course.plan);
  course.take_pairs({{1, 0, 1, 0, 3}, {0, 0, 1, 0, 4}});
  EXPECT_THAT(tournament_text(course.view()), Not(HasSubstr("Nash")));
  EXPECT_THAT(tournament_page(course.view(), TournamentHistory(course.plan, *course.tournament)),
              Not(HasSubstr("Nash")));
  EXPECT_THAT(tournament_json(course.view()), HasSubstr("\"nash\":null"));
}

// The pairs of the title are those that the schedule has come through, whoever still plays.
TEST(TournamentText, TheTitleOfATournamentWhoseLastTeamWasSetAside) {
  Course course({"a", "b", "c"}, 6);
  course.plan.asked.failures_in_a_row = 2;
  for (std::uint64_t i = 0; i < course.plan.matches(); ++i) {
    const study::Fixture fixture = course.tournament->calendar().at(i);
    course.take(fixture.home == 2 ? failed(0) : fixture.away == 2 ? failed(1) : match(1, 0));
  }
  EXPECT_EQ(title(course.view()), "3 teams, round robin (6 pairs each, seeds from 1)");
}

TEST(TournamentText, AnOpeningOrMore) {
  Course course({"a", "b"}, 6);
  course.plan.openings = {{"corner.yaml", {}}};
  EXPECT_EQ(title(course.view()), "a vs b (0 pairs of 6, seeds from 1, 1 scene)");
  course.plan.openings.push_back({"free.yaml", {}});
  EXPECT_EQ(title(course.view()), "a vs b (0 pairs of 6, seeds from 1, 2 scenes)");
  // A fixed number of pairs takes the scenes in their order.
  for (int i = 0; i < 41; ++i) course.plan.openings.push_back({"more.yaml", {}});
  EXPECT_EQ(title(course.view()), "a vs b (0 pairs of 6, seeds from 1, the first 6 of 43 scenes)");
  // Their mean length, each ended by the limit at the latest.
  course.plan.openings = {{"corner.yaml", {}, 20.0}, {"free.yaml", {}, 61.0}};
  EXPECT_EQ(title(course.view()), "a vs b (0 pairs of 6, seeds from 1, 2 scenes of about 40 s)");
  course.plan.asked.settings.limit = 30.0;
  EXPECT_EQ(title(course.view()), "a vs b (0 pairs of 6, seeds from 1, 2 scenes of about 25 s)");
}

// What a terminal cannot show is written otherwise where it is ours, and never where it is somebody's.
TEST(OutlineText, SignsOfUsersStay) {
  Course course({"a ±1–2", "b", "c"}, 5);
  course.plan.asked.teams[1].disturbance = "loss–5±1.yaml";
  course.take_pairs({{1, 0, 1, 0, 3}, {0, 0, 1, 0, 4}, {2, 0, 0, 0, 3}});
  course.take(failed(0, "more than ±3"));
  const std::string text = tournament_text(course.view());
  EXPECT_THAT(text, AllOf(HasSubstr("a ±1–2 - b "), HasSubstr("(loss–5±1.yaml)"), HasSubstr("   1  a ±1–2 ")));
  EXPECT_THAT(text.substr(text.find("\nStanding\n")), Not(HasSubstr("∞")));
}

TEST(OutlineText, ATerminalIsGivenNoControlCharacters) {
  Course course({"a\x1b[2J", "b"}, 5);
  course.plan.asked.question = "q\x1b]0;x\x07";
  course.plan.asked.settings.rules = "r\x1b[31m.yaml";
  course.take(failed(0, "died\x1b[2J\n"));
  EXPECT_THAT(tournament_text(course.view()), AllOf(Not(HasSubstr("\x1b")), Not(HasSubstr("\x07"))));
}

}  // namespace
}  // namespace regista::report
