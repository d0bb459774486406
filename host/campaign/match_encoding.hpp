// SPDX-License-Identifier: MIT
// Writes a played match and its metrics as JSON for programs. Packs the metrics into few bytes for a file of results.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/match.hpp"
#include "match/metric_numbers.hpp"
#include "match/metric_table.hpp"

namespace regista::campaign {

// --- Numbers as JSON: {"playing_seconds": 612.4, "packets": [90, 87], "territory": [{"ball_x_metres": 0.3},
// {"ball_x_metres": -0.3}], "roles": [{"striker": {"switches": 4}}, {"striker": {"switches": 6}}]}. A number of the
// whole match is written alone. Numbers of the teams are written in an array: home, away. null: no such number.

void add_metrics(nlohmann::ordered_json& object, const match::MetricNumbers& numbers);

// Both functions throw std::invalid_argument for JSON of another form.
match::MetricNumbers metrics_from_json(const nlohmann::ordered_json& object);
match::MetricNumbers metrics_from_json(const std::string& text);

// --- Numbers in few bytes. docs/results.md describes the format byte by byte.
//
// - names: a JSON array of objects, {"side": "home", "role": "striker", "name": "switches", "place": 1}. A field that a
//   number lacks is left out. All matches with the same metrics share one text.
// - numbers: in the order of the names, one unsigned LEB128 code each. 0: no number. 1: the eight bytes of an IEEE 754
//   double follow, least significant first. n + 2: zigzag coding turns n into a whole number (0, 1, 2, 3 ... into 0,
//   -1, 1, -2 ...), which counts millionths. All codes together are one frame of Zstandard.

std::string names_text(const match::MetricNames& names);
// Throws std::invalid_argument for a text that names_text() did not write.
std::shared_ptr<const match::MetricNames> names_of(const std::string& text);

std::string number_bytes(std::span<const double> values);
// Throws std::invalid_argument unless number_bytes() has packed exactly `count` numbers.
std::vector<double> numbers_of(std::string_view bytes, std::size_t count);

// --- The match

struct PlayedMatch {
  std::array<std::string, 2> teams, titles;  // by side: names, and names for people
  std::uint64_t seed = 1;
  std::string opening;  // name; empty: from kick-off
  match::RoleNames role_names;
  int budget = 0;                       // packets of a team, without the packets for added time
  std::optional<double> packets_share;  // see packets_share_of()
  double wall_seconds = 0.0;
  match::Result result;
};

// Returns the share of a short match in the budget of a whole match, in packets: 30 for a game of 30 s by rules with
// 1200 s and 1200 packets. Empty for a whole match, and if the rules already reduce the budget of a short match.
// Without this share, a team that spends all packets in a few seconds looks better than it is.
std::optional<double> packets_share_of(const match::Setup& setup);

match::MetricNumbers numbers_of(const PlayedMatch& match,
                                std::span<const match::MetricRow> table = match::metric_table());

// Returns the teams, the seed, the result and all metrics of the match.
nlohmann::ordered_json summary_json(const PlayedMatch& match,
                                    std::span<const match::MetricRow> table = match::metric_table());

}  // namespace regista::campaign
