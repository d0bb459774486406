// SPDX-License-Identifier: MIT
// Points of the field as a team page names them: an anchor ("ball", "own_left_post") or literal coordinates [x, y] in
// metres of the field frame (centre, x towards the opponent's goal, y left).
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

// A named point of the field, or a literal one.
enum class Anchor {
  ball,
  ball_rest,
  own_goal,
  opponent_goal,
  own_left_post,
  own_right_post,
  centre,
  own_penalty_mark,
  opponent_penalty_mark,
  point,
};

struct Place {
  Anchor anchor = Anchor::centre;
  std::array<double, 2> point{};  // when anchor is point
};

// The names of all anchors but `point`, in the order of the enumeration.
std::span<const std::string> anchor_names();

// `ball`, or [x, y]. Throws Error at the node, "what: reason".
Place to_place(const Node& node, std::string_view what);

// The other way round.
Node written(const Place& place);

inline constexpr double farthest_coordinate = 100.0;  // m, of a literal point

}  // namespace regista::config
