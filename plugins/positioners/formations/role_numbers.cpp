// SPDX-License-Identifier: MIT
#include "role_numbers.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace formations {
namespace {

constexpr std::array<int, 11> by_importance{1, 11, 2, 3, 6, 7, 8, 9, 10, 4, 5};

std::vector<int> in_order(std::span<const Role> roles, std::size_t positions, std::size_t team_size) {
  const std::string has = "formation: has " + std::to_string(positions) + " positions, but ";
  if (team_size > positions) {
    throw std::invalid_argument(has + "the team has " + std::to_string(team_size) +
                                " robots; name in `roles` which role takes which position");
  }
  std::vector<int> out;
  for (const Role& role : roles) {
    if (static_cast<std::size_t>(role.priority) >= positions) {
      throw std::invalid_argument(has + "there is none for the role \"" + role.name + "\", number " +
                                  std::to_string(role.priority + 1) + " of the list \"" + role.list +
                                  "\"; name in `roles` which role takes which position");
    }
    const auto place = static_cast<std::size_t>(role.priority);
    out.push_back(positions == by_importance.size() ? by_importance[place] - 1 : role.priority);
  }
  return out;
}

}  // namespace

std::vector<int> role_numbers(std::string_view text, std::span<const Role> roles, std::size_t positions,
                              std::size_t team_size) {
  const std::vector<RoleEntry> entries = role_entries(text, roles, "roles");
  if (entries.empty()) return in_order(roles, positions, team_size);
  std::vector<int> out(roles.size(), no_position);
  for (const RoleEntry& entry : entries) {
    std::array<double, 1> number;
    read_numbers(entry.value, number, entry.where);
    if (!(number[0] >= 1.0 && number[0] <= static_cast<double>(positions)) || number[0] != std::floor(number[0])) {
      throw std::invalid_argument(entry.where + ": no position " + std::string(entry.value.substr(0, 40)) +
                                  "; the formation has 1 to " + std::to_string(positions));
    }
    out[entry.row] = static_cast<int>(number[0]) - 1;
  }
  return out;
}

}  // namespace formations
