// SPDX-License-Identifier: MIT
// What one robot tells the others in one packet (the event e as it arrives), and its bytes. The core takes 24 bytes, a
// ball 11 more and each opponent 4, in fixed point, little endian, so that all robots read the same numbers; the rest
// of the packet carries segments of plugins (mailbox). decode() accepts any bytes and either yields a report that makes
// sense or nothing.
//
// core:     version:3 sender:5 | flags | time ms:24 | x y mm:16 | heading:16 | deviations | vx vy cm/s:8 | target mm:16
//           | role:8 | role since ds:16 (at most 109 min) | context:8 | time until up ds:8
// ball:     x y mm:16 | vx vy mm/s:16 | age cs:16 | deviation cm:8           (if flagged)
// opponent: x y cm:12 | deviation dm:4 | age s/2:4                            (0 to 5)
// segment:  place:8 | length:8 | bytes                                        (until the end)
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mind/geometry.hpp"

namespace regista::mind {

// Ball as its sender sees it; field frame.
struct ReportedBall {
  Vector2d position{0, 0}, velocity{0, 0};
  double deviation = 0.0;  // standard deviation of the position along either axis, m
  double age = 0.0;        // s since the sender itself saw it, when the packet left
};

struct ReportedOpponent {
  Vector2d position{0, 0};
  double deviation = 0.0, age = 0.0;
};

// The content of a packet's core; the sender's view at time_sent. Field frame of the team.
struct Report {
  static constexpr std::size_t most_opponents = 5;
  // Nothing is told that its sender has not seen for longer. s
  static constexpr double tells_ball_for = 10.0, tells_opponents_for = 4.0;

  int sender = 0;  // shirt number
  double time_sent = 0.0;
  Pose pose;
  double position_deviation = 0.0, heading_deviation = 0.0;
  Vector2d velocity{0, 0};  // m/s
  Vector2d target{0, 0};    // where it walks to
  bool fallen = false;
  double time_until_up = 0.0;
  bool playing = false;  // it knows that the ball is free (it heard the whistle, or was told)
  int role = -1;         // row of the table of roles, -1 = none
  double role_since = 0.0;
  int context = 0;
  std::optional<ReportedBall> ball;
  std::array<ReportedOpponent, most_opponents> opponents{};
  std::size_t opponent_count = 0;
};

// Bytes of a plugin for its counterpart in the same place of the teammates' minds.
struct Segment {
  int place = 0;  // 0..255
  std::span<const std::uint8_t> bytes;
};

inline constexpr std::size_t segment_heading = 2;  // bytes before a segment's own

// Limits that a packet is checked against.
struct PacketLimits {
  int team_size = 7;
  int role_count = 0;
  int context_count = 0;
  std::size_t size = 128;
};

// Appends nothing, replaces `out`. Values beyond what a field can hold are clipped to its nearest.
void encode(const Report&, std::vector<std::uint8_t>& out);
void append_segment(const Segment&, std::vector<std::uint8_t>& out);

// The report of bytes whose segments need not end where they do; nothing, if there is none that makes sense.
std::optional<Report> decode_core(std::span<const std::uint8_t> bytes, const PacketLimits&);

// The report, and its segments into `segments` (views into `bytes`); nothing, if the bytes are no packet of this team.
std::optional<Report> decode(std::span<const std::uint8_t> bytes, const PacketLimits&, std::vector<Segment>& segments);

}  // namespace regista::mind
