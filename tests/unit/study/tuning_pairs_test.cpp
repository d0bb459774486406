// SPDX-License-Identifier: MIT
// Which matches a batch of pairs plays, and what their results are counted as.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "study/tuning/pair_batch.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::Contains;
using testing::ElementsAre;

campaign::MatchResult match(int home, int away, const std::string& metrics = "{}") {
  campaign::MatchResult out;
  out.score = {home, away};
  out.ended = "full_time";
  out.hash = "h";
  out.metrics = campaign::metrics_from_json(metrics);
  return out;
}

campaign::MatchResult failed(int side) { return campaign::forfeit({side, "greedy", "assign", 3, 417, "died"}, 1.0); }

TEST(PairBatch, PairAfterPairEveryCandidateEveryOpponentHomeThenAway) {
  const TuningPlan plan = tuning_of(2, 3);
  const TunedDocument document(plan);
  const std::vector<ParameterValues> candidates{{0.25, 0.5}, {0.75, 1.0}};
  const PairBatch batch(plan, document, candidates, {TuningStage::search, plan.seed(), 20, 4});
  const Round& round = batch.round();
  ASSERT_EQ(round.matches, 4u * 2 * 3 * 2);
  std::size_t index = 0;
  for (std::uint64_t pair = 0; pair < 4; ++pair) {
    for (const ParameterValues& values : candidates) {
      for (const TuningOpponent& opponent : plan.opponents) {
        for (const std::size_t side : {0u, 1u}) {
          const campaign::Job job = round.job(index++);
          EXPECT_EQ(job.seed, plan.seed() + 20 + pair);
          EXPECT_EQ(job.teams[side], plan.asked.team);
          EXPECT_EQ(job.teams[1 - side], opponent.file);
          EXPECT_EQ(said_values(job, side, 2), values);
          EXPECT_EQ(said_values(job, 1 - side, 2), (ParameterValues{0.5, 0.5}));
        }
      }
    }
  }
  EXPECT_EQ(round.fixtures.size(), 2u * 3 * 2);
}

// The job of a match differs from its opponent's job by the values' overrides and the hash of the document, no more.
TEST(PairBatch, OverridesAndInputs) {
  TuningPlan plan = tuning_of(2, 1);
  for (campaign::Job& each : plan.opponents[0].jobs) each.overrides = {"home.tasks.keep=all"};
  const TunedDocument document(plan);
  const PairBatch batch(plan, document, {{0.25, 0.5}, start_values(plan)}, {});
  for (std::size_t index = 0; index < 4; ++index) {
    campaign::Job job = batch.round().job(index);
    const std::size_t side = index % 2;
    const bool base = index >= 2;
    const std::string own = side == 0 ? "home." : "away.";
    EXPECT_THAT(job.overrides, ElementsAre("home.tasks.keep=all", own + (base ? "p0=0.5" : "p0=0.25"), own + "p1=0.5"));
    campaign::Job expected = plan.opponents[0].jobs[side];
    expected.overrides = job.overrides;
    expected.seed = job.seed;
    auto& inputs = side == 0 ? expected.home_inputs : expected.away_inputs;
    const std::string before = inputs[0].hash;
    inputs[0].hash = plugin::content_hash(base ? "team: base\np0: 0.5\np1: 0.5\n" : "team: base\np0: 0.25\np1: 0.5\n");
    EXPECT_EQ(inputs[0].hash == before, base);
    EXPECT_EQ(job, expected) << index;
  }
  std::set<std::string> keys;
  for (const auto& each : batch.round().fixtures) keys.insert(each.key);
  EXPECT_EQ(keys.size(), 4u);
}

// The same values have the same fixtures, whichever batch and place they are in: what is stored is found again.
TEST(PairBatch, EqualMatchesHaveEqualKeys) {
  const TuningPlan plan = tuning_of(2, 2);
  const TunedDocument document(plan);
  const PairBatch alone(plan, document, {{0.125, 1.0}}, {TuningStage::search, plan.seed(), 3, 2});
  const PairBatch among(plan, document, {{0.5, 0.5}, {0.125, 1.0}}, {TuningStage::selection, plan.seed(), 0, 2});
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(alone.round().fixtures[i].key, among.round().fixtures[4 + i].key);
}

