// SPDX-License-Identifier: MIT
#include "report/standing.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "course.hpp"
#include "statistics/moments.hpp"
#include "statistics/paired_tests.hpp"
#include "statistics/rating.hpp"

namespace regista::report {
namespace {

using testing::ElementsAre;

TEST(Strength, OfThePublishedPairs) {
  Course course({"a", "b"});
  course.take_pairs({{34, 54, 63, 64, 75}});
  const Strength known = *strength(*course.tournament, course.tournament->meetings().front());
  EXPECT_NEAR(known.elo.value, 55.58, 0.005);
  EXPECT_NEAR(known.elo.margin(), 27.65 * 1.968178 / 1.959964 * std::sqrt(290.0 / 289.0), 0.01);  // by Student
  EXPECT_NEAR(known.normalized_elo.value, 57.94, 0.005);
  EXPECT_NEAR(known.normalized_elo.margin(), 29.41, 0.005);  // 28.28 if the spread were known
  EXPECT_NEAR(*known.superiority, 1.0, 0.0001);
  EXPECT_NEAR(*known.pair_ratio, 139.0 / 88.0, 1e-12);
  EXPECT_NEAR(known.draw_ratio, 63.0 / 290.0, 1e-12);
}

TEST(Strength, TheOtherPublishedPairs) {
  Course course({"a", "b"});
  course.take_pairs({{332, 433, 498, 333, 334}});
  const Strength known = *strength(*course.tournament, course.tournament->meetings().front());
  EXPECT_NEAR(known.elo.value, -8.64, 0.005);
  EXPECT_NEAR(known.elo.margin(), 10.33, 0.02);
  EXPECT_NEAR(known.normalized_elo.value, -9.17, 0.005);
  EXPECT_NEAR(known.normalized_elo.margin(), 10.99, 0.005);
  EXPECT_NEAR(*known.superiority, 0.0505, 0.0001);
}

TEST(Strength, OfNoPairIsUnknown) {
  Course course({"a", "b"});
  EXPECT_FALSE(strength(*course.tournament, course.tournament->meetings().front()).has_value());
  course.take(match(1, 0));
  EXPECT_FALSE(strength(*course.tournament, course.tournament->meetings().front()).has_value());
}

TEST(Strength, TheTTestIsOnTheGoalsOfThePublishedSample) {
  Course course({"a", "b"});
  // The same difference in both matches of a pair, so that their mean is the published value.
  for (const int goals : {1, 0, 2, -1, 0, 1, 3, -2, 1, 0, 0, 2, 1, -1, 0, 1, 0, 2, -1, 1}) {
    course.take(match(std::max(goals, 0), std::max(-goals, 0)));
    course.take(match(std::max(-goals, 0), std::max(goals, 0)));
  }
  const Strength known = *strength(*course.tournament, course.tournament->meetings().front());
  EXPECT_NEAR(known.goals_t->t, 1.809934, 1e-6);
  EXPECT_NEAR(known.goals_t->p, 0.086153, 1e-6);
  EXPECT_NEAR(known.goals_t->interval.low, -0.078204, 1e-6);
  EXPECT_NEAR(known.goals_t->interval.high, 1.078204, 1e-6);
  // Both matches of a pair say the same, so pairs vary twice as much as two matches would: but for divisors 39 and 19.
  EXPECT_NEAR(*known.goals_ratio, 39.0 / 19.0, 1e-12);
}

// 7-3, 9-1, 6-4: pairs of wins and losses. The order of pairings: 0-1, 0-2, 1-2.
TEST(Ranking, ThePublishedTriangle) {
  Course course({"a", "b", "c"});
  course.take_pairs({{1, 0, 1, 0, 3}, {0, 0, 1, 0, 4}, {2, 0, 0, 0, 3}});
  const auto ranks = ranking(course.plan, *course.tournament);
  ASSERT_EQ(ranks.size(), 3u);
  const std::array<double, 3> elo{163.921, -27.823, -136.098};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(ranks[i].team, i);
    EXPECT_NEAR(ranks[i].elo->value, elo[i], 0.0005);
    EXPECT_TRUE(ranks[i].elo->interval.contains(elo[i]));
    EXPECT_EQ(ranks[i].matches, 20u);
  }
  EXPECT_EQ(ranks[0].points, 16.0);
  EXPECT_EQ(ranks[1].points, 9.0);
  EXPECT_EQ(ranks[2].points, 5.0);
  EXPECT_EQ(ranks[1].wins, 9u);
  EXPECT_EQ(ranks[1].losses, 11u);
  EXPECT_EQ(ranks[1].scored, 9u);
  EXPECT_EQ(ranks[1].conceded, 11u);
  // The first beats all others: it alone is the equilibrium.
  EXPECT_NEAR(ranks[0].nash.value(), 1.0, 1e-6);
}

TEST(Ranking, TheBestStandsFirstWhereverThePlanHasIt) {
  Course course({"a", "b", "c"});
  course.take_pairs({{3, 0, 1, 0, 1}, {3, 0, 0, 0, 2}, {1, 0, 1, 0, 3}});
  std::vector<std::size_t> order;
  for (const Ranked& each : ranking(course.plan, *course.tournament)) order.push_back(each.team);
  EXPECT_THAT(order, ElementsAre(1, 2, 0));
}

TEST(Ranking, RockPaperScissors) {
  Course course({"rock", "paper", "scissors"});
  course.take_pairs({{4, 0, 0, 0, 0}, {0, 0, 0, 0, 4}, {4, 0, 0, 0, 0}});
  const auto ranks = ranking(course.plan, *course.tournament);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(ranks[i].nash.value(), 1.0 / 3.0, 1e-6);
    EXPECT_NEAR(ranks[i].elo->value, 0.0, 1e-6);
    EXPECT_EQ(ranks[i].points, 8.0);
  }
}

