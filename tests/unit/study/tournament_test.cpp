// SPDX-License-Identifier: MIT
// What a tournament counts, and where its test stops it.
#include "study/tournament_course.hpp"

#include <gmock/gmock.h>
#include <malloc.h>

#include <algorithm>
#include <random>
#include <string>

#include "statistics/anytime_valid_tests.hpp"
#include "tournament_fixture.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;
using PairCounts = std::array<statistics::Count, 5>;
using GameCounts = std::array<statistics::Count, 3>;

// Two scores of the first team's goals less the second's, as matches at home and away.
std::array<campaign::MatchResult, 2> pair_of(int at_home, int away) {
  return {match(std::max(at_home, 0), std::max(-at_home, 0)), match(std::max(-away, 0), std::max(away, 0))};
}

// The matches of a pair of each kind: goal differences of the first team.
constexpr std::array<std::array<int, 2>, 5> kinds{{{-1, -3}, {-1, 0}, {2, -2}, {0, 1}, {1, 4}}};

bool take(Tournament& course, const std::array<campaign::MatchResult, 2>& pair) {
  EXPECT_TRUE(course.take(&pair[0]));
  return course.take(&pair[1]);
}

TEST(Tournament, CountsPairsAndNotOnlyGames) {
  const TournamentPlan plan = plan_of(2, 6);
  Tournament course(plan);
  // Each pair: A at home, then A away.
  const campaign::MatchResult matches[] = {match(0, 1), match(1, 0),   // LL
                                           match(0, 1), match(2, 2),   // LD
                                           match(3, 1), match(3, 1),   // WL
                                           match(0, 0), match(1, 1),   // DD
                                           match(0, 0), match(0, 4),   // WD
                                           match(2, 0), match(0, 2)};  // WW
  for (const campaign::MatchResult& each : matches) EXPECT_TRUE(course.take(&each));
  const Meeting& meeting = course.meetings().front();
  EXPECT_EQ(meeting.pairs.seen, (PairCounts{1, 1, 2, 1, 1}));
  EXPECT_EQ(meeting.games.seen, (GameCounts{4, 4, 4}));
  EXPECT_EQ(meeting.goals, (std::array<std::uint64_t, 2>{15, 10}));
  EXPECT_EQ(meeting.goals_of_matches.count(), 12);
  EXPECT_EQ(meeting.goals_of_pairs.count(), 6);
  // -1, -1/2, 0, 0, 2, 2
  EXPECT_NEAR(meeting.goals_of_pairs.mean(), 2.5 / 6.0, 1e-15);
  EXPECT_NEAR(meeting.goals_of_pairs.variance(), (9.25 - 6.25 / 6.0) / 5.0, 1e-14);
  EXPECT_EQ(course.matches(), 12u);
  EXPECT_EQ(course.taken(), 12u);
  EXPECT_EQ(course.verdict(), Verdict::none);
}

// Plays a tournament in rounds. The team with the smaller number wins by a goal; `upset` is the winner of a meeting
// that ends otherwise. Returns the teams of the first match of each pair, with its seed.
std::vector<std::array<std::uint64_t, 3>> played_in_rounds(Tournament& course, std::array<std::size_t, 2> upset) {
  std::vector<std::array<std::uint64_t, 3>> out;
  std::uint64_t rows = 0;
  course.run([&](const Round& round) {
    EXPECT_EQ(round.first_row, rows);
    rows += round.matches;
    EXPECT_EQ(round.matches_of_a_pair, 0u) << "no clock stops it";
    for (std::uint64_t i = 0; i < round.matches; ++i) {
      const auto place = round.at(i);
      ASSERT_TRUE(place);
      const campaign::Job job = round.job(i);
      EXPECT_EQ(job.seed, place->seed);
      EXPECT_EQ(job.teams, round.fixtures[place->fixture].job.teams);
      const std::size_t home = std::stoul(job.teams[0]), away = std::stoul(job.teams[1]);
      if (i % 2 == 0) out.push_back({home, away, job.seed});
      const bool is_upset = std::minmax(home, away) == std::minmax(upset[0], upset[1]);
      const bool home_wins = is_upset ? home == upset[0] : home < away;
      const campaign::MatchResult decided = home_wins ? match(1, 0) : match(0, 1);
      EXPECT_EQ(round.first_of_pairing(i), i % 2 == 0);
      EXPECT_TRUE(round.take(i, &decided));
    }
  });
  EXPECT_EQ(rows, course.most_matches());
  EXPECT_TRUE(course.complete());
  return out;
}

