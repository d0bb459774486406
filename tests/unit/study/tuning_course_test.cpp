// SPDX-License-Identifier: MIT
// The course of a tuning, with matches whose results follow from a known function of the values.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "process/sanitized.hpp"
#include "study/tuning/tuning_study.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

// Best at 0.8 in every parameter, where it is 2 goals; the base team at 0.5.
double hill(const ParameterValues& values) {
  double out = 2.0;
  for (const double each : values) out -= 12.0 * (each - 0.8) * (each - 0.8) / static_cast<double>(values.size());
  return out;
}

struct Course {
  explicit Course(const TuningPlan& plan_of_it, double noise = 1.0, FakeMatches::Strength strength = hill)
      : plan(plan_of_it), matches(plan, std::move(strength), noise), record(plan) {
    play = matches.hook();
  }
  Course(const Course&) = delete;
  Course& operator=(const Course&) = delete;

  TuningRecord& tune() {
    study::tune(plan, play, out_of_time, record);
    return record;
  }

  TuningPlan plan;
  FakeMatches matches;
  PlayRound play;
  OutOfTime out_of_time;
  TuningRecord record;
};

TuningPlan small(Algorithm algorithm = Algorithm::random_search) {
  TuningPlan plan = tuning_of(2, 2, algorithm);
  plan.search_pairs = 24;
  plan.pairs = 2;
  plan.selection_pairs = 2;
  plan.asked.verification.candidates = 2;
  plan.verification_pairs = 6;
  plan.asked.slices.points = 3;
  plan.asked.slices.pairs = 2;
  return plan;
}

constexpr Algorithm every_kind[] = {Algorithm::random_search, Algorithm::sbplx, Algorithm::spsa, Algorithm::sep_cma_es};

TEST(Tune, FindsTheTop) {
  for (const Algorithm algorithm : {Algorithm::random_search, Algorithm::sbplx, Algorithm::sep_cma_es}) {
    TuningPlan plan = tuning_of(2, 2, algorithm);
    plan.search_pairs = 600;
    plan.pairs = 5;
    plan.selection_pairs = 30;
    plan.verification_pairs = 200;
    Course run(plan);
    const TuningRecord& record = run.tune();
    ASSERT_TRUE(record.tuned());
    EXPECT_TRUE(record.verified()) << name(algorithm);
    const ParameterValues& found = record.finalists[*record.tuned()].values;
    EXPECT_GT(hill(found), hill(start_values(plan)) + 0.5) << name(algorithm);
    for (const double each : found) EXPECT_NEAR(each, 0.8, 0.2) << name(algorithm);
    // The true difference is in the interval.
    EXPECT_TRUE(record.verification.of()[0].estimate().interval.contains(hill(found) - hill(start_values(plan))));
    EXPECT_FALSE(record.stage);
  }
}

TEST(Tune, TheBaseTeamIsLookedAtFirst) {
  for (const Algorithm algorithm : every_kind) {
    Course run(small(algorithm));
    const TuningRecord& record = run.tune();
    ASSERT_FALSE(record.trace.empty());
    EXPECT_EQ(record.trace[0].values, start_values(run.plan));
    EXPECT_EQ(record.trace[0].evaluation, 1u);
    double best = record.trace[0].played.counted;
    for (std::size_t i = 0; i < record.trace.size(); ++i) {
      EXPECT_EQ(record.trace[i].evaluation, i + 1);
      best = std::max(best, record.trace[i].played.counted);
      EXPECT_EQ(record.trace[i].best, best);
    }
  }
}

TEST(Tune, TheSameRunTwiceIsTheSame) {
  for (const Algorithm algorithm : every_kind) {
    Course a(small(algorithm)), b(small(algorithm));
    EXPECT_EQ(told(a.tune()), told(b.tune())) << name(algorithm);
    EXPECT_EQ(a.matches.rows, b.matches.rows);
    TuningPlan other = small(algorithm);
    other.asked.seed = 8;
    Course c(other);
    EXPECT_NE(told(c.tune()), told(a.record));
  }
}

struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Whenever it is killed, what was played is there, and going on from it comes to the same end.
TEST(Tune, ResumesAfterAnyMatch) {
  for (const Algorithm algorithm : every_kind) {
    Course whole(small(algorithm));
    const std::string expected = told(whole.tune());
    ASSERT_GT(whole.matches.played, 100u);
    for (std::uint64_t last = 0; last < whole.matches.played; last += sanitized ? 29 : 3) {
      Course run(small(algorithm));
      run.matches.before = [last](std::uint64_t played) {
        if (played == last) throw Interrupted("now");
      };
      ASSERT_THROW(run.tune(), Interrupted);
      EXPECT_EQ(run.matches.played, last);
      Course again(small(algorithm));
      again.matches.store = run.matches.store;
      ASSERT_EQ(told(again.tune()), expected) << name(algorithm) << ' ' << last;
      EXPECT_EQ(again.matches.played + last, whole.matches.played);
      EXPECT_EQ(again.matches.rows, whole.matches.rows);
    }
  }
}

TEST(Tune, EveryMatchIsAskedForOnceAndInItsOwnRow) {
  for (const Algorithm algorithm : every_kind) {
    Course run(small(algorithm));
    const TuningRecord& record = run.tune();
    EXPECT_EQ(run.matches.played, run.matches.store.size());
    const std::set<std::uint64_t> rows(run.matches.rows.begin(), run.matches.rows.end());
    EXPECT_EQ(rows.size(), run.matches.rows.size());
    EXPECT_LT(*rows.rbegin(), record.tally.matches);
  }
}

// Two points of which one has been played on the same pairs: nothing is played again, and it is told.
TEST(Tune, EqualPointsOnEqualPairsArePlayedOnce) {
  TuningPlan plan = small(Algorithm::sbplx);
  plan.parameters[0] = {"p0", 0.0, 0.0, 2.0, true, false, "", ""};  // few different values
  plan.parameters[1] = {"p1", 0.0, 0.0, 2.0, true, false, "", ""};
  plan.document = "team: base\np0: 0\np1: 0\n";
  plan.search_pairs = 80;
  Course run(plan, 1.0, [](const ParameterValues& values) { return values[0] + values[1]; });
  const TuningRecord& record = run.tune();
  std::set<std::pair<ParameterValues, std::uint64_t>> seen;
  std::uint64_t repeated = 0, matches = 0;
  for (const SearchStep& each : record.trace) {
    const bool fresh = seen.emplace(each.values, each.pairs_from).second;
    EXPECT_EQ(each.repeated, !fresh);
    repeated += each.repeated ? 1 : 0;
    matches += each.repeated ? 0 : plan.pairs * plan.matches_of_pair();
    EXPECT_EQ(each.matches, matches);
  }
  EXPECT_GT(repeated, 0u);
  EXPECT_EQ(run.matches.played, run.matches.store.size());
}

TEST(Tune, NoStageGoesBeyondItsBudget) {
  for (std::size_t which = 0; which < algorithm_names().size(); ++which) {
    TuningPlan plan = small(static_cast<Algorithm>(which));
    for (const std::uint64_t pairs : {60u, 61u, 100u, 137u}) {
      plan.search_pairs = pairs;
      if (plan.evaluations() <= least_evaluations(plan.algorithm(), 2, 0)) continue;
      Course run(plan);
      std::map<TuningStage, std::uint64_t> taken;
      run.play = [&run, &taken, play = run.play](const Round& round) {
        const std::uint64_t before = run.matches.taken;
        play(round);
        taken[*run.record.stage] += run.matches.taken - before;
      };
      const TuningRecord& record = run.tune();
      for (const auto& [stage, count] : taken) EXPECT_LE(count, most_matches(plan, stage)) << name(plan.algorithm());
      EXPECT_LE(record.tally.matches, most_matches(plan));
      const auto fresh = std::ranges::count(record.trace, false, &SearchStep::repeated);
      EXPECT_LE(static_cast<std::uint64_t>(fresh), plan.evaluations());
    }
  }
}

