// SPDX-License-Identifier: MIT
// A match as its robots saw it, for people who look at decisions: a file of JSON lines, written while the match is
// played. Every line has `kind` and `time` (s since the start of the match):
//   match     the first line: teams, seed
//   decision  of a robot, when context, kept tasks, assignment or own role changed or a packet was sent: what it
//             believed, what it chose, what it sent (a packet that was charged, not one that it may not or cannot
//             send). In the field frame of its own team.
//   segment   of bytes that a plugin offered for a packet: offered, refused, sent, dropped, heard by a teammate, or not
//             delivered, and why
//   event     of the referee
//   truth     once a second: all robots ([x, y, heading]), the ball, the score. In the field frame of the home team; a
//             half turn about the centre leads to that of the away team.
// Lengths in metres, rounded to the millimetre; utilities to six digits, null where a pair is forbidden.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "match/match.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"
#include "recording/segment_record.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {

// How every such file begins.
inline constexpr std::string_view decision_log_begin = R"({"kind":"match",)";

class DecisionLog {
 public:
  // Takes lines, each with its end. What it throws all functions throw.
  using Write = std::function<void(std::string_view line)>;
  // plans: by side; they outlive the log.
  DecisionLog(Write write, const std::array<const mind::TeamPlan*, 2>& plans, std::uint64_t seed);
  // To be called as match::play calls its observers.
  void decided(const mind::Mind& mind, const match::Decision& turn);
  void event(double time, const match::Event& event, const match::GameState& state);
  void stepped(const match::Snapshot& snapshot);

 private:
  void write_segments(const mind::Mind& mind, const match::Decision& turn);

  // What a line was last written for.
  struct Last {
    int context = -2, role = -2;
    std::vector<std::int32_t> kept, assignment;
  };

  std::array<const mind::TeamPlan*, 2> plans_;
  std::array<std::vector<Last>, 2> last_;  // by side and number
  std::array<std::vector<std::string>, 2> role_names_;
  std::uint64_t steps_ = 0;
  SentSegments sent_;
  texts::JsonText segment_;
  Write write_;
};

}  // namespace regista::recording
