// SPDX-License-Identifier: MIT
#include "config/team_size.hpp"

#include <fmt/format.h>

#include "config/read.hpp"
#include "texts/message.hpp"

namespace regista::config {

void check(const Team& team, const Rules& rules, const Node& document, Mistakes& mistakes) {
  for (const RoleList& list : team.role_lists) {
    for (std::size_t i = 0; i < list.roles.size(); ++i) {
      const Role& role = list.roles[i];
      if (role.robot <= rules.team_size) continue;
      const std::string path = fmt::format("roles.{}.{}.robot", list.name, i);
      refuse(document, {path},
             fmt::format("{}: the role {} is for robot {}, a team has {} by the rules {}", path, role.name, role.robot,
                         texts::counted(static_cast<std::uint64_t>(rules.team_size), "robot", "robots"), rules.name),
             mistakes);
    }
  }
}

void check(const Team& team, const Rules& rules, const Node& document) {
  Mistakes first(Mistakes::After::stop);
  check(team, rules, document, first);
}

}  // namespace regista::config
