// SPDX-License-Identifier: MIT
// The stages of a tuning by themselves: what each makes of the data that the one before it hands on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "study/tuning/pair_search.hpp"
#include "study/tuning/tuning_study.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

double slope(const ParameterValues& values) { return 4.0 * values[0] - 2.0; }

struct Source {
  explicit Source(const TuningPlan& asked, double noise = 0.5)
      : plan(asked), document(plan), matches(plan, slope, noise), play(matches.hook()), tally(plan) {}
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;
  MatchSource source() { return {plan, document, play, tally}; }

  TuningPlan plan;
  TunedDocument document;
  FakeMatches matches;
  PlayRound play;
  MatchTally tally;
};

PlayedScore scored(double mean, double deviation = 1.0) {
  PlayedScore out;
  out.score.pairs = 4;
  out.score.mean = out.counted = mean;
  out.score.standard_deviation = deviation;
  return out;
}

TEST(MatchTally, BatchesFollowEachOther) {
  Source of(tuning_of(1, 2));
  const MatchSource source = of.source();
  for (const std::uint64_t first : {0u, 12u}) {
    PairBatch batch(of.plan, of.document, {{0.25}}, {TuningStage::search, 1, first, 3});
    play_batch(source, batch);
    EXPECT_EQ(batch.round().first_row, first);
    EXPECT_EQ(batch.pairs(), 3u);
  }
  EXPECT_EQ(of.tally.matches, 24u);
}

TEST(MatchTally, AfterAPairItMayBeEnough) {
  Source of(tuning_of(1, 2));
  PairBatch batch(of.plan, of.document, {{0.25}}, {TuningStage::verification, 1, 0, 5});
  play_batch(of.source(), batch, [&] { return batch.pairs() < 2; });
  EXPECT_EQ(batch.pairs(), 2u);
  EXPECT_EQ(of.matches.played, 8u);
  EXPECT_EQ(of.tally.matches, 20u);  // asked for
}

TEST(PlayedScore, WithoutANumberItIsTheWorst) {
  TuningPlan plan = tuning_of(1, 1);
  plan.objective.terms = {{"no_such_number", 1.0}};
  Source of(plan);
  PairBatch batch(of.plan, of.document, {{0.25}}, {TuningStage::search, 1, 0, 2});
  play_batch(of.source(), batch);
  EXPECT_EQ(played_score(of.plan, batch, 0, HUGE_VAL).counted, 0.0);
  EXPECT_EQ(played_score(of.plan, batch, 0, -3.0).counted, -3.0);
  EXPECT_EQ(worst_of(batch, 1, -3.0), -3.0);
  EXPECT_THROW(check_base_team(of.plan, played_score(of.plan, batch, 0, HUGE_VAL), of.tally), TuningError);
}

TEST(SearchOverPairs, KeepsWhatEverySetOfPairsSaid) {
  TuningPlan plan = tuning_of(1, 1, Algorithm::sbplx);
  plan.pairs = 4;
  plan.search_pairs = 80;
  Source of(plan);
  std::vector<SearchStep> steps;
  const SearchFindings found = search_over_pairs(of.source(), {}, steps);
  ASSERT_GT(steps.size(), 2u);
  double worst = HUGE_VAL;
  for (const SearchStep& each : steps) {
    const auto seen = seen_in_search(found.scores, each.values, plan.confidence());
    ASSERT_TRUE(seen);
    EXPECT_EQ(seen->score.mean, each.played.score.mean);  // its one set of pairs
    for (const double score : found.scores.at({each.values, 0}).scores) worst = std::min(worst, score);
  }
  EXPECT_EQ(found.worst, worst);
  EXPECT_FALSE(seen_in_search(found.scores, {0.123}, plan.confidence()));
  EXPECT_LE(steps.back().matches, plan.search_pairs * plan.matches_of_pair());
}

TEST(SearchOverPairs, BeginsAtTheBestOfTheGivenPoints) {
  // Two hills: a local algorithm climbs the wide one at 0.4 from the base team, at 0.5, and does not see the narrow
  // one.
  const auto hills = [](const ParameterValues& values) {
    const double x = values[0];
    return std::max(2.0 - 20.0 * std::abs(x - 0.4), 8.0 - 200.0 * std::abs(x - 0.95));
  };
  const auto best_after = [&](const std::vector<ParameterValues>& starts) {
    TuningPlan plan = tuning_of(1, 1, Algorithm::sbplx);
    plan.pairs = 1;
    plan.starts = starts;
    Source of(plan, 0.0);
    FakeMatches matches(of.plan, hills, 0.0);
    const PlayRound play = matches.hook();
    std::vector<SearchStep> steps;
    const SearchFindings found = search_over_pairs({of.plan, of.document, play, of.tally}, {}, steps);
    EXPECT_EQ(steps[0].values, ParameterValues{0.5}) << "the base team is still the first";
    for (std::size_t i = 0; i < starts.size(); ++i) EXPECT_EQ(steps[i + 1].values, starts[i]);
    EXPECT_LE(steps.back().matches, plan.search_pairs * plan.matches_of_pair());
    return found.recommended.front()[0];
  };
  EXPECT_NEAR(best_after({}), 0.4, 0.1);
  EXPECT_NEAR(best_after({{0.1}, {0.94}, {0.2}}), 0.95, 0.02);
}

