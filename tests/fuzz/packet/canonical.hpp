// SPDX-License-Identifier: MIT
// What must hold of any bytes given to the packet codec: either they are refused, or they are the one encoding of what
// they say. Used by the unit tests and by the fuzzer.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "mind/world/packet.hpp"

namespace regista::mind {

enum class Verdict { refused, canonical, not_canonical, no_sense };

inline bool makes_sense(const Report& report, const PacketLimits& limits) {
  bool sense = report.sender >= 1 && report.sender <= limits.team_size && report.role >= -1 &&
               report.role < limits.role_count && report.opponent_count <= Report::most_opponents &&
               report.time_sent >= 0.0 && std::isfinite(report.pose.x + report.pose.y) && report.pose.heading > -pi &&
               report.pose.heading <= pi && report.position_deviation >= 0.0 && report.heading_deviation >= 0.0 &&
               report.context >= 0 && report.time_until_up >= 0.0;
  if (report.ball) sense = sense && report.ball->age >= 0.0 && report.ball->deviation >= 0.0;
  return sense;
}

inline Verdict examine(std::span<const std::uint8_t> bytes, const PacketLimits& limits) {
  std::vector<Segment> segments;
  const std::optional<Report> report = decode(bytes, limits, segments);
  if (!report) return segments.empty() ? Verdict::refused : Verdict::no_sense;
  if (!makes_sense(*report, limits)) return Verdict::no_sense;
  std::vector<std::uint8_t> again;
  encode(*report, again);
  for (const Segment& segment : segments) append_segment(segment, again);
  const bool same = again.size() == bytes.size() && std::equal(again.begin(), again.end(), bytes.begin());
  return same ? Verdict::canonical : Verdict::not_canonical;
}

}  // namespace regista::mind
