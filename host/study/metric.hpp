// SPDX-License-Identifier: MIT
// One number of a team out of the metrics of a match, by a path such as "striker.overlap_seconds", "packets" or
// "packets_by_reason.role_changed". What the metrics are is said where matches are reported; here they are JSON: an
// object whose members are arrays of two, one value for each side. Roles may leave "roles." out. A name that only roles
// have, such as "overlap_seconds", is the sum over all roles of the team.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace regista::study {

// A path of a role may be written with "roles." before it; it is one path all the same: this one, without.
std::string without_roles(const std::string& path);

// Nothing when the side has no such number. metrics: as a result has them. Throws std::invalid_argument when they are
// no JSON.
std::optional<double> metric(const std::string& metrics, int side, const std::string& path);

// All paths of a side, in the order in which they stand, the sums over roles last; also those that have no number in
// this match (null).
std::vector<std::string> metric_paths(const std::string& metrics, int side);

// The same without the sums.
std::vector<std::string> metric_names(const std::string& metrics, int side);

// All numbers of a side under the paths that name them in full.
struct NamedValue {
  std::string path;
  double value;
};
std::vector<NamedValue> metric_values(const std::string& metrics, int side);

// All that metric() knows of a side, read once.
std::vector<NamedValue> all_metric_values(const std::string& metrics, int side);

// A number of the whole match, such as "playing_seconds".
std::optional<double> match_number(const std::string& metrics, const std::string& name);

}  // namespace regista::study
