// SPDX-License-Identifier: MIT
// The decision log of a match, for people who examine decisions: what the robots believed and chose. The file has JSON
// lines and is written during the match. Every line has `kind` and `time` (s since the start of the match):
//   match     the first line: teams and seed
//   decision  belief, choice and charged packet of a robot, in the field frame of its team; written when the robot sent
//             a packet or when its context, kept tasks, assignment or role changed
//   segment   what happened to bytes that a plugin offered for a packet, and why: offered, refused, sent, dropped,
//             heard by a teammate, or not delivered
//   event     an event of the referee
//   truth     once a second: all robots ([x, y, heading]), ball and score, in the field frame of the home team; half a
//             turn about the centre gives the frame of the away team
// Lengths are in metres, rounded to the millimetre. Utilities have six decimals; that of a forbidden pair is null.
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
#include "recording/plugin_records.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {

inline constexpr std::string_view decision_log_begin = R"({"kind":"match",)";

class DecisionLog {
 public:
  // Writes one line with its line end. If this function throws, all functions of DecisionLog throw the same exception.
  using Write = std::function<void(std::string_view line)>;
  // plans: the plans of both teams, by side; they must outlive the log.
  DecisionLog(Write write, const std::array<const mind::TeamPlan*, 2>& plans, std::uint64_t seed);
  // The caller must call these functions at the same moments as match::play calls its observers.
  void decided(const mind::Mind& mind, const match::Decision& turn);
  void event(double time, const match::Event& event, const match::GameState& state);
  void stepped(const match::Snapshot& snapshot);

 private:
  void write_segments(const mind::Mind& mind, const match::Decision& turn);

  std::array<const mind::TeamPlan*, 2> plans_;
  std::array<std::vector<LastDecision>, 2> last_;  // by side and number
  std::array<std::vector<std::string>, 2> role_names_;
  std::uint64_t steps_ = 0;
  SentSegments sent_;
  texts::JsonText segment_;
  Write write_;
};

}  // namespace regista::recording
