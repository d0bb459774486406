// SPDX-License-Identifier: MIT
// The evaluation of a predictor on a recording: its errors, the errors of baselines, and the quality of its covariance.
//
// Protocol: while the game runs, every n-th detection of an object is a start. The truth at a horizon of `h` seconds is
// the detection of that object nearest in time to start + h, within a tolerance. The predictor predicts the state at
// the time of this detection. Predictor and baselines are judged on the same starts: the starts with enough
// observations for the baselines' velocity. For the ball, the predictor's best hypothesis counts. For an anonymous
// robot, the track that is nearest to the robot at the start counts.
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "config/predictor_study.hpp"
#include "plugin/catalogue.hpp"
#include "study/prediction/game_recording.hpp"

namespace regista::study {

// --- A predictor must beat three baselines: "hold" predicts the last place; "constant" and "decayed" move the last
// place on with a constant or decaying velocity. This velocity is the slope of a line through the last observations.

// The velocity of a line of least squares through samples of one object, m/s. nullopt if there are fewer than `least`
// samples, or all have the same time.
std::optional<Eigen::Vector2d> fitted_velocity(std::span<const Sample> samples, int least);

// The displacement after `ahead` seconds, m. rolled(): the speed falls to 0 with a constant deceleration, m/s^2.
// slackened(): the velocity decays exponentially with a time constant, s.
Eigen::Vector2d rolled(const Eigen::Vector2d& velocity, double ahead, double deceleration);
Eigen::Vector2d slackened(const Eigen::Vector2d& velocity, double ahead, double time_constant);

// The displacement of the baseline "decayed": rolled() or slackened(), whichever the study selects.
Eigen::Vector2d decayed(const Eigen::Vector2d& velocity, double ahead,
                        const config::PredictorStudy::Baselines& baselines);

// For each sample of a ball, by time, whether no robot touched the ball there. Lines of least squares give the
// velocities in the `window` seconds before and after the sample. The ball is untouched if these velocities differ by
// less than 0.4 m/s, apart from a deceleration of at most 3.6 m/s^2 (a kicked ball that slides on carpet). The result
// is false if a window has fewer than three samples. Predictions of untouched balls are judged separately, because no
// filter predicts a kick.
std::vector<bool> untouched(std::span<const Sample> samples, double window);

// --- The ratio of a predictor's errors to a baseline's errors, and the uncertainty of this ratio.
//
// Errors of neighbouring starts are not independent, because they may share a kick. So the program draws whole blocks
// of play with replacement (block bootstrap: Kuensch, "The Jackknife and the Bootstrap for General Stationary
// Observations", Annals of Statistics 17, 1989). The interval contains the middle 95 % of the drawn ratios.

// The errors of the predictor and of a baseline for one truth, m.
struct PairedError {
  std::size_t block;  // number of the block of play, from 0
  double predictor, baseline;
};

// The predictor's quantile of errors divided by the baseline's, with a 95 % interval. Below 1, the predictor is better.
struct ErrorRatio {
  double value = 1.0, low = 1.0, high = 1.0;
};

struct ErrorRatios {
  ErrorRatio median, ninetieth;
};

// Equal arguments give equal intervals. Preconditions: one error or more; the baseline's quantiles are not 0.
ErrorRatios error_ratios(std::span<const PairedError> errors);

inline constexpr std::size_t horizon_count = std::tuple_size_v<decltype(config::PredictorStudy::Questions::horizons)>;

// Quantiles of the errors, m; 0 without answers.
struct Errors {
  double median = 0.0, ninetieth = 0.0;
};

// How often the truth lies inside the ellipses of the predicted detection. The covariance of this detection is the sum
// of the covariances of track and camera.
struct Consistency {
  double within_50 = 0.0, within_90 = 0.0, within_95 = 0.0;  // share of truths in the 50, 90, 95 % ellipse
  // Normalised estimation error squared (Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and
  // Navigation", 2001, section 5.4). A consistent covariance gives mean 2 and median 1.39.
  double nees_mean = 0.0, nees_median = 0.0;
};

struct AtHorizon {
  double horizon = 0.0;     // s
  std::size_t truths = 0;   // starts with a truth at this horizon
  std::size_t answers = 0;  // starts with a truth and a track of the predictor
  Errors predictor, hold, constant, decayed;
  ErrorRatios to_decayed;  // predictor's errors relative to `decayed`, for all answers; blocks of 10 s
  Consistency consistency;
  // untouched: number of answers for a ball that was untouched() from its last observation to the truth.
  // untouched_within_95: share of these truths inside the 95 % ellipse.
  std::size_t untouched = 0;
  double untouched_within_95 = 0.0;
};

struct Evaluation {
  std::size_t detections = 0, observations = 0;  // number in the recording; number that the predictor got
  std::size_t starts = 0;
  std::array<AtHorizon, horizon_count> horizons;
};

// done: number of stretches (parts of the recording without cuts) that were evaluated. of: number of all stretches. May
// throw to stop the evaluation.
using EvaluationProgress = std::function<void(std::size_t done, std::size_t of)>;

// catalogue: null evaluates only the baselines. Throws config::Error, plugin::Failure.
Evaluation evaluate(const config::PredictorStudy& study, const GameRecording& recording,
                    const plugin::Catalogue* catalogue, const EvaluationProgress& progress = {});

}  // namespace regista::study
