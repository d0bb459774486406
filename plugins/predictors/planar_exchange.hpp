// SPDX-License-Identifier: MIT
// Between the host's measurements and tracks of what moves in the plane and the types of the filters. Glue of the
// predictors of the ball and of opponents.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <regista/predictor.hpp>

#include "planar_state.hpp"

namespace planar {

// What was seen in one image of one kind (REGISTA_MEASURED_...); more than there is room for are ignored.
// smallest_variance (m^2) is added to each.
class Image {
 public:
  std::span<const Sighting> read(const regista::Span<regista::Measurement>& measurements, std::int32_t kind,
                                 double smallest_variance) {
    std::size_t count = 0;
    for (const regista::Measurement& each : measurements) {
      if (each.kind != kind || count == seen_.size()) continue;
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

inline State state_of(const regista::Track& told) {
  const auto& c = told.covariance;
  State state;
  state.position << told.x, told.y;
  state.velocity << told.vx, told.vy;
  state.position_covariance << c[0], c[1], c[4], c[5];
  state.cross << c[2], c[3], c[6], c[7];
  state.velocity_covariance << c[10], c[11], c[14], c[15];
  return state;
}

inline void write_block(const Eigen::Matrix2d& block, double (&covariance)[16], int row, int column) {
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) covariance[4 * (row + i) + column + j] = block(i, j);
  }
}

inline void write_position(const State& state, regista::Track& track) {
  track.x = state.position.x();
  track.y = state.position.y();
  write_block(state.position_covariance, track.covariance, 0, 0);
}

inline void write_velocity(const State& state, regista::Track& track) {
  track.vx = state.velocity.x();
  track.vy = state.velocity.y();
  write_block(state.cross, track.covariance, 0, 2);
  write_block(state.cross.transpose(), track.covariance, 2, 0);
  write_block(state.velocity_covariance, track.covariance, 2, 2);
}

}  // namespace planar
