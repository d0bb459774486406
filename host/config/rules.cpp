// SPDX-License-Identifier: MIT
#include "config/rules.hpp"

#include <algorithm>
#include <cmath>

namespace regista::config {
namespace {

double standing_time(const Durations& durations) { return durations.ready + durations.set; }

// Returns the sending time within the first `seconds` of simulated time, s.
double sending_within(const Durations& durations, double seconds, bool begins_in_play) {
  double sending = 0.0;
  for (int half = 1; half <= durations.halves; ++half) {
    const bool in_play = half == 1 && begins_in_play;
    if (!in_play) seconds -= Durations::initial;
    const double lasts = durations.half + (in_play ? 0.0 : standing_time(durations));
    sending += std::clamp(seconds, 0.0, lasts);
    seconds -= lasts;
  }
  return sending;
}

}  // namespace

double packet_share(const Rules& rules, std::optional<double> seconds) {
  if (rules.messages.short_games == ShortGames::whole || !seconds) return 1.0;
  return std::min(1.0, *seconds / (rules.durations.half * rules.durations.halves));
}

void fit_packets(Rules& rules, std::optional<double> seconds, bool begins_in_play) {
  Messages& messages = rules.messages;
  messages.share = packet_share(rules, seconds);
  messages.earlier = begins_in_play ? standing_time(rules.durations) : 0.0;
  messages.later = 0.0;
  if (messages.short_games == ShortGames::whole || !seconds) return;
  messages.later = std::max(0.0, sending_time(rules.durations) - messages.earlier -
                                     sending_within(rules.durations, *seconds, begins_in_play));
}

int packets(const Messages& messages) {
  if (messages.share == 1.0) return messages.budget;
  constexpr double rounding = 1e-9;
  return static_cast<int>(std::floor(messages.budget * messages.share + rounding));
}

double sending_time(const Durations& durations) {
  return durations.halves * (durations.half + standing_time(durations));
}

double packet_time_left(const Rules& rules, double sending_time_left) {
  return std::max(0.0, sending_time_left - rules.messages.later);
}

double packet_line(const Rules& rules, double sending_time_left) {
  const double all = sending_time(rules.durations) - rules.messages.earlier - rules.messages.later;
  return all > 0.0 ? packets(rules.messages) * packet_time_left(rules, sending_time_left) / all : 0.0;
}

}  // namespace regista::config