TEST(Tournament, SwissRoundsAreDrawnFromTheResults) {
  TournamentPlan plan = plan_of(5, 1);
  plan.asked.format = config::Tournament::Format::swiss;
  plan.asked.seed = 40;
  EXPECT_EQ(plan.rounds(), 3u);
  EXPECT_EQ(plan.matches(), 3u * 2u * 2u);
  Tournament course(plan);
  using Line = std::array<std::uint64_t, 3>;
  // Team 4 has a bye, and team 2 loses to team 3. Then 0, 3 and 4 have two points, and team 2, the last without a bye,
  // gets one. Then 0 has four points and the others two; 3 gets the bye. Team 1 has met 4, so it meets 2, and 0
  // meets 4.
  EXPECT_THAT(played_in_rounds(course, {3, 2}), ElementsAre(Line{0, 1, 40}, Line{2, 3, 40}, Line{0, 3, 41},
                                                            Line{1, 4, 41}, Line{0, 4, 42}, Line{1, 2, 42}));
}

TEST(Tournament, InAKnockOutTheWinnersGoOn) {
  TournamentPlan plan = plan_of(6, 1);
  plan.asked.format = config::Tournament::Format::knock_out;
  plan.asked.seed = 7;
  EXPECT_EQ(plan.matches(), 10u);
  Tournament course(plan);
  using Line = std::array<std::uint64_t, 3>;
  EXPECT_THAT(played_in_rounds(course, {5, 2}),
              ElementsAre(Line{3, 4, 7}, Line{2, 5, 7}, Line{0, 3, 8}, Line{1, 5, 8}, Line{0, 1, 9}));
}

// What was played ahead is no part of it.
TEST(Tournament, IsAtItsEndWhereTheClockStoppedIt) {
  TournamentPlan plan = plan_of(3, 10);
  plan.ended_after = 2;
  Tournament course(plan);
  const campaign::MatchResult even = match(0, 0);
  for (int i = 1; i < 12; ++i) EXPECT_TRUE(course.take(&even)) << i;
  EXPECT_FALSE(course.complete());
  EXPECT_FALSE(course.take(&even));
  EXPECT_TRUE(course.complete());
  EXPECT_EQ(course.most_matches(), 12u);
  for (const Meeting& meeting : course.meetings()) EXPECT_EQ(total(meeting.pairs), 2);
}

TEST(Tournament, HalfAPairIsNoPair) {
  const TournamentPlan plan = plan_of(2, 2);
  Tournament course(plan);
  const campaign::MatchResult won = match(1, 0);
  course.take(&won);
  const Meeting& meeting = course.meetings().front();
  EXPECT_EQ(meeting.matches(), 1u);
  EXPECT_EQ(total(meeting.pairs), 0);
  EXPECT_EQ(meeting.goals_of_pairs.count(), 0);
  EXPECT_EQ(meeting.goals_of_matches.count(), 1);
  course.take(&won);
  EXPECT_EQ(meeting.pairs.seen, (PairCounts{0, 0, 1, 0, 0}));
}

TEST(Tournament, CountsEachPairingByItself) {
  const TournamentPlan plan = plan_of(3, 2);
  Tournament course(plan);
  // In order: 0-1, 1-0, 0-2, 2-0, 1-2, 2-1; twice. The team of the smaller number wins, by its distance.
  for (std::uint64_t i = 0; i < plan.matches(); ++i) {
    const Fixture fixture = course.calendar().at(i);
    const int margin = static_cast<int>(fixture.away) - static_cast<int>(fixture.home);
    const campaign::MatchResult decided = match(std::max(margin, 0), std::max(-margin, 0));
    EXPECT_TRUE(course.take(&decided));
  }
  ASSERT_EQ(course.meetings().size(), 3u);
  for (const Meeting& meeting : course.meetings()) {
    EXPECT_EQ(meeting.pairs.seen, (PairCounts{0, 0, 0, 0, 2}));
    const std::uint64_t margin = meeting.pairing.second - meeting.pairing.first;
    EXPECT_EQ(meeting.goals, (std::array<std::uint64_t, 2>{4 * margin, 0}));
  }
  EXPECT_EQ(course.matches(), 12u);
}

