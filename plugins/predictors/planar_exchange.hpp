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
      sighting.covariance << each.covariance[0], each.covariance[1], each.covariance[1], each.covariance[2];
      sighting.covariance.diagonal().array() += smallest_variance;
    }
    return {seen_.data(), count};
  }

 private:
  std::array<Sighting, 32> seen_{};
};

inline State state_of(const regista::Track& told) {
  const auto& place = told.covariance;
  const auto& rest = told.motion;
  State state;
  state.position << told.x, told.y;
  state.velocity << told.vx, told.vy;
  state.position_covariance << place[0], place[1], place[1], place[2];
  state.cross << rest[0], rest[1], rest[2], rest[3];
  state.velocity_covariance << rest[4], rest[5], rest[5], rest[6];
  return state;
}

inline void write_position(const State& state, regista::Track& track) {
  track.x = state.position.x();
  track.y = state.position.y();
  const Eigen::Matrix2d& place = state.position_covariance;
  track.covariance[0] = place(0, 0);
  track.covariance[1] = place(0, 1);
  track.covariance[2] = place(1, 1);
}

inline void write_velocity_covariance(double xx, double xy, double yy, regista::Track& track) {
  track.motion[4] = xx;
  track.motion[5] = xy;
  track.motion[6] = yy;
}

inline void write_velocity(const State& state, regista::Track& track) {
  track.vx = state.velocity.x();
  track.vy = state.velocity.y();
  const Eigen::Matrix2d &cross = state.cross, &velocity = state.velocity_covariance;
  auto& rest = track.motion;
  rest[0] = cross(0, 0);
  rest[1] = cross(0, 1);
  rest[2] = cross(1, 0);
  rest[3] = cross(1, 1);
  write_velocity_covariance(velocity(0, 0), velocity(0, 1), velocity(1, 1), track);
}

}  // namespace planar
