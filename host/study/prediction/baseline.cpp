// SPDX-License-Identifier: MIT
#include "study/prediction/baseline.hpp"

#include <algorithm>
#include <cmath>

namespace regista::study {

std::optional<Eigen::Vector2d> fitted_velocity(std::span<const Sample> samples, int least) {
  if (samples.size() < static_cast<std::size_t>(std::max(least, 2))) return std::nullopt;
  const double count = static_cast<double>(samples.size());
  const double origin = samples.back().time;  // times are small differences of large numbers
  double time = 0.0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  for (const Sample& each : samples) {
    time += (each.time - origin) / count;
    place += Eigen::Vector2d(each.x, each.y) / count;
  }
  double spread = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (const Sample& each : samples) {
    const double t = each.time - origin - time;
    spread += t * t;
    moment += t * (Eigen::Vector2d(each.x, each.y) - place);
  }
  if (spread <= 0.0) return std::nullopt;
  return moment / spread;
}

Eigen::Vector2d rolled(const Eigen::Vector2d& velocity, double ahead, double deceleration) {
  const double speed = std::sqrt(velocity.squaredNorm());
  if (speed <= 0.0) return Eigen::Vector2d::Zero();
  const double rolls = std::min(ahead, speed / deceleration);
  return velocity / speed * (speed * rolls - 0.5 * deceleration * rolls * rolls);
}

Eigen::Vector2d slackened(const Eigen::Vector2d& velocity, double ahead, double time_constant) {
  return velocity * (-time_constant * std::expm1(-ahead / time_constant));
}

Eigen::Vector2d decayed(const Eigen::Vector2d& velocity, double ahead,
                        const config::PredictorStudy::Baselines& baselines) {
  return baselines.deceleration ? rolled(velocity, ahead, *baselines.deceleration)
                                : slackened(velocity, ahead, *baselines.time_constant);
}

}  // namespace regista::study