TEST(PairBatch, SeedsOfStagesAndPairsAreDifferent) {
  std::map<std::uint64_t, std::string> seen;
  for (const TuningStage stage :
       {TuningStage::search, TuningStage::selection, TuningStage::verification, TuningStage::slices}) {
    for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{100}, std::uint64_t{1} << 31}) {
      const PairRange range{stage, (std::uint64_t{1} << 31) - 1, first, 100};
      for (std::uint64_t pair = 0; pair < range.count; ++pair) {
        const auto [at, fresh] = seen.emplace(range.seed(pair), "");
        ASSERT_TRUE(fresh) << name(stage) << ' ' << first << ' ' << pair;
      }
    }
  }
  // As the plan says it.
  EXPECT_EQ((PairRange{TuningStage::verification, 7, 5, 10}.seed(2)), 2 * (std::uint64_t{1} << 50) + 7 + 5 + 2);
}

TEST(PairBatch, ScenesInTurnInTheSearchAndDrawnInTheVerification) {
  TuningPlan plan = tuning_of(1, 2);
  for (int i = 0; i < 5; ++i)
    plan.openings.push_back({fmt::format("{}.yaml", i), {fmt::format("scene {}", i), fmt::format("{}", i)}});
  const TunedDocument document(plan);
  const PairBatch search(plan, document, {{0.5}, {0.6}}, {TuningStage::search, 7, 3, 4});
  EXPECT_EQ(search.round().fixtures.size(), 2u * 2 * 2 * 4);
  for (std::size_t index = 0; index < search.round().matches; ++index) {
    const campaign::Job job = search.round().job(index);
    const std::size_t scene = (3 + index / 8) % 5;
    EXPECT_EQ(job.opening, plan.openings[scene].file);
    EXPECT_EQ(job.common_inputs.back(), plan.openings[scene].input);
    EXPECT_EQ(job.common_inputs.size(), 2u);
  }
  const PairRange range{TuningStage::verification, 7, 0, 300};
  const PairBatch verification(plan, document, {{0.5}}, range);
  std::map<std::string, int> counts;
  for (std::size_t index = 0; index < verification.round().matches; ++index) {
    const campaign::Job job = verification.round().job(index);
    EXPECT_EQ(job.opening, plan.openings[drawn_opening(job.seed, 5)].file);
    ++counts[job.opening];
  }
  ASSERT_EQ(counts.size(), 5u);
  for (const auto& [scene, count] : counts) EXPECT_NEAR(count, 240, 80) << scene;
  // Only scenes that are used have fixtures.
  const PairBatch two(plan, document, {{0.5}}, {TuningStage::search, 7, 1, 2});
  EXPECT_EQ(two.round().fixtures.size(), 2u * 2 * 2);
  for (const auto& each : two.round().fixtures)
    EXPECT_TRUE(each.job.opening == "1.yaml" || each.job.opening == "2.yaml");
}

// --- Scores -------------------------------------------------------------------------------------------------------

class Scores : public testing::Test {
 protected:
  // One candidate; the matches of its pairs, from the tuned team's side: home, away, home, away, ...
  std::vector<double> of(const std::vector<campaign::MatchResult>& matches, bool head_to_head = false) {
    const TunedDocument document(plan);
    const std::size_t each = 2 * (head_to_head ? 1 : plan.opponents.size());
    PairBatch batch(plan, document, {{0.25}}, {TuningStage::search, 7, 0, matches.size() / each}, head_to_head);
    forfeits.emplace(plan.opponents.size() + 2);
    for (std::size_t i = 0; i < matches.size(); ++i) {
      EXPECT_EQ(batch.take(matches[i], *forfeits, remarks), (i + 1) % each == 0);
    }
    EXPECT_EQ(batch.pairs(), matches.size() / each);
    own_failed = batch.failed(0);
    unplayed = batch.unplayed(0);
    EXPECT_EQ(batch.unplayed_pairs(), static_cast<std::uint64_t>(std::ranges::count(unplayed, true)));
    return batch.scores(0);
  }

