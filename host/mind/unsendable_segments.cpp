// SPDX-License-Identifier: MIT
#include "mind/unsendable_segments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "mind/mind.hpp"
#include "mind/world/mailbox.hpp"

namespace regista::mind {
namespace {

constexpr double seconds = 3.0;
constexpr std::uint64_t seed = 1;

// Robots stand in the own half, in a row, and see the ball on its mark.
Percepts percepts_of(int number, int decision, const TeamPlan& plan) {
  const config::Rules& rules = plan.rules();
  Percepts out;
  out.time = decision * plan.robot().decision_period;
  const double x = -0.25 * rules.field.length, apart = rules.field.width / (rules.team_size + 1);
  const Pose pose{x, number * apart - 0.5 * rules.field.width, 0.0};
  if (decision == 0) out.placed = PlacedPose{pose, 0.05, 0.05};
  out.balls.push_back({{-pose.x, -pose.y}, 0.05, 0.05});
  out.game.phase = Phase::playing;
  out.game.phase_time = out.time;
  out.game.half_time_left = rules.durations.half - out.time;
  out.game.match_time_left = rules.durations.halves * rules.durations.half - out.time;
  out.game.packets_left = rules.messages.budget;
  return out;
}

}  // namespace

std::vector<UnsendableSegment> unsendable_segments(const TeamPlan& plan, plugin::Noting noting) {
  const int team_size = plan.rules().team_size;
  std::vector<Mind> minds;
  for (int number = 1; number <= team_size; ++number)
    minds.emplace_back(plan, number, seed, noting, Telling{.segments = true});
  const std::vector<const Part*> parts = plan.parts();
  std::vector<std::uint64_t> longest(parts.size(), 0);
  std::vector<std::pair<int, std::vector<std::uint8_t>>> air, next;  // by sender
  const int decisions = static_cast<int>(seconds / plan.robot().decision_period);
  for (int decision = 0; decision < decisions; ++decision) {
    for (int number = 1; number <= team_size; ++number) {
      const Percepts percepts = percepts_of(number, decision, plan);
      std::vector<HeardPacket> heard;
      for (const auto& [sender, bytes] : air) {
        if (sender != number) heard.push_back({percepts.time, bytes});
      }
      Mind& mind = minds[static_cast<std::size_t>(number - 1)];
      Outcome outcome;
      mind.think(percepts, heard, outcome);
      if (outcome.send) next.emplace_back(number, std::move(outcome.packet));
      for (const SegmentEvent& event : mind.segments()) {
        if (event.kind != SegmentEvent::Kind::refused || event.why != SegmentEvent::Why::too_long) continue;
        const auto part = std::ranges::find(parts, &mind.part(event.place));
        if (part == parts.end()) continue;
        std::uint64_t& most = longest[static_cast<std::size_t>(part - parts.begin())];
        most = std::max(most, event.length);
      }
    }
    air = std::exchange(next, {});
  }
  std::vector<UnsendableSegment> out;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (longest[part] > 0) out.push_back({part, longest[part]});
  }
  return out;
}

std::vector<config::Warning> unsendable_segment_warnings(const TeamPlan& plan,
                                                         const std::vector<UnsendableSegment>& found) {
  const std::size_t room = Mailboxes(static_cast<std::size_t>(plan.rules().messages.size)).bytes_free();
  const std::size_t most = room > segment_heading ? room - segment_heading : 0;
  std::vector<config::Warning> out;
  for (const UnsendableSegment& each : found) {
    const Part& part = *plan.parts()[each.part];
    out.push_back({part.use.where,
                   fmt::format("{} offers segments of {} bytes, and a packet of these rules takes at most {}: its "
                               "teammates never hear them",
                               part.use.plugin, each.bytes, most)});
  }
  return out;
}

}  // namespace regista::mind
