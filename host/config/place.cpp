// SPDX-License-Identifier: MIT
#include "config/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/scalar.hpp"
#include "texts/message.hpp"

namespace regista::config {

std::span<const std::string> anchor_names() {
  static const std::array<std::string, static_cast<std::size_t>(Anchor::point)> names{
      "ball",           "ball_rest", "own_goal",         "opponent_goal",        "own_left_post",
      "own_right_post", "centre",    "own_penalty_mark", "opponent_penalty_mark"};
  return names;
}

Place to_place(const Node& node, std::string_view what) {
  if (node.kind() == Node::Kind::scalar) {
    const std::span<const std::string> names = anchor_names();
    const auto found = std::find(names.begin(), names.end(), node.text());
    if (found == names.end()) {
      throw Error(node.where(), fmt::format("{}: {}", what, texts::unknown("place", node.text(), "", names)));
    }
    return {static_cast<Anchor>(found - names.begin()), {}};
  }
  constexpr std::string_view wanted = "the name of a place or [x, y]";
  if (node.kind() != Node::Kind::sequence) refuse_kind(node, what, wanted);
  if (node.elements().size() != 2) {
    throw Error(node.where(), fmt::format("{}: {} elements; expected {}", what, node.elements().size(), wanted));
  }
  Place place{Anchor::point, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const Node& coordinate = node.elements()[i];
    place.point[i] = to_real(coordinate, fmt::format("{}.{}", what, i));
    if (std::abs(place.point[i]) > farthest_coordinate) {
      throw Error(coordinate.where(),
                  fmt::format("{}.{}: {} is outside {} to {} m", what, i, texts::in_quotes(coordinate.text()),
                              -farthest_coordinate, farthest_coordinate));
    }
  }
  return place;
}

Node written(const Place& place) {
  if (place.anchor != Anchor::point) {
    return Node::scalar(anchor_names()[static_cast<std::size_t>(place.anchor)], false, {});
  }
  return Node::sequence(
      {Node::scalar(real_text(place.point[0]), false, {}), Node::scalar(real_text(place.point[1]), false, {})}, {});
}

}  // namespace regista::config
