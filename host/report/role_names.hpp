// SPDX-License-Identifier: MIT
// Which roles, causes of packets, and numbers of plugins matches had: in the order of the first team, then what only
// others have.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "report/match_numbers.hpp"

namespace regista::report {

// What `part_of` leaves of the paths of so many teams, each once; it gives "" for a path that is none of these.
template <class PartOf>
std::vector<std::string> parts_of_paths(const MatchNumbers& numbers, std::size_t teams, PartOf part_of) {
  std::vector<std::string> out;
  for (std::size_t team = 0; team < teams; ++team) {
    for (const TeamNumber& each : numbers.of_team(team)) {
      const std::string part(part_of(std::string_view(each.path)));
      if (!part.empty() && std::ranges::find(out, part) == out.end()) out.push_back(part);
    }
  }
  return out;
}

inline bool is_of_plugin(std::string_view path) {
  return path.starts_with("plugin_totals.") || path.starts_with("plugin_values.");
}

inline std::vector<std::string> role_names(const MatchNumbers& numbers, std::size_t teams) {
  return parts_of_paths(numbers, teams, [](std::string_view path) {
    const std::string_view end = ".overlap_seconds";
    return path.ends_with(end) && !is_of_plugin(path) ? path.substr(0, path.size() - end.size()) : std::string_view();
  });
}

inline std::vector<std::string> packet_reasons(const MatchNumbers& numbers, std::size_t teams) {
  return parts_of_paths(numbers, teams, [](std::string_view path) {
    const std::string_view begin = packets_prefix;
    return path.starts_with(begin) ? path.substr(begin.size()) : std::string_view();
  });
}

// Whole paths.
inline std::vector<std::string> plugin_metrics(const MatchNumbers& numbers, std::size_t teams) {
  return parts_of_paths(numbers, teams,
                        [](std::string_view path) { return is_of_plugin(path) ? path : std::string_view(); });
}

// No packet of any of these teams was caused so.
inline bool sent_none(const MatchNumbers& numbers, std::size_t teams, const std::string& reason) {
  for (std::size_t team = 0; team < teams; ++team) {
    const statistics::Moments* const found = numbers.find(team, packets_prefix + reason);
    if (found != nullptr && found->mean() != 0.0) return false;
  }
  return true;
}

}  // namespace regista::report