// Who always wins has no Elo: then the share of points decides, and who never played stands in the middle.
TEST(Ranking, WhereNoEloIsKnownPointsDecide) {
  Course course({"a", "b", "c"});
  course.take_pairs({{2, 0, 0, 0, 0}, {2, 0, 0, 0, 0}, {0, 0, 0, 0, 2}});
  const auto ranks = ranking(course.plan, *course.tournament);
  std::vector<std::size_t> order;
  for (const Ranked& each : ranks) {
    order.push_back(each.team);
    EXPECT_FALSE(each.elo.has_value());
  }
  EXPECT_THAT(order, ElementsAre(1, 2, 0));
}

// Also where the first match of a pair has been played and the second one has not.
TEST(Ranking, EncountersHoldEveryMatch) {
  for (const std::array<int, 2> goals : {std::array{1, 0}, std::array{0, 0}, std::array{0, 2}}) {
    Course course({"a", "b", "c"}, 20);
    course.take_pairs({{{2, 3, 1, 1, 2}}, {{1, 1, 4, 2, 1}}, {{0, 2, 3, 2, 2}}});
    course.take(match(goals[0], goals[1]));
    const std::vector<statistics::Encounter> all = encounters(*course.tournament);
    EXPECT_EQ(total(all[0].pairs), 9);
    EXPECT_EQ(total(all[0].games), 1);
    EXPECT_EQ(total(all[1].games), 0);
    const statistics::SquareTable won = points_won(course.plan, *course.tournament);
    for (const study::Meeting& each : course.tournament->meetings()) {
      const auto& [first, second] = each.pairing;
      EXPECT_EQ(won.at(first, second), points(each.games));
      EXPECT_EQ(won.at(first, second) + won.at(second, first), static_cast<double>(total(each.games)));
    }
    const auto elo = *statistics::bradley_terry(3, all);
    for (const Ranked& each : ranking(course.plan, *course.tournament)) {
      EXPECT_EQ(each.elo->value, elo[each.team].value);
      EXPECT_EQ(each.elo->interval.high, elo[each.team].interval.high);
      EXPECT_TRUE(each.elo->interval.bounded());
    }
  }
}

TEST(Ranking, BeforeTheFirstMatchInTheOrderOfThePlan) {
  const Course course({"a", "b", "c"});
  std::vector<std::size_t> order;
  for (const Ranked& each : ranking(course.plan, *course.tournament)) {
    order.push_back(each.team);
    EXPECT_EQ(each.matches, 0u);
    EXPECT_EQ(each.points, 0.0);
  }
  EXPECT_THAT(order, ElementsAre(0, 1, 2));
}

