// SPDX-License-Identifier: MIT
// Places that do not depend on anything: "goalkeeper: -4.2 0, striker: 0.5 1", metres in the field frame. So B-Human
// and others play set plays and kick-offs: a table of where each role stands.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "role_list.hpp"

namespace formations {

struct Place {
  double x, y;  // m, field frame
};

// The rectangle |x| <= x, |y| <= y; m.
struct Ground {
  double x, y;
};

// The place of each row of the table of roles, where one is written. What `text` says goes before what `file` says.
// Throws std::invalid_argument: see role_list.hpp; or a place off the ground.
std::vector<std::optional<Place>> fixed_places(std::string_view file, std::string_view text,
                                               std::span<const Role> roles, const Ground& ground);

}  // namespace formations