TEST(Tournament, ForfeitsFollowTheTeamAndNotTheSide) {
  const TournamentPlan plan = plan_of(2, 2);
  Tournament course(plan);
  campaign::MatchResult a_at_home = failed(0), a_away = failed(1), b_away = failed(1);
  a_away.failure->tick = 5;
  a_away.failure->robot = 1;
  for (const campaign::MatchResult* each : {&a_at_home, &a_away, &b_away}) course.take(each);
  ASSERT_EQ(course.forfeits().listed().size(), 2u);
  EXPECT_EQ(course.forfeits().listed()[0].team, 0u);
  EXPECT_EQ(course.forfeits().listed()[0].count, 2u);
  EXPECT_EQ(course.forfeits().listed()[0].first_match, 0u);
  EXPECT_EQ(course.forfeits().listed()[0].failure.tick, 417u);
  EXPECT_EQ(course.forfeits().listed()[1].team, 1u);
  EXPECT_EQ(course.forfeits().listed()[1].count, 1u);
  EXPECT_EQ(course.forfeits().listed()[1].first_match, 2u);
  EXPECT_THAT(course.forfeits().of_team(), ElementsAre(2, 1));
  const Meeting& meeting = course.meetings().front();
  EXPECT_EQ(meeting.goals, (std::array<std::uint64_t, 2>{10, 20}));
  EXPECT_EQ(meeting.pairs.seen, (PairCounts{1, 0, 0, 0, 0}));
}

TEST(Tournament, ForfeitsForOtherReasonsAreListedApart) {
  TournamentPlan plan = plan_of(2, 10);
  plan.asked.failures_in_a_row = 0;
  Tournament course(plan);
  std::vector<campaign::MatchResult> matches(4, failed(0));
  matches[1] = failed(1, "other");
  matches[2].failure->call = "score";
  matches[3] = failed(1, "greedy", "Aborted");
  for (const campaign::MatchResult& each : matches) course.take(&each);
  ASSERT_EQ(course.forfeits().listed().size(), 4u);
  for (std::uint64_t i = 0; i < 4; ++i) EXPECT_EQ(course.forfeits().listed()[i].first_match, i);
}

TEST(Tournament, DoesNotGrowWithoutEnd) {
  TournamentPlan plan = plan_of(2, 1'000'000, ValueTest{"packets", 0.05});
  plan.asked.failures_in_a_row = 0;
  Tournament course(plan);
  for (int i = 0; i < 150; ++i) {
    const campaign::MatchResult decided = failed(i % 2, "greedy", "reason " + std::to_string(i));
    course.take(&decided);
  }
  EXPECT_EQ(course.forfeits().listed().size(), 100u);
  EXPECT_EQ(course.forfeits().unlisted(), 50u);
  EXPECT_THAT(course.forfeits().of_team(), ElementsAre(150, 0));
  const auto play = [&](int pairs) {
    for (int i = 0; i < pairs; ++i) {
      const std::string metrics = R"({"packets":[)" + std::to_string(i % 7) + "," + std::to_string(i % 5) + "]}";
      const campaign::MatchResult one = match(i % 3, 1, metrics), other = failed(0, "greedy", std::to_string(i));
      course.take(&one);
      course.take(i % 50 == 0 ? &other : &one);
    }
  };
  play(100);
  const auto before = mallinfo2().uordblks;
  play(5000);
  const auto after = mallinfo2().uordblks;
  EXPECT_LT(after, before + 4096);
}

