// SPDX-License-Identifier: MIT
// The shipped studies on recordings of real matches: the baselines give the published table, and on the Small Size
// League the medians of the shipped predictors are at least as near as its decayed velocity. Their covariances are
// right on average and at nine of ten; in the middle they are too wide (the 50 % ellipse holds 70 to 85 %), because
// touches have tails that no Gaussian has. On the 2D simulation decayed velocity is better beyond the first horizons:
// there a ball loses a share of its speed, not so much a second, and players turn at once.
//
// Data: real robots of the Small Size League (RoboCIn's logs, AmandaCLima/data_mining) and matches of the 2D simulation
// league (open-starlab/STP-challenge-2025); the table stands beside them in INDEX.md.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "config/documents.hpp"
#include "study/prediction/evaluation.hpp"

namespace regista::study {
namespace {

const std::string ssl = REGISTA_SHARED_DATA "/ssl/";
const std::string simulation = REGISTA_SHARED_DATA "/robocup2d/";

// A row of the table, mm.
using Row = std::array<double, horizon_count>;

Evaluation evaluate(const std::string& name, const std::string& data, const config::Overrides& overrides = {}) {
  const config::PredictorStudy study =
      config::read_document<config::PredictorStudy>(REGISTA_STUDIES "/" + name + ".yaml", overrides);
  const plugin::Catalogue catalogue({REGISTA_PLUGIN_FOLDER});
  const Evaluation result = study::evaluate(study, read_recording(study, data, {}), &catalogue);
  for (const AtHorizon& at : result.horizons) {
    std::printf("%s, %s, %g s ahead: %.1f mm (hold %.1f, constant %.1f, decayed %.1f), NEES %.2f, %.1f %% in 90 %%\n",
                name.c_str(), study.predictor.plugin.c_str(), at.horizon, 1e3 * at.predictor.median,
                1e3 * at.hold.median, 1e3 * at.constant.median, 1e3 * at.decayed.median, at.consistency.nees_mean,
                100.0 * at.consistency.within_90);
  }
  return result;
}

// The table rounds to millimetres, and does not say which of three (five) detections is the first start nor which
// detection two events share: choosing otherwise moves its medians by up to 2.5 %.
void expect_row(const Evaluation& result, Errors AtHorizon::*baseline, const Row& row) {
  for (std::size_t h = 0; h < horizon_count; ++h) {
    const double measured = 1e3 * (result.horizons[h].*baseline).median;
    EXPECT_NEAR(measured, row[h], 0.5 + 0.025 * row[h]) << result.horizons[h].horizon << " s ahead";
  }
}

// At or below the row of the table, which rounds, and what the baseline itself has on the very same starts.
void expect_at_or_below(const Evaluation& result, const Row& row) {
  for (std::size_t h = 0; h < horizon_count; ++h) {
    const AtHorizon& at = result.horizons[h];
    EXPECT_LE(1e3 * at.predictor.median, row[h] + 0.5) << at.horizon << " s ahead";
    EXPECT_LE(at.predictor.median, at.decayed.median) << at.horizon << " s ahead";
    EXPECT_GE(at.answers, 99 * at.truths / 100);
  }
}

// The bad cases are not worse than the baseline's either.
void expect_tail_at_or_below(const Evaluation& result) {
  for (const AtHorizon& at : result.horizons) {
    EXPECT_LE(at.predictor.ninetieth, at.decayed.ninetieth) << at.horizon << " s ahead";
  }
}

// Kicks and collisions have heavier tails than any ellipse: 2 at most a few times, and nine of ten where they should
// be.
void expect_consistent(const Evaluation& result) {
  for (const AtHorizon& at : result.horizons) {
    EXPECT_GT(at.consistency.nees_mean, 0.5) << at.horizon << " s ahead";
    EXPECT_LT(at.consistency.nees_mean, 5.0) << at.horizon << " s ahead";
    EXPECT_GT(at.consistency.within_90, 0.85) << at.horizon << " s ahead";
    EXPECT_GT(at.consistency.within_95, 0.9) << at.horizon << " s ahead";
  }
}

TEST(SmallSizeLeague, BallIsForetoldBetterThanByItsDecayedVelocity) {
  const std::string data = ssl + "zjunlict_ball_raw.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  const Evaluation result = evaluate("ssl_ball", data);
  expect_row(result, &AtHorizon::hold, {156, 387, 761, 1368});
  expect_row(result, &AtHorizon::constant, {12, 30, 98, 425});
  expect_row(result, &AtHorizon::decayed, {11, 27, 92, 384});
  expect_at_or_below(result, {11, 27, 92, 384});
  expect_tail_at_or_below(result);
  // Its ellipses are for a ball that nobody touches meanwhile.
  for (const AtHorizon& at : result.horizons) {
    EXPECT_GT(at.untouched, at.answers / 5) << at.horizon << " s ahead";
    EXPECT_GT(at.untouched_within_95, 0.9) << at.horizon << " s ahead";
    EXPECT_LT(at.untouched_within_95, 0.98) << at.horizon << " s ahead";
  }
}

TEST(SmallSizeLeague, EllipsesHoldTouchedBallsTooWhereTouchesAreReckonedWith) {
  const std::string data = ssl + "zjunlict_ball_raw.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  expect_consistent(evaluate("ssl_ball", data, {"predictor.params.unseen_touch_rate=1"}));
}

// The example of the help, and the other corner of docs/predictors.md: a few images a second, most of them lost.
TEST(SmallSizeLeague, KickedBallsAreFoundAgainFromAFewImages) {
  const std::string data = ssl + "zjunlict_ball_raw.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  for (const auto& [drop, window] : {std::pair("0.3", "0.5"), std::pair("0.6", "1.25")}) {
    const std::string observations = std::string("observations={every: 0.1, drop: ") + drop + ", seed: 1}";
    for (const bool imm : {false, true}) {
      config::Overrides overrides{observations, std::string("baselines.window=") + window};
      if (imm) overrides.push_back("predictor={plugin: imm_ball}");
      const Evaluation result = evaluate("ssl_ball", data, overrides);
      for (const AtHorizon& at : result.horizons) {
        EXPECT_LT(at.to_decayed.median.value, 1.0) << imm << ", " << drop << " lost, " << at.horizon << " s ahead";
        EXPECT_LT(at.to_decayed.ninetieth.value, 1.0) << imm << ", " << drop << " lost, " << at.horizon << " s ahead";
      }
    }
  }
}

TEST(SmallSizeLeague, RobotsAreForetoldBetterThanByTheirDecayedVelocity) {
  const std::string data = ssl + "zjunlict_robots_raw_40ev.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  const Evaluation result = evaluate("ssl_robots", data);
  expect_row(result, &AtHorizon::hold, {291, 542, 1009, 1767});
  expect_row(result, &AtHorizon::constant, {220, 519, 1188, 2640});
  expect_row(result, &AtHorizon::decayed, {214, 442, 874, 1618});
  expect_at_or_below(result, {214, 442, 874, 1618});
  expect_tail_at_or_below(result);
  expect_consistent(result);
}

// With the parameters that matches use. They expect slower kicks than that league's: too sure of itself, though near.
TEST(SmallSizeLeague, BallIsForetoldByInteractingModelsToo) {
  const std::string data = ssl + "zjunlict_ball_raw.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  expect_at_or_below(evaluate("ssl_ball", data, {"predictor.plugin=imm_ball"}), {11, 27, 92, 384});
}

// With that league's kicks (6.5 m/s at most, 2.65 a component) it is consistent, and not quite as near: not above the
// row by more than 4 %.
TEST(SmallSizeLeague, InteractingModelsAreConsistentWhenTheyKnowHowHardIsKicked) {
  const std::string data = ssl + "zjunlict_ball_raw.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  const Evaluation result =
      evaluate("ssl_ball", data,
               {"predictor={plugin: imm_ball, params: {speed_prior: 2.65, deceleration: 0.3, unseen_kick_rate: 1}}"});
  expect_tail_at_or_below(result);
  const Row row{11, 27, 92, 384};
  for (std::size_t h = 0; h < horizon_count; ++h) {
    EXPECT_LE(1e3 * result.horizons[h].predictor.median, 1.04 * row[h]);
    EXPECT_LT(result.horizons[h].consistency.nees_mean, 3.0);
    EXPECT_GT(result.horizons[h].consistency.within_90, 0.85);
  }
}

TEST(SmallSizeLeague, RobotsAreForetoldByTheMixtureDensityToo) {
  const std::string data = ssl + "zjunlict_robots_raw_40ev.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  const Evaluation result = evaluate("ssl_robots", data, {"predictor={plugin: gm_phd, params: {speed: 1}}"});
  expect_at_or_below(result, {214, 442, 874, 1618});
  expect_tail_at_or_below(result);
  expect_consistent(result);
}

// Shown ten times a second with three of ten lost, as packets are, it is off by more, and by less than a ball held.
TEST(SmallSizeLeague, BallIsForetoldFromAFewObservations) {
  const std::string data = ssl + "zjunlict_ball_raw.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  const Evaluation all = evaluate("ssl_ball", data);
  const Evaluation few = evaluate(
      "ssl_ball", data, {"observations={every: 0.1, drop: 0.3, seed: 1}", "baselines.window=0.5", "baselines.least=2"});
  EXPECT_LT(few.observations, all.observations / 7);
  for (std::size_t h = 0; h < horizon_count; ++h) {
    EXPECT_GT(few.horizons[h].predictor.median, all.horizons[h].predictor.median) << "less was known";
    EXPECT_LT(few.horizons[h].predictor.median, few.horizons[h].hold.median);
  }
}

TEST(Simulation2d, RecordingsAreReadAndForetold) {
  const std::string data = simulation + "input2024_01.csv.gz";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no recording " << data;
  const Evaluation ball = evaluate("simulation_2d_ball", data), players = evaluate("simulation_2d_robots", data);
  EXPECT_GT(ball.starts, 400u);
  EXPECT_LT(ball.horizons[0].predictor.median, ball.horizons[0].decayed.median);
  EXPECT_GT(players.starts, 2000u);
  for (const AtHorizon& at : players.horizons) {
    EXPECT_LT(at.predictor.median, at.hold.median);
    EXPECT_LT(at.predictor.median, at.constant.median);
  }
}

}  // namespace
}  // namespace regista::study