  TuningPlan plan = tuning_of(1, 1);
  std::optional<ForfeitList> forfeits;
  MatchRemarks remarks;
  std::vector<bool> unplayed;
  bool own_failed = false;
};

TEST_F(Scores, MeanGoalDifferenceOfBothMatches) {
  EXPECT_THAT(of({match(3, 1), match(0, 2), match(0, 4), match(1, 0)}), ElementsAre(2.0, -2.5));
  plan.objective.minimise = true;
  EXPECT_THAT(of({match(3, 1), match(0, 2)}), ElementsAre(-2.0));
  EXPECT_EQ(value_of(plan.objective, -2.0), 2.0);
}

TEST_F(Scores, PointsAndSums) {
  plan.objective.terms = {{"points", 10.0}, {"goals_against", -0.5}};
  EXPECT_THAT(of({match(3, 1), match(2, 2)}), ElementsAre(10.0 * 0.75 - 0.5 * 1.5));
}

TEST_F(Scores, OpponentsByWeight) {
  plan = tuning_of(1, 2);
  plan.opponents[0].weight = 0.25;
  plan.opponents[1].weight = 0.75;
  EXPECT_THAT(of({match(1, 0), match(0, 1), match(0, 2), match(2, 0)}), ElementsAre(0.25 * 1.0 - 0.75 * 2.0));
}

// A goal difference of two is two goals more than an equal team would have, not four.
TEST_F(Scores, HeadToHeadIsWhatTheCandidateHasMore) {
  EXPECT_THAT(of({match(3, 1), match(0, 2)}, true), ElementsAre(2.0));
  plan.objective.terms = {{"points", 1.0}};
  EXPECT_THAT(of({match(3, 1), match(2, 2)}, true), ElementsAre(0.25));
  plan.objective.terms = {{"packets", 1.0}};
  EXPECT_THAT(of({match(0, 0, R"({"packets": [10, 30]})"), match(0, 0, R"({"packets": [5, 8]})")}, true),
              ElementsAre((10.0 + 8.0) / 2.0 - (30.0 + 5.0) / 2.0));
}

TEST_F(Scores, TimesAreMinutesInAnHourOfPlay) {
  plan.objective.terms = {{"striker.overlap_seconds", 1.0}};
  const auto played = [](double seconds, double home, double away) {
    return match(
        0, 0,
        fmt::format(
            R"({{"playing_seconds": {}, "roles": [{{"striker": {{"overlap_seconds": {}}}}}, {{"striker": {{"overlap_seconds": {}}}}}]}})",
            seconds, home, away));
  };
  // 30 s and 90 s in 600 s and 1200 s: 4 minutes in 60.
  EXPECT_THAT(of({played(600, 30, 777), played(1200, 777, 90)}), ElementsAre(4.0));
}

TEST_F(Scores, AMetricThatAMatchHasNotIsMissing) {
  plan.objective.terms = {{"packets", 1.0}};
  EXPECT_TRUE(std::isnan(of({match(1, 0), match(0, 1, R"({"packets": [1, 2]})")}).front()));
  EXPECT_FALSE(own_failed);
}

TEST_F(Scores, OwnForfeitsAreLostAndOfTheOpponentMissing) {
  EXPECT_THAT(of({failed(0), match(0, 2)}), ElementsAre((-10.0 + 2.0) / 2.0));
  EXPECT_TRUE(own_failed);
  EXPECT_EQ(forfeits->of_team()[0], 1u);
  EXPECT_THAT(of({match(1, 0), failed(1)}), ElementsAre((1.0 - 10.0) / 2.0));
  plan.most_goals = 3;
  EXPECT_THAT(of({failed(0), match(0, 2)}), ElementsAre((-3.0 + 2.0) / 2.0));
  plan.objective.terms = {{"points", 1.0}};
  EXPECT_THAT(of({failed(0), match(0, 2)}), ElementsAre(0.5));
  // What a match that was not played has no number for.
  plan.objective.terms = {{"packets", 1.0}};
  EXPECT_TRUE(std::isnan(of({failed(0), match(0, 2, R"({"packets": [1, 2]})")}).front()));
  plan.objective.terms = {{"points", 1.0}};
  const auto other = of({failed(1), match(0, 2), match(1, 0), match(0, 0)});
  EXPECT_TRUE(std::isnan(other[0]));
  EXPECT_EQ(other[1], 0.75);
  EXPECT_FALSE(own_failed);
  EXPECT_EQ(forfeits->of_team()[1], 1u);
}

