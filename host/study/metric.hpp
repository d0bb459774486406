// SPDX-License-Identifier: MIT
// What a team did in a match, by the paths of match/metric_table.hpp: "striker.overlap_seconds", "packets" or
// "packets_by_reason.role_changed". A name that only roles have, such as "overlap_seconds", is the sum over all roles
// of the team.
#pragma once

#include <string>
#include <vector>

#include "match/metric_numbers.hpp"

namespace regista::study {

// All numbers of a side that this match has, under the paths that name them in full. side: 0 home, 1 away.
struct NamedValue {
  std::string path;
  double value;
};
std::vector<NamedValue> metric_values(const match::MetricNumbers& metrics, int side);

// The same of the match as a whole.
std::vector<NamedValue> metric_values_of_match(const match::MetricNumbers& metrics);

// Those of a side, and sums over roles.
std::vector<NamedValue> all_metric_values(const match::MetricNumbers& metrics, int side);

}  // namespace regista::study
