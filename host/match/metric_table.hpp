// SPDX-License-Identifier: MIT
// The table of metrics has one row for each kind of number of a match. Result files, JSON, CSV, pages, the names in
// studies and the tables of docs/metrics.md are made from this table. A new number needs only a new row. The functions
// take the table as an argument, because a program may declare rows at run time.
#pragma once

#include <array>
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

// The match, side and member (a role, event or plugin metric of a team) whose number a row reads.
struct MetricSource {
  const Result& result;
  std::optional<double> packets_share{};  // packets: a short match's share of the budget; nothing: a whole match
  Side side = Side::home;                 // used by rows of a team, role, event or plugin number
  std::size_t member = 0;                 // index of the role, event or plugin number; used by rows of these

  const TeamMetrics& team() const { return result.metrics.teams[index(side)]; }
  const RoleMetrics& role() const { return team().coordination.roles[member]; }
};

struct MetricRow {  // describes one number, or one number for each member of a team
  enum class Of {
    match,         // one number for the match
    team,          // one number for each side
    role,          // one number for each role of each side: "striker.overlap_seconds"
    event,         // one number for each side and reason to send packets: "packets_by_reason.whistle"
    plugin_total,  // one number for each plugin metric that is a sum: "plugin_totals.voronoi.crossings"
    plugin_value,  // one number for each plugin metric that is not a sum
  };
  // Whether a number grows with the length of play. Only a sum may be added up over matches or given per hour.
  enum class Total {
    sum,  // grows with the length of play: counts, durations
    mean  // independent of the length: shares, errors, rates
  };
  using Number = std::function<std::optional<double>(const MetricSource&)>;
  using List = std::function<std::vector<double>(const MetricSource&)>;  // a list of values; studies cannot name a list

  Of of = Of::team;
  std::string_view part{};  // the section of docs/metrics.md, one of metric_parts
  std::string name{};       // the name without side, role, event or plugin metric
  std::string unit{};       // "s", "share"; empty: no unit
  Total total = Total::mean;
  std::string title{};               // title on a page with results; empty: the row is on no page
  int digits = 2;                    // digits after the decimal point of a mean on the page
  std::string meaning{};             // the definition for docs/metrics.md, in Markdown
  std::variant<Number, List> get{};  // reads the number or list

  bool is_list() const { return std::holds_alternative<List>(get); }
  // Returns the path of the number of one role, event or plugin metric, such as "striker.overlap_seconds".
  std::string path(const std::string& member) const;
  // Returns the path with a placeholder for the member: "<role>.", "<event>" or "<plugin>.<metric>".
  std::string pattern() const;
};

// Sections of docs/metrics.md, in order.
inline constexpr std::array<std::string_view, 6> metric_parts{"match", "coordination", "packets",
                                                              "world", "soccer",       "plugins"};

const std::vector<MetricRow>& metric_table();  // The rows that every match has.

// By side: the names of the roles in the order of the team's table of roles.
using RoleNames = std::array<std::vector<std::string>, 2>;

struct MemberNames {
  std::vector<std::string> roles;                            // in the order of the table of roles
  std::vector<std::string> reasons = TeamMetrics().reasons;  // reasons to send packets
  std::vector<std::string> plugin_totals{}, plugin_values{};
};

// Returns the members of a team for which a row has numbers, such as all roles; {""} for a row without members.
std::vector<std::string> metric_members(const MetricRow& row, const MemberNames& team);

// Returns all numbers of a match. MetricName::place of a list's element is the position in the list, from 1.
MetricNumbers metric_numbers(std::span<const MetricRow> table, const MetricSource& source, const RoleNames& roles);

// Returns the row to which a path belongs; null for an unknown path. "striker.overlap_seconds",
// "roles.striker.overlap_seconds" and "overlap_seconds" belong to the same row.
const MetricRow* find_metric(std::span<const MetricRow> table, std::string_view path);

// Returns the paths by which a study may name the metrics of a team: those of no role, in the order of the table; role
// by role, the metrics of each role ("striker.overlap_seconds"); the sums over all roles ("overlap_seconds"). Lists
// have no path. team: its roles, reasons and plugin metrics.
std::vector<std::string> metric_paths(std::span<const MetricRow> table, const MemberNames& team);

double rounded_metric(double value);  // Returns the value rounded to six decimals.

}  // namespace regista::match