TEST_F(Scores, OneOpponentsForfeitLeavesThePairOut) {
  plan = tuning_of(1, 2);
  EXPECT_TRUE(std::isnan(of({match(1, 0), match(0, 1), match(1, 0), failed(0)}).front()));
  EXPECT_EQ(forfeits->of_team()[2], 1u);
}

TEST_F(Scores, HeadToHeadForfeits) {
  EXPECT_THAT(of({failed(0), match(0, 2)}, true), testing::ElementsAre(testing::NanSensitiveDoubleEq(std::nan(""))));
  EXPECT_TRUE(own_failed);
  EXPECT_EQ(forfeits->of_team()[0], 1u);
  of({failed(1), match(0, 2)}, true);
  EXPECT_FALSE(own_failed);
  EXPECT_EQ(forfeits->of_team()[2], 1u);  // the base team as an opponent
}

// Weights sum up to 1 only nearly: a score may not leave its bounds, which the test of the verification relies on.
TEST_F(Scores, StayWithinTheirBounds) {
  for (std::size_t opponents = 1; opponents <= 32; ++opponents) {
    plan = tuning_of(1, opponents);
    std::vector<double> weights;
    double sum = 0.0;
    for (std::size_t i = 0; i < opponents; ++i) sum += weights.emplace_back(1.0 + 0.7 * static_cast<double>(i % 5));
    for (std::size_t i = 0; i < opponents; ++i) plan.opponents[i].weight = weights[i] / sum;
    for (const auto& terms :
         {std::vector<ObjectiveTerm>{{"goal_difference", 1.0}}, {{"points", 0.1}, {"goal_difference", 0.3}}}) {
      plan.objective.terms = terms;
      std::vector<campaign::MatchResult> best, worst;
      for (std::size_t i = 0; i < opponents; ++i) {
        best.insert(best.end(), {match(10, 0), match(0, 10)});
        worst.insert(worst.end(), {match(0, 10), match(10, 0)});
      }
      const ScoreBounds bounds = *score_bounds(plan);
      EXPECT_LE(of(best).front(), bounds.high) << opponents;
      EXPECT_GE(of(worst).front(), bounds.low) << opponents;
    }
  }
}

// Neither lost nor won: as if it had never been.
TEST_F(Scores, AMatchThatCouldNotBePlayedLeavesItsPairMissing) {
  campaign::MatchResult none;
  none.ended = "set_aside";
  none.why_set_aside = "Aborted";
  for (const bool head_to_head : {false, true}) {
    const std::vector<double> scores =
        of({match(3, 0), match(1, 2), none, match(0, 9), match(5, 0), none, match(3, 0), match(1, 2)}, head_to_head);
    ASSERT_EQ(scores.size(), 4u);
    EXPECT_EQ(scores[0], scores[3]);
    EXPECT_TRUE(std::isnan(scores[1]));
    EXPECT_TRUE(std::isnan(scores[2]));
    EXPECT_THAT(unplayed, ElementsAre(false, true, true, false));
    EXPECT_FALSE(own_failed);
    EXPECT_THAT(forfeits->listed(), testing::IsEmpty());
  }
  EXPECT_EQ(remarks.unplayed.count(), 4u);
  EXPECT_EQ(remarks.unplayed.listed()[1], (MatchRemark{5, "Aborted"}));
}

}  // namespace
}  // namespace regista::study
