// SPDX-License-Identifier: MIT
// What a predictor must beat: the last place, and the last place moved on with the velocity of a line through the last
// observations, undiminished or decaying.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "config/predictor_study.hpp"
#include "study/prediction/recording.hpp"

namespace regista::study {

// The velocity of the line of least squares through samples of one object, m/s. None when fewer than `least` samples
// are given, or all at one time.
std::optional<Eigen::Vector2d> fitted_velocity(std::span<const Sample> samples, int least);

// How far something of this velocity comes in `ahead` seconds: undiminished; rolling with a constant deceleration until
// it stands; with a velocity that decays exponentially.
inline Eigen::Vector2d undiminished(const Eigen::Vector2d& velocity, double ahead) { return velocity * ahead; }
Eigen::Vector2d rolled(const Eigen::Vector2d& velocity, double ahead, double deceleration);
Eigen::Vector2d slackened(const Eigen::Vector2d& velocity, double ahead, double time_constant);

// rolled or slackened, as the study says.
Eigen::Vector2d decayed(const Eigen::Vector2d& velocity, double ahead,
                        const config::PredictorStudy::Baselines& baselines);

}  // namespace regista::study
