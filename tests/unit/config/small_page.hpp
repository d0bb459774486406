// SPDX-License-Identifier: MIT
// A page of a team that holds no more than it must, for tests of what is said of its roles.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "config/rules.hpp"

namespace regista::config {

// contexts: the elements of that list. roles: the lines of the list `usual`, which stands in line 7.
inline std::string small_page(const std::string& contexts, const std::string& roles) {
  return "team: t\n"
         "predictors: {self: {plugin: p}, ball: {plugin: p}, opponents: {plugin: p}, teammates: {plugin: p}}\n"
         "contexts: [" +
         contexts +
         "]\n"
         "assigner: {plugin: a}\n"
         "sender: {plugin: s}\n"
         "roles:\n"
         "  usual:\n" +
         roles;
}

// For these robots, in this order.
inline std::string roles_for(const std::vector<int>& robots) {
  std::string out;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    out += fmt::format("    - {{name: r{}, robot: {}, target: {{at: [0, {}]}}}}\n", i, robots[i], i);
  }
  return out;
}

inline Rules of_size(int size) {
  Rules rules;
  rules.team_size = size;
  return rules;
}

}  // namespace regista::config
