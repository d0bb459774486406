// SPDX-License-Identifier: MIT
// The table of metrics: a row for each number of a match. Whoever stores, prints, explains or checks these numbers
// reads this table: the file of results, JSON, CSV, the page of a tournament, the names that studies may use, and the
// tables of docs/metrics.md. A number is added by adding its row. Every function that reads a table takes any, so that
// rows may also be declared while the program runs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "match/match.hpp"
#include "match/metric_numbers.hpp"
#include "match/side.hpp"

namespace regista::match {

// What numbers are taken from.
struct MetricSource {
  const Result& result;
  std::optional<double> packets_share{};  // see campaign/match_json.hpp
  Side side = Side::home;                 // of numbers of a team
  std::size_t member = 0;                 // of numbers by role, event or plugin: which one

  const TeamMetrics& team() const { return result.metrics.teams[index(side)]; }
  const RoleMetrics& role() const { return team().coordination.roles[member]; }
};

struct MetricRow {
  enum class Of {
    match,         // one number
    team,          // one of each side
    role,          // one of each role of each side: "striker.overlap_seconds"
    event,         // one of each cause of packets, of each side: "packets_by_reason.whistle"
    plugin_total,  // one of each number that its plugins sum up: "plugin_totals.voronoi.crossings"
    plugin_value,  // one of each other number of its plugins
  };
  // What a number says of the time it is taken over. Only sums can be added up, and told by the hour.
  enum class Total {
    sum,  // grows with it: how often, how long
    mean  // does not: shares, errors, rates
  };
  using Number = std::function<std::optional<double>(const MetricSource&)>;
  using List = std::function<std::vector<double>(const MetricSource&)>;  // no metric that a study can name

  Of of = Of::team;
  std::string_view part{};  // of docs/metrics.md: one of metric_parts
  std::string name{};       // without side, role or event
  std::string unit{};       // "s", "share"; empty: a plain number
  Total total = Total::mean;
  std::string title{};    // of its row on a page; empty: it has none
  int digits = 2;         // of a mean, after the point
  std::string meaning{};  // Markdown
  std::variant<Number, List> get{};

  bool is_list() const { return std::holds_alternative<List>(get); }
  // The path of one number: "striker.overlap_seconds", "packets_by_reason.whistle".
  std::string path(const std::string& member) const;
  // With "<role>." or "<event>" or "<plugin>.<metric>" where these stand.
  std::string pattern() const;
};

// In the order of the documentation.
inline constexpr std::array<std::string_view, 6> metric_parts{"match", "coordination", "packets",
                                                              "world", "soccer",       "plugins"};

// Those that every match has.
const std::vector<MetricRow>& metric_table();

// Names of roles, by side, in the order of the tables of roles.
using RoleNames = std::array<std::vector<std::string>, 2>;

// What a team has numbers of.
struct MemberNames {
  std::vector<std::string> roles;                            // in the order of its table
  std::vector<std::string> reasons = TeamMetrics().reasons;  // what its packets are sent for
  std::vector<std::string> plugin_totals{}, plugin_values{};
};

// What a row has a number of on the side of such a team: of each role, each event, ..., or of "" alone.
std::vector<std::string> metric_members(const MetricRow& row, const MemberNames& team);

// All numbers of a match. Those of lists have a place in their list, from 1.
MetricNumbers metric_numbers(std::span<const MetricRow> table, const MetricSource& source, const RoleNames& roles);

// The row that numbers under this path come from: "striker.overlap_seconds" and "overlap_seconds" are of the same.
// Null for a path of no row. A path may begin with "roles.".
const MetricRow* find_metric(std::span<const MetricRow> table, std::string_view path);

// What a study may name of such a team: paths of a side in the order of the table, then sums over roles.
std::vector<std::string> metric_paths(std::span<const MetricRow> table, const MemberNames& team);

// To the sixth decimal: sums and shares have no more to say, and campaigns keep them for every match.
double rounded_metric(double value);

}  // namespace regista::match