TEST(Tune, ABaseTeamThatForfeitsEndsIt) {
  Course run(small());
  run.matches.judge = [](const campaign::Job& job, campaign::MatchResult& out) {
    if (job.teams[0] == "base.yaml") out = campaign::forfeit({0, "greedy", "assign", 1, 5, "died"}, 1.0);
  };
  try {
    run.tune();
    FAIL();
  } catch (const TuningError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the base team forfeits its first matches: plugin greedy in assign: died"));
  }
}

// Which of its plugins it was is not known; nor is it that of an opponent which forfeited before.
TEST(Tune, ABaseTeamThatForfeitsIsNamedWhereNoPluginIs) {
  Course run(small());
  run.matches.judge = [](const campaign::Job& job, campaign::MatchResult& out) {
    if (job.teams[0] == "base.yaml") out = campaign::forfeit({1, "scram", "assign", 1, 5, "hung"}, 1.0);
    if (job.teams[1] == "base.yaml") out = campaign::forfeit({1, "", "", 0, 0, "ran out of memory"}, 1.0);
  };
  try {
    run.tune();
    FAIL();
  } catch (const TuningError& error) {
    EXPECT_THAT(error.what(),
                EndsWith("the base team forfeits its first matches: a plugin of the base team: ran out of "
                         "memory"));
  }
}

// Where the hill is highest the plugin dies: such a point is worth no more than the worst, and is never found better.
TEST(Tune, ACandidateThatForfeitsIsWorthTheLeast) {
  for (const char* objective : {"goal_difference", "packets"}) {
    for (const Algorithm algorithm : every_kind) {
      TuningPlan plan = small(algorithm);
      plan.objective.terms = {{objective, 1.0}};
      plan.search_pairs = 200;
      Course run(plan, 0.5);
      run.matches.judge = [&plan](const campaign::Job& job, campaign::MatchResult& out) {
        const std::size_t side = job.teams[0] == plan.asked.team ? 0 : 1;
        if (hill(said_values(job, side, 2)) > 1.5)
          out = campaign::forfeit({static_cast<int>(side), "x", "y", 1, 1, "died"}, 1.0);
      };
      const TuningRecord& record = run.tune();
      double least = HUGE_VAL;
      bool any = false;
      for (const SearchStep& each : record.trace) {
        EXPECT_TRUE(std::isfinite(each.played.counted));
        least = std::min(least, each.played.counted);
      }
      for (const SearchStep& each : record.trace) {
        EXPECT_EQ(each.played.failed, hill(each.values) > 1.5);
        any = any || each.played.failed;
        if (each.played.failed) {
          EXPECT_LE(each.played.counted, record.trace[0].played.counted);
        }
      }
      EXPECT_TRUE(any) << name(algorithm);
      for (std::size_t i = 0; i < record.verification.of().size(); ++i) {
        if (record.candidate_failed[i]) {
          EXPECT_NE(record.finding(i), VerifiedAs::better);
        }
      }
      if (record.verified()) {
        EXPECT_LE(hill(record.finalists[*record.tuned()].values), 1.5);
      }
      if (std::string(objective) == "goal_difference") {
        EXPECT_EQ(least, any ? -10.0 : least);
      }
    }
  }
}

// It fails on a verification seed only: it is not better, however many it wins by.
TEST(Tune, ACandidateThatForfeitsInTheVerificationIsNotBetter) {
  for (const bool head_to_head : {false, true}) {
    TuningPlan plan = tuning_of(1, 1);
    plan.asked.verification.candidates = 1;
    if (head_to_head) plan.asked.verification.against = config::Tuning::Against::base;
    plan.verification_pairs = 200;
    Course run(plan, 0.5);
    int failures = 0;
    run.matches.judge = [&](const campaign::Job& job, campaign::MatchResult& out) {
      const bool verification = job.seed >> 50 == 2;
      if (!verification || said_values(job, 0, 1)[0] == 0.5 || failures > 0) return;
      ++failures;
      out = campaign::forfeit({0, "x", "y", 1, 1, "died"}, 1.0);
    };
    const TuningRecord& record = run.tune();
    ASSERT_EQ(record.candidates.size(), 1u);
    EXPECT_EQ(failures, 1);
    EXPECT_EQ(record.finding(0), VerifiedAs::undecided);
    EXPECT_FALSE(record.verified());
    EXPECT_EQ(record.tuned(), 0u);
  }
}

