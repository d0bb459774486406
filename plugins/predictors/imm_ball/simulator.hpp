// SPDX-License-Identifier: MIT
// A ball for tests, integrated in steps of a millisecond and with none of the filter's formulas: it slides after a
// kick, rolls, stands, and may be pushed about.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace imm_ball {

struct Simulator {
  Eigen::Vector2d position = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
  double rolling_deceleration = 0.32, sliding_deceleration = 3.0;  // m/s^2
  double nudges = 0.0;                                             // m/s^0.5
  double pushes = 0.0;                                             // m/s^1.5, along the path
  double turns = 0.0;                                              // rad/s^0.5

  explicit Simulator(std::uint64_t seed) : random_(seed) {}

  bool chance(double probability) { return std::uniform_real_distribution<double>(0.0, 1.0)(random_) < probability; }
  // A velocity change of this deviation per axis, at an instant of the next `span` seconds.
  void kick_within(double span, double deviation) {
    kick_in_ = std::uniform_real_distribution<double>(0.0, span)(random_);
    kick_.x() = deviation * normal();
    kick_.y() = deviation * normal();
  }

  void advance(double dt) {
    const int steps = std::max(1, static_cast<int>(std::lround(dt / 0.001)));
    for (int i = 0; i < steps; ++i) step(dt / steps);
  }

  // Where a camera sees it that errs by `deviation` per axis, and by `timing` seconds.
  Eigen::Vector2d seen(double deviation, double timing) {
    const double late = timing * normal();
    const double x = deviation * normal();
    const double y = deviation * normal();
    return position + late * velocity + Eigen::Vector2d(x, y);
  }

 private:
  double normal() { return normal_(random_); }

  void step(double dt) {
    if (kick_in_ >= 0.0 && (kick_in_ -= dt) < 0.0) {
      velocity += kick_;
      rolls_below_ = 5.0 / 7.0 * velocity.norm();
    }
    const double speed = velocity.norm();
    if (nudges > 0.0) {
      position.x() += std::sqrt(dt) * nudges * normal();
      position.y() += std::sqrt(dt) * nudges * normal();
    }
    if (speed == 0.0) return;
    const double slower =
        (speed > rolls_below_ && rolls_below_ > 0.0 ? sliding_deceleration : rolling_deceleration) * dt;
    const double after = std::max(0.0, speed - slower + (pushes > 0.0 ? std::sqrt(dt) * pushes * normal() : 0.0));
    const double turn = turns > 0.0 ? std::sqrt(dt) * turns * normal() : 0.0;
    const double c = std::cos(turn), s = std::sin(turn);
    const Eigen::Vector2d heading = velocity / speed;
    position += 0.5 * (speed + after) * dt * heading;
    velocity = after * Eigen::Vector2d(c * heading.x() - s * heading.y(), s * heading.x() + c * heading.y());
    if (after <= rolls_below_) rolls_below_ = 0.0;
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double kick_in_ = -1.0;  // s, negative: no kick is due
  Eigen::Vector2d kick_ = Eigen::Vector2d::Zero();
  double rolls_below_ = 0.0;  // m/s: it slides while it is faster; 0: it rolls
};

}  // namespace imm_ball
