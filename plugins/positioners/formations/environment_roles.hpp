// SPDX-License-Identifier: MIT
// The table of roles, copied out of what the host gives once.
#pragma once

#include <vector>

#include <regista/frame.hpp>

#include "role_list.hpp"

namespace formations {

inline std::vector<Role> roles_of(const regista::Environment& environment) {
  std::vector<Role> out;
  for (const regista::Role& role : environment.roles()) out.push_back({role.name, role.list, role.priority});
  return out;
}

}  // namespace formations
