// SPDX-License-Identifier: MIT
// Where the rules of roles put them for a given ball, as a picture: what a team's page says, before anything is played.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "config/rules.hpp"
#include "config/team.hpp"

namespace regista::recording {

// How every such picture begins.
inline constexpr std::string_view roles_svg_begin = "<!-- regista config draw -->";

struct RolesToDraw {
  std::string team, of;                               // stand above the field; of: "the list playing"
  std::span<const config::Role* const> roles;         // a single one is drawn with what its rule is made of
  std::span<const std::array<double, 2>> balls = {};  // m; several are numbered; none: nobody knows the ball
};

// SVG 1.1 in UTF-8. The ball rests.
std::string roles_svg(const RolesToDraw& what, const config::FieldSize& field);

}  // namespace regista::recording
