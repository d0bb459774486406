// SPDX-License-Identifier: MIT
// Between the host's measurements and tracks of a ball and the types of the filters. Glue of the predictors of the
// ball.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include <regista/predictor.hpp>

#include "ball_sighting.hpp"
#include "ball_state.hpp"

namespace ball {

// The balls seen in one image; more than there is room for are ignored. smallest_variance (m^2) is added to each.
class Image {
 public:
  std::span<const Sighting> read(const regista::Span<regista::Measurement>& measurements, double smallest_variance) {
    std::size_t count = 0;
    for (const regista::Measurement& each : measurements) {
      if (each.kind != REGISTA_MEASURED_BALL || count == seen_.size()) continue;
      Sighting& sighting = seen_[count++];
      sighting.position << each.position[0], each.position[1];
      sighting.covariance << each.covariance[0], each.covariance[1], each.covariance[1], each.covariance[4];
      sighting.covariance.diagonal().array() += smallest_variance;
    }
    return {seen_.data(), count};
  }

 private:
  std::array<Sighting, 32> seen_{};
};

inline View view_of(const regista::VisibleArea& area) {
  const double right = area.heading - area.half_angle, left = area.heading + area.half_angle;
  return {{area.x, area.y},
          {std::cos(right), std::sin(right)},
          {std::cos(left), std::sin(left)},
          area.half_angle,
          area.range_ball};
}

inline State state_of(const regista::Track& told) {
  const auto& c = told.covariance;
  State ball;
  ball.position << told.x, told.y;
  ball.velocity << told.vx, told.vy;
  ball.position_covariance << c[0], c[1], c[4], c[5];
  ball.cross << c[2], c[3], c[6], c[7];
  ball.velocity_covariance << c[10], c[11], c[14], c[15];
  return ball;
}

inline void write_block(const Eigen::Matrix2d& block, double (&covariance)[16], int row, int column) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) covariance[4 * (row + i) + column + j] = block(i, j);
  }
}

inline void write_position(const State& ball, regista::Track& track) {
  track.x = ball.position.x();
  track.y = ball.position.y();
  write_block(ball.position_covariance, track.covariance, 0, 0);
}

inline void write_velocity(const State& ball, regista::Track& track) {
  track.vx = ball.velocity.x();
  track.vy = ball.velocity.y();
  write_block(ball.cross, track.covariance, 0, 2);
  write_block(ball.cross.transpose(), track.covariance, 2, 0);
  write_block(ball.velocity_covariance, track.covariance, 2, 2);
}

}  // namespace ball
