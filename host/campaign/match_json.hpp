// SPDX-License-Identifier: MIT
// A match that was played, as programs read it and as a row of results keeps it.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "match/match.hpp"
#include "match/metric_table.hpp"

namespace regista::campaign {

struct PlayedMatch {
  std::array<std::string, 2> teams;  // names, by side
  std::uint64_t seed = 1;
  std::string opening;  // name; empty: from kick-off
  match::RoleNames role_names;
  int budget = 0;  // packets of a team, without those for added time
  // Of that, what falls to the time that the match is planned for; nothing for one of the whole time.
  std::optional<double> packets_share;
  double wall_seconds = 0.0;
  match::Result result;
};

// Of a game of 30 s of a match of 1200 s with a budget of 1200 packets: 30. A short game has the budget of a whole
// match, and who spends it all in a few seconds looks better than it could be for long.
std::optional<double> packets_share_of(const match::Setup& setup);

match::MetricNumbers numbers_of(const PlayedMatch& match,
                                std::span<const match::MetricRow> table = match::metric_table());

// What the match was, and all its numbers.
nlohmann::ordered_json summary_json(const PlayedMatch& match,
                                    std::span<const match::MetricRow> table = match::metric_table());

}  // namespace regista::campaign