TEST(Tune, OpponentsThatForfeitLeaveTheirPairsOut) {
  Course run(small());
  run.matches.judge = [](const campaign::Job& job, campaign::MatchResult& out) {
    if (job.seed % 3 != 0) return;
    const int side = job.teams[0] == "base.yaml" ? 1 : 0;
    out = campaign::forfeit({side, "x", "y", 1, 1, "died"}, 1.0);
  };
  const TuningRecord& record = run.tune();
  for (const SearchStep& each : record.trace) {
    EXPECT_FALSE(each.played.failed);
    EXPECT_LE(each.played.score.pairs, 2);
    EXPECT_TRUE(std::isfinite(each.played.counted));
  }
  EXPECT_EQ(record.tally.forfeits.of_team()[0], 0u);
}

TEST(Tune, AnObjectiveThatNoMatchHasEndsIt) {
  TuningPlan plan = small();
  plan.objective.terms = {{"no_such_number", 1.0}};
  Course run(plan);
  try {
    run.tune();
    FAIL();
  } catch (const TuningError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("the base team's first matches have no number for the objective, no_such_number"));
  }
}

// A metric that is sometimes missing, here in two of three matches.
TEST(Tune, MetricsThatAreMissingNowAndThen) {
  TuningPlan plan = small(Algorithm::spsa);
  plan.objective.terms = {{"packets", 1.0}};
  plan.pairs = 6;
  plan.asked.search.pairs = static_cast<int>(plan.pairs);
  plan.search_pairs = 120;
  plan.verification_pairs = 60;
  Course run(plan);
  run.matches.judge = [](const campaign::Job& job, campaign::MatchResult& out) {
    if (job.seed % 3 == 0) out.metrics = campaign::metrics_from_json(R"({"playing_seconds": 600})");
  };
  const TuningRecord& record = run.tune();
  for (const SearchStep& each : record.trace) EXPECT_TRUE(std::isfinite(each.played.counted));
  for (const ScoreDifference& each : record.verification.of()) EXPECT_TRUE(std::isfinite(each.difference().mean()));
}

// --- Selection and verification ------------------------------------------------------------------------------------

TEST(Tune, FinalistsAreDifferentAndTheBestFirst) {
  for (const Algorithm algorithm : every_kind) {
    TuningPlan plan = small(algorithm);
    plan.search_pairs = 100;
    Course run(plan);
    const TuningRecord& record = run.tune();
    ASSERT_FALSE(record.finalists.empty());
    EXPECT_LE(record.finalists.size(), plan.finalists());
    std::set<ParameterValues> different;
    for (std::size_t i = 0; i < record.finalists.size(); ++i) {
      different.insert(record.finalists[i].values);
      EXPECT_EQ(record.finalists[i].selected.score.pairs, 2);
      if (i > 0) {
        EXPECT_GE(record.finalists[i - 1].selected.counted, record.finalists[i].selected.counted);
      }
    }
    EXPECT_EQ(different.size(), record.finalists.size());
    EXPECT_LE(record.candidates.size(), plan.candidates());
  }
}

