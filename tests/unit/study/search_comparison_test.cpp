// SPDX-License-Identifier: MIT
// The course of a comparison of search algorithms, with matches whose results follow from a known function of the
// values.
#include "study/tuning/search_comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "config/sanitized.hpp"
#include "study/tuning/base_team_check.hpp"
#include "study/tuning/pair_search.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::HasSubstr;

// Best at 0.8 in every parameter.
double hill(const ParameterValues& values) {
  double out = 2.0;
  for (const double each : values) out -= 6.0 * (each - 0.8) * (each - 0.8);
  return out;
}

SearchComparisonPlan small() {
  SearchComparisonPlan out{tuning_of(2, 2), {Algorithm::random_search, Algorithm::sbplx, Algorithm::spsa}, 2};
  out.tuning.search_pairs = 40;
  out.tuning.pairs = 2;
  out.tuning.verification_pairs = 6;
  return out;
}

struct Compared {
  explicit Compared(const SearchComparisonPlan& asked = small())
      : plan(asked), matches(plan.tuning, hill, 1.0), record(plan) {}
  Compared(const Compared&) = delete;
  Compared& operator=(const Compared&) = delete;

  SearchComparisonRecord& run() {
    compare_searches(plan, matches.hook(), record);
    return record;
  }

  SearchComparisonPlan plan;
  FakeMatches matches;
  SearchComparisonRecord record;
};

TEST(SearchComparison, AllAlgorithmsHaveEqualTerms) {
  Compared once, again;
  const SearchComparisonRecord& record = once.run();
  ASSERT_EQ(record.runs.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(record.runs[i].algorithm, once.plan.algorithms[i % 3]);
    EXPECT_EQ(record.runs[i].repeat, i / 3);
    EXPECT_LE(record.runs[i].matches, once.plan.tuning.search_pairs * once.plan.tuning.matches_of_pair());
    EXPECT_GT(record.runs[i].evaluations, 1u);
    EXPECT_EQ(record.runs[i].judged.pairs, 6);
    EXPECT_FALSE(record.runs[i].ended.empty());
  }
  EXPECT_FALSE(record.stage);
  EXPECT_LE(record.tally.matches, most_matches(once.plan));
  EXPECT_EQ(told(again.run()), told(record));
  EXPECT_NE(record.runs[0].values, record.runs[3].values);  // another seed
}

// A run is the search of a tuning by that algorithm, which starts at that seed and plays matches of that repeat.
TEST(SearchComparison, ARunIsASearchOverPairs) {
  Compared compared;
  compared.run();
  for (const ComparedRun& run : compared.record.runs) {
    const TunedDocument document(compared.plan.tuning);
    FakeMatches matches(compared.plan.tuning, hill, 1.0);
    const PlayMatches play = matches.hook();
    MatchTally tally(compared.plan.tuning);
    std::vector<SearchStep> steps;
    const SearchFindings found =
        search_over_pairs({compared.plan.tuning, document, play, tally}, run.algorithm, run.repeat, {}, steps);
    EXPECT_EQ(found.recommended.front(), run.values);
    EXPECT_EQ(steps.size(), run.evaluations);
    EXPECT_EQ(tally.matches, run.matches);
    EXPECT_EQ(found.ended, run.ended);
    for (const auto& [key, decided] : matches.store) EXPECT_EQ(key.second >> 40, run.repeat);
  }
}

TEST(SearchComparison, RunsAreJudgedOnPairsThatNoSearchHasSeen) {
  Compared compared;
  compared.run();
  std::set<std::uint64_t> searched, judged;
  for (const auto& [key, decided] : compared.matches.store) {
    const auto stage = static_cast<TuningStage>(key.second >> 50);
    EXPECT_TRUE(stage == TuningStage::search || stage == TuningStage::verification);
    (stage == TuningStage::search ? searched : judged).insert(key.second & ((std::uint64_t{1} << 40) - 1));
  }
  EXPECT_EQ(judged.size(), 6u);
  for (const std::uint64_t each : judged) EXPECT_FALSE(searched.contains(each));
}

struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

TEST(SearchComparison, ResumesAfterEveryMatch) {
  Compared whole;
  const std::string expected = told(whole.run());
  ASSERT_GT(whole.matches.played, 500u);
  for (std::uint64_t last = 0; last < whole.matches.played; last += sanitized ? 49 : 7) {
    Compared stopped, again;
    stopped.matches.before = [last](std::uint64_t played) {
      if (played == last) throw Interrupted("now");
    };
    ASSERT_THROW(stopped.run(), Interrupted);
    EXPECT_TRUE(stopped.record.stage);
    again.matches.store = stopped.matches.store;
    ASSERT_EQ(told(again.run()), expected) << last;
    EXPECT_EQ(again.matches.rows, whole.matches.rows);
  }
}

TEST(SearchComparison, EveryMatchHasARowOfItsOwn) {
  Compared compared;
  compared.run();
  for (std::size_t i = 0; i < compared.matches.rows.size(); ++i) EXPECT_EQ(compared.matches.rows[i], i);
  EXPECT_EQ(compared.matches.rows.size(), compared.record.tally.matches);
}

// As a study it asks the same matches, in rounds that follow each other.
TEST(SearchComparison, IsAStudy) {
  Compared compared;
  const std::string expected = told(compared.run());
  SearchComparison study(compared.plan);
  EXPECT_EQ(study.most_matches(), most_matches(compared.plan));
  EXPECT_THAT(study.differences(study.plan()), testing::IsEmpty());
  std::uint64_t next = 0, first_twice = 0;
  study.run([&](const Round& round) {
    EXPECT_EQ(round.first_row, next);
    next += round.matches;
    for (std::uint64_t i = 0; i < round.matches; ++i) {
      if (round.first_of_pairing(i)) ++first_twice;
      const campaign::Decided decided = compared.matches.play(round.job(i));
      EXPECT_EQ(round.at(i)->seed, round.job(i).seed);
      if (!round.take(i, &decided)) return;
    }
  });
  EXPECT_EQ(told(study.record()), expected);
  EXPECT_EQ(study.counted(), study.record().tally.matches);
  EXPECT_EQ(first_twice, 1u);
}

TEST(SearchComparison, ABaseTeamThatForfeitsEndsIt) {
  Compared compared;
  compared.matches.judge = [](const campaign::Job& job, campaign::Decided& out) {
    if (job.teams[0] == "base.yaml") out = campaign::forfeit({0, "greedy", "assign", 1, 5, "died"}, 1.0);
  };
  try {
    compared.run();
    FAIL();
  } catch (const TuningError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the base team forfeits its first matches: plugin greedy in assign: died"));
  }
  EXPECT_TRUE(compared.record.runs.empty());
}

// In the first run only values of the tuned team forfeit; in the second no match of the base team has a number. Nobody
// else's forfeit is the reason.
TEST(SearchComparison, ALaterRunWhoseBaseTeamHasNoNumberEndsItToo) {
  SearchComparisonPlan plan = small();
  plan.tuning.objective.terms = {{"packets", 1.0}};
  Compared compared(plan);
  compared.matches.judge = [](const campaign::Job& job, campaign::Decided& out) {
    const std::size_t side = job.teams[0] == "base.yaml" ? 0 : 1;
    const bool base = said_values(job, side, 2) == ParameterValues{0.5, 0.5};
    if ((job.seed >> 40) % 1024 == 0 && !base)
      out = campaign::forfeit({static_cast<int>(side), "x", "y", 1, 1, "died"}, 1.0);
    if ((job.seed >> 40) % 1024 == 1) out.metrics = {};
  };
  try {
    compared.run();
    FAIL();
  } catch (const TuningError& error) {
    EXPECT_STREQ(error.what(), "the base team's first matches have no number for the objective, packets");
  }
}

}  // namespace
}  // namespace regista::study
