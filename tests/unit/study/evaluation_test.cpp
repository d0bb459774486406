// SPDX-License-Identifier: MIT
// The protocol on paths whose errors are known, and what is shown of a recording.
#include "study/prediction/evaluation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "study/prediction/forecast.hpp"

namespace regista::study {
namespace {

// The ball for 10 s at 100 Hz along x, running from 2 s on.
template <class Place>
GameRecording path(Place place) {
  Stretch stretch{1, {}, {{0.0, false}, {2.0, true}}};
  for (int i = 0; i <= 1000; ++i) stretch.samples.push_back({0.01 * i, ball_object, place(0.01 * i), 0.0});
  return {"made up", {stretch}};
}

config::PredictorStudy study() {
  config::PredictorStudy out;
  out.baselines.deceleration = 0.5;
  return out;
}

TEST(Evaluation, OfBaselinesOnAStraightLine) {
  const Evaluation result = evaluate(study(), path([](double t) { return 2.0 * t; }), nullptr);
  EXPECT_EQ(result.starts, 267u) << "every third of 1001 from 2 s on";
  for (const AtHorizon& at : result.horizons) {
    EXPECT_NEAR(at.hold.median, 2.0 * at.horizon, 1e-9);
    EXPECT_NEAR(at.hold.ninetieth, 2.0 * at.horizon, 1e-9);
    EXPECT_NEAR(at.constant.median, 0.0, 1e-9);
    EXPECT_NEAR(at.decayed.median, 0.25 * at.horizon * at.horizon, 1e-9) << "a h^2 / 2";
    EXPECT_EQ(at.answers, 0u) << "there was no predictor";
  }
  // A start 1 s before the end has a truth, one later has none.
  EXPECT_LT(result.horizons[3].truths, result.starts);
  EXPECT_EQ(result.horizons[3].truths, 234u);
}

TEST(Evaluation, CountsTheTimeSinceTheLastObservation) {
  config::PredictorStudy sparse = study();
  sparse.observations.every = 0.5;
  sparse.baselines.window = 2.0;
  sparse.baselines.least = 2;
  const Evaluation result = evaluate(sparse, path([](double t) { return 2.0 * t; }), nullptr);
  EXPECT_EQ(result.observations, 21u);
  for (const AtHorizon& at : result.horizons) {
    EXPECT_NEAR(at.hold.median, 2.0 * (at.horizon + 0.25), 0.03) << "the last was seen 0.25 s ago at the median";
    EXPECT_NEAR(at.constant.median, 0.0, 1e-9);
  }
}

TEST(Evaluation, RefusesARecordingWithoutStarts) {
  config::PredictorStudy strict = study();
  strict.baselines.least = 100;
  EXPECT_THROW(evaluate(strict, path([](double) { return 0.0; }), nullptr), config::Error);
}

TEST(Observations, AreLostIndependentlyAndAlwaysTheSame) {
  const GameRecording recording = path([](double) { return 0.0; });
  config::PredictorStudy::Observations half{0.0, 0.3, 7};
  const std::vector<bool> once = shown(recording.stretches[0], half);
  EXPECT_EQ(once, shown(recording.stretches[0], half));
  const double share = static_cast<double>(std::count(once.begin(), once.end(), true)) / 1001.0;
  EXPECT_NEAR(share, 0.7, 3.0 * std::sqrt(0.21 / 1001.0));
  half.seed = 8;
  EXPECT_NE(once, shown(recording.stretches[0], half));
  half.drop = 1.0;
  const std::vector<bool> none = shown(recording.stretches[0], half);
  EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

}  // namespace
}  // namespace regista::study
