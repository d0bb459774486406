// SPDX-License-Identifier: MIT
// What the team's page says of groups, list by list of its roles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace precedence {

struct RoleInGroup {
  std::string_view name, list;
  std::int32_t group;  // below 0: none
};

struct GroupsOfList {
  std::string_view list;
  std::vector<std::int32_t> groups;  // different ones; all roles without a group are one
  std::string without;               // "jolly, libero"; empty where no role has a group, too
};

inline std::vector<GroupsOfList> groups_of_lists(std::span<const RoleInGroup> roles) {
  std::vector<GroupsOfList> out;
  for (const RoleInGroup& role : roles) {
    auto of = std::ranges::find(out, role.list, &GroupsOfList::list);
    if (of == out.end()) of = out.insert(out.end(), GroupsOfList{role.list, {}, {}});
    const std::int32_t group = std::max(role.group, -1);
    if (std::ranges::find(of->groups, group) == of->groups.end()) of->groups.push_back(group);
    if (group < 0) of->without += (of->without.empty() ? "" : ", ") + std::string(role.name);
  }
  for (GroupsOfList& each : out) {
    if (each.groups.size() == 1) each.without.clear();
  }
  return out;
}

}  // namespace precedence
