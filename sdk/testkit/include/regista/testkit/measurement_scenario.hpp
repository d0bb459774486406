// SPDX-License-Identifier: MIT
// A minute of what a predictor lives through at 10 Hz, by seeded chance: good measurements, none, two of one thing,
// false ones near and a kilometre away, packets old and new, long gaps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <regista/abi.h>

namespace regista::testkit {

struct Tick {
  double dt = 0.1;
  std::optional<regista_motion> motion;  // none: the model of a teammate
  bool corrects = false;
  std::vector<regista_measurement> measurements;  // if `corrects`
  regista_visible_area area{};
  std::optional<std::vector<regista_track>> absorbs;
  double packet_age = 0.0;
};

// `observer`: the own body's model, with odometry and measurements; else the model of a teammate, fed by packets.
std::vector<Tick> measurement_scenario(std::uint32_t subject, bool observer, std::uint64_t seed,
                                       std::size_t ticks = 600);

}  // namespace regista::testkit
