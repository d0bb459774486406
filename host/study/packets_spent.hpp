// SPDX-License-Identifier: MIT
// Packets that a team spent in games that end before a match would. Unless the rules give such a game its share, it has
// the budget of a whole match, so that a team may look good by what it could not go on with: what it spent is reported
// beside the share of the budget that the length of the game has. Of whole matches there is nothing to report.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "match/metric_columns.hpp"
#include "match/packet_metrics.hpp"
#include "statistics/moments.hpp"

namespace regista::study {

// Why the matches of a study have no such metric, in words; empty where they have.
std::string why_missing(std::string_view metric, bool short_games);

// Of one team in one such game.
struct ShortGamePackets {
  double spent = 0.0, share = 0.0;
  double over = 0.0;  // the share; below 0 where less was spent
};

// Reads them of matches, one after the other.
class PacketsOfShortGames {
 public:
  PacketsOfShortGames();
  // By side; nothing for a match that has not all of these.
  std::optional<std::array<ShortGamePackets, 2>> of(const match::MetricNumbers& metrics);

 private:
  match::MetricColumns columns_;
};

// Of one team in many.
class PacketsSpent {
 public:
  void add(const ShortGamePackets& game);

  std::int64_t games() const { return spent_.count(); }
  double spent() const { return spent_.mean(); }  // per game
  double share() const { return share_.mean(); }  // of games of these lengths
  // By the sum of what single games say, so that no rounding of a mean makes somebody overspend.
  bool overspent() const { return over_.mean() > 0.0; }

 private:
  statistics::Moments spent_, share_, over_;
};

}  // namespace regista::study