TEST(Tournament, TheScoreTestStopsAtTheVeryPairAtWhichItsTestStops) {
  ScoreTest score;
  score.design = {statistics::Model::normalized, {0, 60}, {0.05, 0.05}, true};
  std::array<int, 2> verdicts{};
  for (unsigned seed = 0; seed < 20; ++seed) {
    const TournamentPlan plan = plan_of(2, 100'000, score);
    Tournament course(plan);
    statistics::SequentialTest alone(score.design);
    std::mt19937_64 random(seed);
    EXPECT_EQ(course.verdict(), Verdict::inconclusive);
    bool more = true;
    while (more) {
      const std::size_t kind = std::min<std::size_t>(random() % (seed % 2 == 0 ? 5 : 7), 4);
      alone.add(static_cast<statistics::PairOutcome>(kind));
      more = take(course, pair_of(kinds[kind][0], kinds[kind][1]));
      ASSERT_EQ(more, alone.verdict() == statistics::Verdict::inconclusive) << course.taken();
    }
    const bool h1 = alone.verdict() == statistics::Verdict::accept_h1;
    EXPECT_EQ(course.verdict(), h1 ? Verdict::accept_h1 : Verdict::accept_h0);
    EXPECT_EQ(course.meetings().front().pairs, alone.counts());
    ++verdicts[h1 ? 1 : 0];
  }
  EXPECT_GT(verdicts[0], 4);
  EXPECT_GT(verdicts[1], 4);
}

TEST(Tournament, TheTestOnGoalsStopsWhenNoDifferenceIsExcluded) {
  for (const int better : {-1, 1}) {
    for (unsigned seed = 0; seed < 10; ++seed) {
      const TournamentPlan plan = plan_of(2, 100'000, ValueTest{goals_value, 0.02});
      Tournament course(plan);
      EXPECT_EQ(course.metrics(), campaign::Metrics::left_out);
      statistics::BettingTest alone({-10, 10, 0.02, 1.0}, 0.0);
      std::mt19937_64 random(seed);
      bool more = true;
      while (more) {
        const int first = better * (static_cast<int>(random() % 6) - 2), second = static_cast<int>(random() % 5) - 2;
        alone.add((first + second) / 2.0);
        more = take(course, pair_of(first, second));
        ASSERT_LT(course.taken(), 10'000u);
        EXPECT_EQ(course.verdict() == Verdict::inconclusive, more);
        // The test of a mean of 0 alone rejects it now, and did at no pair before.
        EXPECT_EQ(alone.finding() == statistics::BettingTest::Finding::none, more);
      }
      EXPECT_EQ(course.verdict(), Verdict::accept_h1);
      EXPECT_EQ(course.first_has_more(), better > 0);
    }
  }
}

TEST(Tournament, AForfeitIsNoLargerADifferenceThanAMatchCanEndWith) {
  TournamentPlan plan = plan_of(2, 10);
  plan.most_goals = 3;
  Tournament course(plan);
  take(course, pair_of(10, 10));
  EXPECT_EQ(course.meetings().front().goals_of_pairs.mean(), 3.0);
  EXPECT_EQ(course.meetings().front().goals_of_matches.mean(), 3.0);
  EXPECT_EQ(course.meetings().front().goals[0], 20u);
  Tournament capped(plan);
  for (int pair = 1; pair < 10; ++pair) take(course, pair_of(10, 10));
  for (int pair = 0; pair < 10; ++pair) take(capped, pair_of(3, 3));
  const statistics::Interval of_tens = course.meetings().front().goals_sequence.interval();
  const statistics::Interval of_threes = capped.meetings().front().goals_sequence.interval();
  EXPECT_EQ(of_tens.low, of_threes.low);
  EXPECT_EQ(of_tens.high, of_threes.high);
  EXPECT_GT(of_tens.low, -3.0);
}

TEST(Tournament, DrawsAloneGiveNoVerdict) {
  ScoreTest score;
  score.design.hypotheses = {0, 10};
  for (const Objective& objective :
       {Objective(score), Objective(ValueTest{goals_value, 0.05}), Objective(ValueTest{"packets", 0.05})}) {
    const TournamentPlan plan = plan_of(2, 1000, objective);
    Tournament course(plan);
    const campaign::MatchResult draw = match(1, 1, R"({"packets":[5,5]})");
    for (int i = 0; i < 2000; ++i) ASSERT_TRUE(course.take(&draw));
    EXPECT_EQ(course.verdict(), Verdict::inconclusive);
    EXPECT_FALSE(course.first_has_more());
  }
}

std::string packets(double home, double away) {
  return R"({"packets":[)" + std::to_string(home) + "," + std::to_string(away) + "]}";
}

TEST(Tournament, AMetricIsTakenFromTheSideThatTheTeamHad) {
  const TournamentPlan plan = plan_of(2, 100, ValueTest{"packets", 0.05});
  Tournament course(plan);
  EXPECT_EQ(course.metrics(), campaign::Metrics::wanted);
  // First team: 10 and 20, second: 4 and 6. Then 1 and 1 against 8 and 2. Then both 3.
  take(course, {match(0, 0, packets(10, 4)), match(0, 0, packets(6, 20))});
  take(course, {match(0, 0, packets(1, 8)), match(0, 0, packets(2, 1))});
  take(course, {match(0, 0, packets(3, 3)), match(0, 0, packets(3, 3))});
  const MetricDifference& metric = *course.meetings().front().metric;
  EXPECT_THAT(metric.signs(), ElementsAre(1, 1, 1));
  EXPECT_NEAR(metric.first().mean(), (15.0 + 1.0 + 3.0) / 3.0, 1e-12);
  EXPECT_NEAR(metric.second().mean(), (5.0 + 5.0 + 3.0) / 3.0, 1e-12);
  EXPECT_NEAR(metric.difference().mean(), (10.0 - 4.0 + 0.0) / 3.0, 1e-12);
  EXPECT_NEAR(metric.difference().variance(), 52.0, 1e-12);  // (64 + 36 + 4) / 2
  const statistics::Estimate estimate = metric.estimate();
  EXPECT_NEAR(estimate.value, 2.0, 1e-12);
  EXPECT_NEAR(estimate.margin(), statistics::mixture_half_width({3, 52.0, 52.0 / 16.0}, 0.05), 1e-9);
}

TEST(Tournament, AMetricIsMissingWhereAMatchWasForfeitedOrHasNone) {
  const TournamentPlan plan = plan_of(2, 100, ValueTest{"packets", 0.05});
  Tournament course(plan);
  take(course, {match(0, 0, packets(10, 4)), failed(0)});
  take(course, {failed(1), match(0, 0, packets(10, 4))});
  take(course, {match(0, 0, "{}"), match(0, 0, packets(10, 4))});
  take(course, {match(0, 0, packets(10, 4)), match(0, 0, R"({"packets":[1,null]})")});
  const Meeting& meeting = course.meetings().front();
  EXPECT_EQ(meeting.pairs_without_metric, 4u);
  EXPECT_THAT(meeting.metric->signs(), ElementsAre(0, 0, 0));
  EXPECT_FALSE(meeting.metric->estimate().interval.bounded());
  EXPECT_EQ(total(meeting.pairs), 4);
}

TEST(Tournament, TheTestOnAMetricStopsAtThePairAtWhichTheBetIsWon) {
  for (const double sign : {-1.0, 1.0}) {
    const TournamentPlan plan = plan_of(2, 10'000, ValueTest{"packets", 0.05});
    Tournament course(plan);
    statistics::BettingTest alone({-1, 1, 0.05}, 0.0);
    std::mt19937_64 random(3);
    bool more = true;
    while (more) {
      // Larger by much now and then, smaller by little most of the time: what counts is how often.
      const double difference = sign * (random() % 10 == 0 ? -1000.0 : 0.5);
      alone.add(difference > 0.0 ? 1.0 : -1.0);
      more = take(course, {match(0, 0, packets(2000 + difference, 2000)), match(0, 0, packets(2000, 2000))});
      ASSERT_EQ(more, alone.finding() == statistics::BettingTest::Finding::none) << course.taken();
    }
    EXPECT_EQ(course.verdict(), Verdict::accept_h1);
    EXPECT_EQ(course.first_has_more(), sign > 0.0);
  }
}

TEST(MetricDifference, KnowsNoBoundsBeforeItHasSeenASpread) {
  MetricDifference difference(0.05);
  EXPECT_FALSE(difference.estimate().interval.bounded());
  difference.add(3, 1);
  EXPECT_FALSE(difference.estimate().interval.bounded());
  difference.add(3, 1);
  EXPECT_FALSE(difference.estimate().interval.bounded());
  EXPECT_EQ(difference.estimate().value, 2.0);
  difference.add(2, 1);
  EXPECT_TRUE(difference.estimate().interval.bounded());
}

}  // namespace
}  // namespace regista::study