TEST(SearchOverPairs, OutOfTimeIsAskedBeforeEveryQuestionButTheFirst) {
  Source of(tuning_of(1, 1, Algorithm::spsa));
  std::vector<std::uint64_t> asked;
  std::vector<SearchStep> steps;
  const auto out_of_time = [&asked](std::uint64_t evaluations) {
    asked.push_back(evaluations);
    return evaluations >= 3;
  };
  const SearchFindings found = search_over_pairs(of.source(), out_of_time, steps);
  EXPECT_EQ(found.ended, "its time was up");
  EXPECT_THAT(asked, ElementsAre(1, 3));
  EXPECT_EQ(steps.size(), 3u);
}

TEST(Selection, CandidatesAreThoseBeforeTheBaseTeam) {
  TuningPlan plan = tuning_of(1, 1);
  plan.asked.verification.candidates = 3;
  const Finalist a{{0.7}, {}, scored(3.0)}, base{{0.5}, {}, scored(2.0)}, c{{0.6}, {}, scored(1.0)};
  EXPECT_THAT(candidates_among(plan, {a, base, c}), ElementsAre(0u));
  EXPECT_THAT(candidates_among(plan, {base, a, c}), IsEmpty());
  EXPECT_THAT(candidates_among(plan, {a, c, base}), ElementsAre(0u, 1u));
  plan.asked.verification.candidates = 1;
  EXPECT_THAT(candidates_among(plan, {a, c, base}), ElementsAre(0u));
}

TEST(Selection, FinalistsAreDifferentAndInTheOrderOfTheSelection) {
  TuningPlan plan = tuning_of(1, 1);
  plan.asked.selection.finalists = 3;
  plan.selection_pairs = 40;
  Source of(plan, 0.1);
  SearchFindings found;
  found.recommended = {{0.2}, {0.9}, {0.2}, {0.6}, {1.0}};
  const std::vector<Finalist> finalists = select_finalists(of.source(), found);
  ASSERT_EQ(finalists.size(), 3u);
  EXPECT_THAT(finalists[0].values, ElementsAre(0.9));
  EXPECT_THAT(finalists[1].values, ElementsAre(0.6));
  EXPECT_THAT(finalists[2].values, ElementsAre(0.2));
  EXPECT_FALSE(finalists[0].seen);
}

TEST(Selection, DeviationIsThatOfTheFinalistsOrElseOfTheSearch) {
  const Finalist one{{0.1}, {}, scored(0.0, 3.0)}, other{{0.2}, {}, scored(0.0, 4.0)},
      still{{0.3}, {}, scored(0.0, 0.0)};
  EXPECT_DOUBLE_EQ(deviation_of({one, other}, {}), std::sqrt(12.5));
  EXPECT_EQ(deviation_of({still}, {}), 1.0);
  SearchScores scores;
  scores[{{0.3}, 0}] = {{1.0, std::nan(""), 3.0}, {}};
  EXPECT_DOUBLE_EQ(deviation_of({still}, scores), std::sqrt(2.0));
}

TEST(DrawnSeed, IsAnotherForEverythingThatWasChosen) {
  TuningPlan plan = tuning_of(1, 2);
  const auto drawn = [](const TuningPlan& of, const std::vector<ParameterValues>& chosen) {
    return drawn_seed(of, TunedDocument(of), chosen);
  };
  const std::uint64_t first = drawn(plan, {{0.25}});
  EXPECT_EQ(first, drawn(plan, {{0.25}}));
  EXPECT_LT(first, std::uint64_t{1} << 31);
  EXPECT_NE(first, drawn(plan, {{0.75}}));
  EXPECT_NE(first, drawn(plan, {{0.25}, {0.75}}));
  plan.asked.seed = 8;
  EXPECT_NE(first, drawn(plan, {{0.25}}));
  plan.asked.seed = 7;
  plan.opponents[1].jobs[0].away_inputs[0].hash = "other";
  EXPECT_NE(first, drawn(plan, {{0.25}}));
}

TEST(VerifyCandidates, StopsWhenAllAreDecided) {
  TuningPlan plan = tuning_of(1, 1);
  plan.verification_pairs = 2000;
  plan.asked.verification.candidates = 2;
  Source of(plan);
  TuningRecord record(plan);
  record.finalists = {{{1.0}, {}, scored(2.0)}, {{0.9}, {}, scored(1.0)}};
  record.candidates = {0, 1};
  verify_candidates(of.source(), 1.0, record);
  EXPECT_EQ(record.finding(0), VerifiedAs::better);
  EXPECT_EQ(record.finding(1), VerifiedAs::better);
  EXPECT_LT(record.verification.pairs(), 500u);
  EXPECT_EQ(record.tuned(), 0u);
  record.candidates.clear();
  verify_candidates(of.source(), 1.0, record);
  EXPECT_EQ(record.verification.pairs(), 0u);
  EXPECT_FALSE(record.tuned());
}

TEST(SlicesAround, ThereAreNoneWhereNoneAreWanted) {
  Source of(tuning_of(2, 1));
  EXPECT_THAT(slices_around(of.source(), {0.5, 0.5}), IsEmpty());
  EXPECT_EQ(of.tally.matches, 0u);
}

TEST(SlicesAround, TheMostImportantParameterIsFirst) {
  TuningPlan plan = tuning_of(2, 1);
  plan.asked.slices.points = 5;
  plan.asked.slices.pairs = 20;
  Source of(plan);
  const std::vector<Slice> slices = slices_around(of.source(), {0.5, 0.5});
  ASSERT_EQ(slices.size(), 2u);
  EXPECT_EQ(slices[0].parameter, 0u);
  EXPECT_GT(slices[0].importance, slices[1].importance);
}

}  // namespace
}  // namespace regista::study
