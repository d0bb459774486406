// SPDX-License-Identifier: MIT
#include "fixed_places.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace formations {
namespace {

void add(std::string_view text, std::string_view what, std::span<const Role> roles, const Ground& ground,
         std::vector<std::optional<Place>>& out) {
  for (const RoleEntry& entry : role_entries(text, roles, what)) {
    std::array<double, 2> xy;
    read_numbers(entry.value, xy, entry.where);
    if (std::abs(xy[0]) > ground.x || std::abs(xy[1]) > ground.y) {
      std::ostringstream message;
      message << entry.where << ": (" << xy[0] << ", " << xy[1] << ") is off the ground, |x| <= " << ground.x
              << ", |y| <= " << ground.y;
      throw std::invalid_argument(message.str());
    }
    out[entry.row] = Place{xy[0], xy[1]};
  }
}

}  // namespace

std::vector<std::optional<Place>> fixed_places(std::string_view file, std::string_view text,
                                               std::span<const Role> roles, const Ground& ground) {
  std::vector<std::optional<Place>> out(roles.size());
  add(file, "file", roles, ground, out);
  add(text, "places", roles, ground, out);
  return out;
}

}  // namespace formations
