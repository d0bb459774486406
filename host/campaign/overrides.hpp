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
  explicit SortedOverrides(const std::vector<std::string>& all);

  // Those for one document ("home", "rules", "home_disturbance", ...), as it understands them.
  const config::Overrides& of(std::string_view document) const;

  // Calls read(overrides of the document). An error that stands at one of them names the path as it was typed.
  template <class Read>
  auto read(std::string_view document, Read read) const {
    try {
      return read(of(document));
    } catch (const config::Error& error) {
      throw as_typed(document, error);
    }
  }

 private:
  struct Document {
    std::string_view name;
    config::Overrides overrides, typed;  // with the same indices
  };
  const Document& find(std::string_view document) const;
  config::Error as_typed(std::string_view document, const config::Error& error) const;

  std::vector<Document> documents_;
};

}  // namespace regista::campaign
