// SPDX-License-Identifier: MIT
#include "config/paths.hpp"

namespace regista::config {
namespace {

void collect(const Node& node, const std::string& path, std::vector<std::string>& out) {
  if (!path.empty()) out.push_back(path);
  const std::string before = path.empty() ? path : path + '.';
  for (const Node::Entry& entry : node.entries()) collect(entry.value, before + entry.key, out);
  for (const Node& element : node.elements()) {
    const Node name = element["name"];
    if (name.kind() == Node::Kind::scalar) collect(element, before + name.text(), out);
  }
}

}  // namespace

std::vector<std::string> paths_of(const Node& document) {
  std::vector<std::string> out;
  collect(document, "", out);
  return out;
}

}  // namespace regista::config