// Where nothing is better than the base team, it is not verified against itself.
TEST(Tune, TheBaseTeamIsNoCandidate) {
  TuningPlan plan = small(Algorithm::sbplx);
  plan.search_pairs = 100;
  plan.selection_pairs = 20;
  Course run(plan, 0.1, [](const ParameterValues& values) {
    double out = 0.0;
    for (const double each : values) out -= 8.0 * std::abs(each - 0.5);
    return out;
  });
  const TuningRecord& record = run.tune();
  EXPECT_EQ(record.finalists.front().values, start_values(plan));
  EXPECT_TRUE(record.candidates.empty());
  EXPECT_FALSE(record.tuned());
  EXPECT_FALSE(record.verified());
  EXPECT_EQ(record.verification.pairs(), 0u);
  EXPECT_EQ(record.slices.size(), 2u);
}

std::set<std::uint64_t> verification_seeds(const Course& run) {
  std::set<std::uint64_t> out;
  for (const auto& [key, decided] : run.matches.store) {
    if (key.second >> 50 == 2) out.insert(key.second);
  }
  return out;
}

TEST(Tune, AnotherChoiceIsVerifiedOnOtherSeeds) {
  const TuningPlan plan = small();
  // Two landscapes, two choices.
  const auto left = [](const ParameterValues& values) { return 3.0 - 8.0 * values[0]; };
  const auto right = [](const ParameterValues& values) { return 8.0 * values[0] - 5.0; };
  Course a(plan, 0.2, left), b(plan, 0.2, right), c(plan, 0.2, left);
  a.tune();
  b.tune();
  c.tune();
  ASSERT_NE(a.record.finalists[0].values, b.record.finalists[0].values);
  ASSERT_FALSE(verification_seeds(a).empty());
  EXPECT_EQ(verification_seeds(a), verification_seeds(c));
  for (const std::uint64_t each : verification_seeds(a)) EXPECT_FALSE(verification_seeds(b).contains(each));
}

// A clear difference needs few pairs, and stops at the same one however often it is asked.
TEST(Tune, TheVerificationStopsWhenItIsDecided) {
  TuningPlan plan = tuning_of(1, 1);
  plan.search_pairs = 60;
  plan.verification_pairs = 2000;
  plan.asked.slices.points = 3;
  plan.asked.slices.pairs = 2;
  std::optional<std::uint64_t> at;
  for (int round = 0; round < 2; ++round) {
    Course run(plan, 1.0);
    const TuningRecord& record = run.tune();
    EXPECT_TRUE(record.verified());
    EXPECT_LT(record.verification.pairs(), 200u);
    if (at) {
      EXPECT_EQ(record.verification.pairs(), *at);
    }
    at = record.verification.pairs();
    // The slices come after it, in rows of their own.
    EXPECT_EQ(verification_seeds(run).size(), *at);
  }
}

TEST(Tune, OutOfTimeEndsTheSearchWithWhatItHas) {
  for (const Algorithm algorithm : every_kind) {
    for (const std::uint64_t last : {1u, 2u, 5u, 9u}) {
      Course run(small(algorithm)), again(small(algorithm));
      for (Course* each : {&run, &again}) {
        each->out_of_time = [last](std::uint64_t evaluations) { return evaluations >= last; };
      }
      const TuningRecord& record = run.tune();
      EXPECT_FALSE(record.stage);
      EXPECT_FALSE(record.finalists.empty());
      // One question may have used up the budget.
      const bool all = record.trace.size() == run.plan.evaluations();
      EXPECT_EQ(record.ended.find("time") == std::string::npos, all) << record.ended;
      EXPECT_TRUE(last > 1 || record.trace.size() == 1);
      EXPECT_EQ(told(again.tune()), told(record));
    }
  }
}

TEST(Tune, SlicesOfEveryFreeParameter) {
  TuningPlan plan = small();
  plan.parameters[1].least = plan.parameters[1].most = 0.5;
  plan.asked.slices.points = 5;
  plan.asked.slices.pairs = 20;
  Course run(plan, 0.5);
  const TuningRecord& record = run.tune();
  ASSERT_EQ(record.slices.size(), 1u);
  EXPECT_EQ(record.slices[0].parameter, 0u);
  EXPECT_GE(record.slices[0].points.size(), 5u);
  EXPECT_LT(*record.slices[0].p, 0.01);
}

}  // namespace
}  // namespace regista::study
