// SPDX-License-Identifier: MIT
#include "study/packets_spent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace regista::study {

std::string why_missing(std::string_view metric, bool short_games) {
  if (short_games || metric == match::packet_metrics[0]) return {};
  if (std::ranges::find(match::packet_metrics, metric) == match::packet_metrics.end()) return {};
  return fmt::format(
      "{}: whole matches have none; only games that a limit or an opening ends before their time have it", metric);
}

PacketsOfShortGames::PacketsOfShortGames() : columns_(match::packet_paths()) {}

std::optional<std::array<ShortGamePackets, 2>> PacketsOfShortGames::of(const match::MetricNumbers& metrics) {
  const std::span<const std::optional<double>> values = columns_.of(metrics);
  if (!std::ranges::all_of(values, &std::optional<double>::has_value)) return std::nullopt;
  std::array<ShortGamePackets, 2> out;
  for (const std::size_t side : {0u, 1u}) out[side] = {*values[side], *values[2 + side], *values[4 + side]};
  return out;
}

void PacketsSpent::add(const ShortGamePackets& game) {
  spent_.add(game.spent);
  share_.add(game.share);
  over_.add(game.over);
}

}  // namespace regista::study
