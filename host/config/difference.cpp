// SPDX-License-Identifier: MIT
#include "config/difference.hpp"

#include <algorithm>

#include "config/read.hpp"

namespace regista::config {
namespace {

// Converts a list of maps with different names into a map from these names to the maps. Returns another node unchanged.
Node by_names(const Node& node) {
  if (node.kind() != Node::Kind::sequence || node.elements().empty()) return node;
  std::vector<Node::Entry> entries;
  for (const Node& each : node.elements()) {
    const Node name = each["name"];
    const auto same_key = [&](const Node::Entry& other) { return other.key == name.text(); };
    if (!name || std::ranges::any_of(entries, same_key)) return node;
    entries.push_back({name.text(), each.where(), each});
  }
  return Node::map(std::move(entries), node.where());
}

void compare(const std::string& path, const Node& left, const Node& right, std::vector<Difference>& out) {
  const Node first = by_names(left), second = by_names(right);
  if (first.kind() == Node::Kind::map && second.kind() == Node::Kind::map) {
    for (const Node::Entry& each : first.entries()) compare(inside(path, each.key), each.value, second[each.key], out);
    for (const Node::Entry& each : second.entries()) {
      if (!first[each.key]) compare(inside(path, each.key), {}, each.value, out);
    }
  } else if (!same(left, right)) {
    out.push_back({path, left ? flow(left) : "", right ? flow(right) : ""});
  }
}

}  // namespace

std::vector<Difference> differences(const Node& first, const Node& second) {
  std::vector<Difference> out;
  compare("", first, second, out);
  return out;
}

}  // namespace regista::config
