// SPDX-License-Identifier: MIT
#include "study/packets_spent.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "match/side.hpp"

namespace regista::study {

std::string why_missing(std::string_view metric, bool short_games) {
  if (short_games || metric == packet_metrics[0]) return {};
  if (std::ranges::find(packet_metrics, metric) == packet_metrics.end()) return {};
  return fmt::format(
      "{}: whole matches have none; only games that a limit or an opening ends before their time have it", metric);
}

PacketMetrics packet_metrics_of(const match::MetricNumbers& metrics) {
  PacketMetrics out;
  for (std::size_t i = 0; i < packet_metrics.size(); ++i) {
    for (const match::Side side : match::both_sides) {
      out[i][match::index(side)] = metrics.of_side(side, packet_metrics[i]);
    }
  }
  return out;
}

std::optional<std::array<ShortGamePackets, 2>> short_game_packets(const match::MetricNumbers& metrics) {
  const auto [spent, share, over] = packet_metrics_of(metrics);
  std::array<ShortGamePackets, 2> out;
  for (const std::size_t side : {0u, 1u}) {
    if (!spent[side] || !share[side] || !over[side]) return std::nullopt;
    out[side] = {*spent[side], *share[side], *over[side]};
  }
  return out;
}

void PacketsSpent::add(const ShortGamePackets& game) {
  spent_.add(game.spent);
  share_.add(game.share);
  over_.add(game.over);
}

}  // namespace regista::study
