// SPDX-License-Identifier: MIT
#include "config/block.hpp"

#include <algorithm>

#include "config/flow.hpp"

namespace regista::config {

std::string block(const Node& map, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  const auto is_map = [](const Node& node) { return node.kind() == Node::Kind::map && !node.entries().empty(); };
  std::string out;
  for (const Node::Entry& entry : map.entries()) {
    const Node& value = entry.value;
    out += margin + flow_text(entry.key, false) + ':';
    if (is_map(value)) {
      out += '\n' + block(value, indent + 2);
    } else if (!value.elements().empty() && std::ranges::all_of(value.elements(), is_map)) {
      out += '\n';
      for (const Node& element : value.elements()) out += margin + "  - " + flow(element) + '\n';
    } else {
      out += ' ' + flow(value) + '\n';
    }
  }
  return out;
}

}  // namespace regista::config
