// SPDX-License-Identifier: MIT
// Report is the content of a packet from one robot to its teammates (the paper's received event e). encode() and
// decode() convert a Report to and from bytes. The core takes 24 bytes, the ball 11 and each opponent 4. Numbers are in
// fixed point, little endian, so that all robots read equal numbers. The rest of a packet is for segments of plugins
// (mailbox). The fields below are written as NAME UNIT:BITS; flags and deviations (cm; 0.01 rad) have one byte each.
//
// core:     version:3 sender:5 | flags | time ms:24 | x y mm:16 | heading:16 | deviations | vx vy cm/s:8 | target mm:16
//           | role:8 | role since ds:16 (at most 109 min) | context:8 | time until up ds:8
// ball:     x y mm:16 | vx vy mm/s:16 | age cs:16 | deviation cm:8           (if the flags contain flag_ball)
// opponent: x y cm:12 | deviation dm:4 | age s/2:4                            (0 to 5 times)
// segment:  place:8 | length:8 | bytes                                        (any number of times)
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mind/geometry.hpp"

namespace regista::mind {

struct ReportedBall {  // The ball as the sender believes it; field frame.
  Vector2d position{0, 0}, velocity{0, 0};
  double deviation = 0.0;  // standard deviation of the position along each axis, m
  double age = 0.0;        // s between the sender's last own sighting and the sending
};

struct ReportedOpponent {
  Vector2d position{0, 0};
  double deviation = 0.0, age = 0.0;  // m and s, as in ReportedBall
};

// What the sender knows at time_sent. Field frame of the team.
struct Report {
  static constexpr std::size_t most_opponents = 5;
  // A packet leaves out a ball or opponent that its sender has not seen for this time (s).
  static constexpr double tells_ball_for = 10.0, tells_opponents_for = 4.0;

  int sender = 0;          // shirt number
  double time_sent = 0.0;  // match time, s
  Pose pose;
  double position_deviation = 0.0, heading_deviation = 0.0;
  Vector2d velocity{0, 0};  // m/s
  Vector2d target{0, 0};    // point to which the sender walks
  bool fallen = false;
  double time_until_up = 0.0;  // s
  bool playing = false;        // the sender is in Playing, after a whistle or a message
  int role = -1;               // row of the table of roles; -1: no role
  double role_since = 0.0;     // match time at which the sender took the role, s
  int context = 0;             // index into Team::contexts
  std::optional<ReportedBall> ball;
  std::array<ReportedOpponent, most_opponents> opponents{};
  std::size_t opponent_count = 0;
};

// Bytes from a plugin instance to the instances in the same place of the teammates' minds.
struct Segment {
  int place = 0;  // place of the plugin instance (see mailboxes.hpp), 0..255
  std::span<const std::uint8_t> bytes;
};

inline constexpr std::size_t segment_heading = 2;  // bytes for place and length before a segment's own bytes

struct PacketLimits {
  int team_size = 7;
  int role_count = 0;
  int context_count = 0;
  std::size_t size = 128;  // most bytes of a packet
};

// encode() replaces `out` and clips values to the ranges of their fields. append_segment() appends to `out`.
void encode(const Report&, std::vector<std::uint8_t>& out);
void append_segment(const Segment&, std::vector<std::uint8_t>& out);

// Reads only the report; the packet may end within a segment. Returns nothing if the report is invalid.
std::optional<Report> decode_core(std::span<const std::uint8_t> bytes, const PacketLimits&);

// Reads the report and the segments (views into `bytes`). Returns nothing if `bytes` is not a packet of this team.
std::optional<Report> decode(std::span<const std::uint8_t> bytes, const PacketLimits&, std::vector<Segment>& segments);

// --- What happens to the segments of one robot's plugins. Mailboxes keeps a journal of it for recorders only.

// Counts for the metrics of a match. An accepted offer is later sent or dropped, or is still waiting.
struct SegmentCounts {
  std::int64_t offered = 0;  // accepted offers
  std::int64_t refused = 0;  // offers that the host refused
  std::int64_t sent = 0;     // segments that were sent in a packet
  std::int64_t dropped = 0;  // offers that expired, were replaced or were withdrawn
  std::int64_t heard = 0;    // segments of teammates that a plugin received
  std::int64_t bytes = 0;    // bytes of the sent segments, with headings

  void operator+=(const SegmentCounts& more) {
    offered += more.offered;
    refused += more.refused;
    sent += more.sent;
    dropped += more.dropped;
    heard += more.heard;
    bytes += more.bytes;
  }
};

struct SegmentEvent {
  enum class Kind { offered, refused, sent, dropped, heard, undelivered };
  enum class Why {
    none,  // offered, sent and heard segments have no reason
    // Why an offer was refused:
    senseless,         // urgency outside of [0, 1], unknown medium, or no bytes
    too_long,          // too long for any packet
    too_many_places,   // the instance's place is greater than 255
    too_many_pending,  // this instance already has 64 waiting offers
    // Why an offer was refused or dropped:
    expired,  // the match time has reached the offer's expiry
    // Why an offer was dropped:
    replaced,   // the plugin offered another segment in its place
    withdrawn,  // the plugin withdrew the offer
    // Why a teammate's segment was not delivered:
    unknown_place,  // this mind has no plugin in that place
    no_mailbox,     // the plugin in that place has no mailbox
    wrong_length    // the segment is longer than its packet
  };

  Kind kind = Kind::offered;
  Why why = Why::none;
  double time = 0.0;              // match time of the decision, s
  int place = -1;                 // place of the plugin instance (see mailboxes.hpp); -1: unknown (wrong length)
  const char* plugin = "";        // id of the plugin in this place; lives as long as the team's plan
  std::uint64_t handle = 0;       // handle of the offer; 0: a refused offer, or a teammate's segment
  std::uint64_t replaced_by = 0;  // handle of the new offer, if the offer was replaced

  // Only for offers, accepted or refused:
  double urgency = 0.0, expiry = 0.0;
  std::uint64_t length = 0;  // number of offered bytes
  std::string text;          // the plugin's description of the bytes; empty: no description
  // The bytes of an offer or of a teammate's segment. Empty for a refused offer of more than 255 bytes.
  std::vector<std::uint8_t> bytes;

  int at = 0;  // of a sent, heard or undelivered segment: index in its packet, from 0

  // Only for a teammate's segment:
  int sender = 0;  // shirt number
  double time_sent = 0.0, time_heard = 0.0;
};

inline const char* word(SegmentEvent::Kind kind) {
  constexpr std::array words{"offered", "refused", "sent", "dropped", "heard", "undelivered"};
  return words[static_cast<std::size_t>(kind)];
}

// Returns an empty text for Why::none.
inline const char* word(SegmentEvent::Why why) {
  constexpr std::array words{"",         "senseless", "too_long",      "too_many_places", "too_many_pending", "expired",
                             "replaced", "withdrawn", "unknown_place", "no_mailbox",      "wrong_length"};
  return words[static_cast<std::size_t>(why)];
}

}  // namespace regista::mind
