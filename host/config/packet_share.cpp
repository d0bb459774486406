// SPDX-License-Identifier: MIT
#include "config/packet_share.hpp"

#include <algorithm>
#include <cmath>

namespace regista::config {
namespace {

double match_length(const Rules& rules) { return rules.durations.half * rules.durations.halves; }

}  // namespace

double packet_share(const Rules& rules, std::optional<double> seconds) {
  if (rules.messages.short_games == ShortGames::whole || !seconds) return 1.0;
  return std::min(1.0, *seconds / match_length(rules));
}

int packets(const Messages& messages) {
  if (messages.share == 1.0) return messages.budget;
  constexpr double rounding = 1e-9;
  return static_cast<int>(std::floor(messages.budget * messages.share + rounding));
}

double packet_time_left(const Rules& rules, double match_time_left) {
  if (rules.messages.share == 1.0) return match_time_left;
  return std::max(0.0, match_time_left - (1.0 - rules.messages.share) * match_length(rules));
}

double packet_line(const Rules& rules, double match_time_left) {
  const double match = match_length(rules);
  if (rules.messages.share == 1.0) return rules.messages.budget * match_time_left / match;
  return packets(rules.messages) * packet_time_left(rules, match_time_left) / (rules.messages.share * match);
}

}  // namespace regista::config
