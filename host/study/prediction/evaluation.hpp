// SPDX-License-Identifier: MIT
// How far a predictor is off over a recording, and how honest its covariance is, beside baselines.
//
// Protocol: while the game runs, every n-th detection of an object is a start. The truth `h` seconds later is the
// detection of that object nearest in time to start + h, within a tolerance; it is foretold for its own time. All are
// judged on the same starts: those at which the observations suffice for the baselines' velocity. The ball is foretold
// by the predictor's best hypothesis, an anonymous robot by the track that is nearest to it at the start.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "config/predictor_study.hpp"
#include "plugin/catalogue.hpp"
#include "study/prediction/error_ratios.hpp"
#include "study/prediction/recording.hpp"

namespace regista::study {

inline constexpr std::size_t horizon_count = std::tuple_size_v<decltype(config::PredictorStudy::Questions::horizons)>;

// m; 0 where there were no answers
struct Errors {
  double median = 0.0, ninetieth = 0.0;
};

// Of truths against the ellipses of the predicted detection: covariance of the track plus that of the camera.
struct Consistency {
  double within_50 = 0.0, within_90 = 0.0, within_95 = 0.0;  // share of truths inside
  // Normalised estimation error squared (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and
  // Navigation", 2001, section 5.4): mean 2 and median 1.39 where the covariance is consistent.
  double nees_mean = 0.0, nees_median = 0.0;
};

struct AtHorizon {
  double horizon = 0.0;     // s
  std::size_t truths = 0;   // starts that have a truth so far ahead
  std::size_t answers = 0;  // of these, those for which the predictor had a track
  Errors predictor, hold, constant, decayed;
  ErrorRatios to_decayed;  // of the answers; blocks of 10 s of play
  Consistency consistency;
  // Of the ball: answers for which nobody touched it from the last sighting to the truth (touches.hpp), and the share
  // of these truths inside the 95 % ellipses.
  std::size_t untouched = 0;
  double untouched_within_95 = 0.0;
};

struct Evaluation {
  std::size_t detections = 0, observations = 0;  // of the recording; shown to the predictor
  std::size_t starts = 0;
  std::array<AtHorizon, horizon_count> horizons;
};

// Called after each stretch with those done and those there are; may throw to stop.
using EvaluationProgress = std::function<void(std::size_t done, std::size_t of)>;

// catalogue null: the baselines alone. Throws config::Error, plugin::Failure.
Evaluation evaluate(const config::PredictorStudy& study, const GameRecording& recording,
                    const plugin::Catalogue* catalogue, const EvaluationProgress& progress = {});

}  // namespace regista::study
