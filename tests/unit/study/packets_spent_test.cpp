// SPDX-License-Identifier: MIT
// What teams spend in short games: read from the metrics of matches, and
// counted over tournaments and experiments, compared with sums made by hand.
#include "study/measure.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "experiment_fixture.hpp"
#include "study/tournament_course.hpp"
#include "tournament_fixture.hpp"

namespace regista::study {
namespace {

std::string metrics(double home, double away, double share = 30.0) {
  return fmt::format(R"({{"packets": [{}, {}], "packets_share": [{}, {}], "packets_over_share": [{}, {}]}})", home,
                     away, share, share, home - share, away - share);
}

TEST(PacketsSpent, AreThoseOfTheTeamWhateverRolesHave) {
  const auto found = PacketsOfShortGames().of(campaign::metrics_from_json(R"({
    "packets_over_share": [-2, 4.5], "packets": [28, 34.5],
    "roles": [{"striker": {"packets_share": 8, "packets": 3}}, {"striker": {"packets": 7}}],
    "packets_share": [30, 30.25], "packets_by_reason": [{"goal": 1}, {"goal": 2}]})"));
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0].spent, 28);
  EXPECT_EQ((*found)[0].share, 30);
  EXPECT_EQ((*found)[0].over, -2);
  EXPECT_EQ((*found)[1].spent, 34.5);
  EXPECT_EQ((*found)[1].share, 30.25);
  EXPECT_EQ((*found)[1].over, 4.5);
}

TEST(PacketsSpent, AreNoneOfWholeMatches) {
  for (const char* const text : {R"({"packets": [1, 2]})", "{}",
                                 R"({"packets": [1, 2], "packets_share": [null, null], "packets_over_share": [4, 5]})",
                                 R"({"packets": [1, 2], "packets_share": [null, 3], "packets_over_share": [4, 5]})",
                                 R"({"a": [{"packets": 1, "packets_share": 3, "packets_over_share": 2}, {}]})"}) {
    EXPECT_FALSE(PacketsOfShortGames().of(campaign::metrics_from_json(text))) << text;
  }
  EXPECT_FALSE(PacketsOfShortGames().of({}));
}

// The budget of each game is its share, and all of it is spent: a mean of shares that is rounded down must not tell.
TEST(PacketsSpent, TheShareIsNotAboveIt) {
  PacketsSpent packets;
  for (int game = 0; game < 1000; ++game) {
    const double share = 0.1 * (game % 7);
    packets.add({share, share, 0.0});
    EXPECT_FALSE(packets.above_share());
  }
  packets.add({0.2, 0.1, 0.1});  // 0.03 % more of all 300
  EXPECT_FALSE(packets.above_share());
  EXPECT_EQ(packets.games(), 1001);
}

TEST(PacketsSpent, MoreThanFivePercentMoreIsAboveIt) {
  const auto above_share = [](double spent) {
    PacketsSpent packets;
    packets.add({spent, 40.0, spent - 40.0});
    return packets.above_share();
  };
  EXPECT_FALSE(above_share(41.0));
  EXPECT_FALSE(above_share(42.0));
  EXPECT_TRUE(above_share(42.5));
  PacketsSpent nothing_to_spend;
  nothing_to_spend.add({0.0, 0.0, 0.0});
  EXPECT_FALSE(nothing_to_spend.above_share());
}

TEST(PacketsSpent, OfATournamentAreThoseOfThePairsThatCount) {
  for (const bool by_openings : {true, false}) {
    TournamentPlan plan = plan_of(3, 4);
    if (by_openings)
      plan.openings = {{"corner.yaml", {}}};
    else
      plan.asked.settings.limit = 30;
    Tournament course(plan);
    EXPECT_EQ(course.metrics(), campaign::Metrics::packets);
    const auto take = [&course](const campaign::MatchResult& decided) { course.take(&decided); };
    // 0 against 1, 0 against 2, 1 against 2; each at home, then away.
    take(match(0, 0, metrics(40, 10)));
    take(match(0, 0, metrics(20, 50, 20)));
    take(match(0, 0, metrics(70, 11)));
    take(unplayed());  // with it goes the match before
    take(failed(0));   // has no metrics, but the other match of its pair has
    take(match(0, 0, metrics(33, 12)));
    EXPECT_EQ(course.packets(0).games(), 2);
    EXPECT_EQ(course.packets(0).spent(), (40.0 + 50.0) / 2.0);
    EXPECT_EQ(course.packets(0).share(), (30.0 + 20.0) / 2.0);
    EXPECT_TRUE(course.packets(0).above_share());
    EXPECT_EQ(course.packets(1).games(), 3);
    EXPECT_EQ(course.packets(1).spent(), (10.0 + 20.0 + 12.0) / 3.0);
    EXPECT_FALSE(course.packets(1).above_share());
    EXPECT_EQ(course.packets(2).games(), 1);
    EXPECT_EQ(course.packets(2).spent(), 33.0);
    EXPECT_TRUE(course.packets(2).above_share());
    take(unplayed());
    take(match(0, 0, metrics(900, 900)));  // the other way round
    EXPECT_EQ(course.packets(0).spent(), 45.0);
    EXPECT_EQ(course.packets(1).spent(), 14.0);
  }
}

TEST(PacketsSpent, OfATournamentOfWholeMatchesNothingIsRead) {
  const TournamentPlan plan = plan_of(2, 1);
  Tournament course(plan);
  EXPECT_EQ(course.metrics(), campaign::Metrics::left_out);
  const campaign::MatchResult decided = match(0, 0, metrics(40, 40));
  course.take(&decided);
  EXPECT_EQ(course.packets(0).games(), 0);
}

TEST(PacketsSpent, OfAnExperimentAreThoseOfTheArmsTeamInPairsThatHaveValues) {
  const ExperimentPlan plan = experiment_of(2, 1, 2);
  Experiment course(plan);
  for (std::uint64_t index = 0; index < plan.matches(); ++index) {
    const Trial each = trial(plan, index);
    campaign::MatchResult decided = played(each.side, 1.0, 0, 0, 0);
    const double own = each.condition == 0 ? 40.0 : 10.0 + static_cast<double>(each.pair);
    decided.metrics = campaign::metrics_from_json(each.side == 0 ? metrics(own, 500.0) : metrics(500.0, own));
    // A forfeit at home, and one away.
    if (each.condition == each.pair && each.side == each.condition) decided = failed(0);
    course.take(decided);
  }
  EXPECT_EQ(course.packets(0).games(), 2);
  EXPECT_EQ(course.packets(0).spent(), 40.0);
  EXPECT_TRUE(course.packets(0).above_share());
  EXPECT_EQ(course.packets(1).games(), 2);
  EXPECT_EQ(course.packets(1).spent(), 10.0);
  EXPECT_EQ(course.packets(1).share(), 30.0);
  EXPECT_FALSE(course.packets(1).above_share());
}

}  // namespace
}  // namespace regista::study
