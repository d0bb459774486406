// SPDX-License-Identifier: MIT
#include "study/packets_spent.hpp"

#include "match/side.hpp"

namespace regista::study {

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
