// SPDX-License-Identifier: MIT
// The values of `--set` for a command that reads several documents. The first part of a path says which one it is for:
// home, away, rules, robot, disturbance (of both), home_disturbance, away_disturbance or opening; a path without it
// goes to both teams.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/load.hpp"

namespace regista::campaign {

class SortedOverrides {
 public:
  explicit SortedOverrides(const config::Overrides& all);

  // Those for one document ("home", "rules", "home_disturbance", ...), as it understands them.
  const config::Overrides& of(std::string_view document) const;

 private:
  struct Document {
    std::string_view name;
    config::Overrides overrides;
  };
  std::vector<Document> documents_;
};

}  // namespace regista::campaign