// Teams that never met might be equal or far apart: no number of theirs may be made up for the equilibrium.
TEST(Ranking, NashSharesNeedThatAllTeamsHaveMet) {
  using enum config::Tournament::Format;
  for (const auto format : {gauntlet, swiss, knock_out, round_robin}) {
    Course course({"a", "b", "c", "d"}, 1);
    course.plan.asked.format = format;
    course.tournament.emplace(course.plan);
    const auto with_nash = [&course] {
      const auto ranks = ranking(course.plan, *course.tournament);
      return std::ranges::count_if(ranks, [](const Ranked& each) { return each.nash.has_value(); });
    };
    std::uint64_t matches = 0;
    course.tournament->run([&](const study::Round& round) {
      for (std::uint64_t i = 0; i < round.matches; ++i) {
        // The eleventh match of a round robin is the first one of the last of six pairings.
        EXPECT_EQ(with_nash(), format == round_robin && matches >= 11 ? 4 : 0) << matches;
        const campaign::MatchResult decided = match(1, 0);
        round.take(i, &decided);
        ++matches;
      }
    });
    EXPECT_TRUE(course.tournament->complete());
    EXPECT_EQ(with_nash(), format == round_robin ? 4 : 0);
  }
}

TEST(PValues, AreThoseOfTheSignsOfGoalsByHolm) {
  Course course({"a", "b", "c"});
  course.take_pairs({{2, 3, 5, 6, 4}, {8, 6, 4, 1, 1}, {4, 4, 4, 4, 4}});
  const PValues p = p_values(*course.tournament);
  EXPECT_LT(p.single[1], p.single[0]);
  EXPECT_EQ(p.single[2], 1.0);
  EXPECT_EQ(p.single[0], statistics::sign_flip_p({{-2, 2}, {-1, 3}, {0, 5}, {1, 6}, {2, 4}}));
  EXPECT_THAT(p.adjusted, ElementsAre(testing::DoubleEq(std::min(1.0, 2.0 * p.single[0])),
                                      testing::DoubleEq(3.0 * p.single[1]), 1.0));
  EXPECT_THAT(p_values(*Course({"a", "b", "c"}).tournament).adjusted, ElementsAre(1.0, 1.0, 1.0));
}

// A pair that is missing may have gone either way by as many goals as a match can end with. Three of these leave the
// second team ahead of the first or far behind, whose lead of sixty goals two cannot turn.
TEST(PValues, WithPairsThatCouldNotBePlayedAreThoseOfTheWorstWayToCountThem) {
  Course course({"a", "b"});
  course.take_pairs({{0, 5, 0, 0, 60}});
  for (int i = 0; i < 4; ++i) course.take(unplayed());
  const auto p_of = [](statistics::WholeCounts goals) { return statistics::sign_flip_p(goals); };
  const double worst =
      std::max({p_of({{-1, 5}, {2, 60}}), p_of({{-20, 2}, {-1, 5}, {2, 60}}), p_of({{-1, 5}, {2, 60}, {20, 2}})});
  EXPECT_LT(worst, 1.0);
  EXPECT_EQ(p_values(*course.tournament).single[0], worst);
  Course turned({"a", "b"});
  turned.take_pairs({{0, 11, 0, 0, 10}});
  for (int i = 0; i < 4; ++i) turned.take(unplayed());
  EXPECT_EQ(p_values(*turned.tournament).single[0], 1.0);
}

// A pair that is missing may hold two points for the other team.
TEST(Leads, OnlyWhoLeadsWithEveryMissingMatchLost) {
  for (const auto& [won_twice, leads] : {std::pair{1, false}, {2, true}}) {
    Course course({"a", "b"});
    course.take_pairs({{0, 0, 5 - won_twice, 0, won_twice}});  // 6 or 7 points of 10
    EXPECT_TRUE(leads_either_way(course.plan, *course.tournament, 0));
    course.take(unplayed());
    course.take(unplayed());
    EXPECT_EQ(leads_either_way(course.plan, *course.tournament, 0), leads);
  }
}

TEST(Points, CountADrawHalf) {
  EXPECT_EQ(points({{3, 5, 7}}), 9.5);
  EXPECT_EQ(points({}), 0.0);
}

}  // namespace
}  // namespace regista::report
