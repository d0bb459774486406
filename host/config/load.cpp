// SPDX-License-Identifier: MIT
#include "config/load.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/file.hpp"
#include "config/flow.hpp"
#include "config/overlay.hpp"
#include "config/parse.hpp"

namespace regista::config {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_chain = 16;

// One file of the chain that is being read.
struct Link {
  std::string name;  // as it was asked for
  fs::path identity;
};

std::string names(const std::vector<Link>& chain, const fs::path& last) {
  std::string text;
  for (const Link& link : chain) text += link.name + " -> ";
  return text + last.string();
}

Node without(const Node& map, std::string_view key) {
  std::vector<Node::Entry> entries(map.entries().begin(), map.entries().end());
  std::erase_if(entries, [&](const Node::Entry& entry) { return entry.key == key; });
  return Node::map(std::move(entries), map.where());
}

Node load_over(const fs::path& file, const Location& asked_by, std::vector<Link>& chain) {
  std::error_code failed;
  const fs::path identity = fs::weakly_canonical(file, failed);
  const bool cycle =
      std::any_of(chain.begin(), chain.end(), [&](const Link& link) { return link.identity == identity; });
  if (cycle) throw Error(asked_by, "extends itself: " + names(chain, file));
  if (chain.size() >= longest_chain)
    throw Error(asked_by, fmt::format("extends more than {} files", longest_chain - 1));
  Node document = parse(file, asked_by);
  const Node extends = document["extends"];
  if (!extends) return document;
  document = without(document, "extends");
  chain.push_back({file.string(), identity});
  return merge(load_over(named_file(extends, "extends"), extends.where(), chain), document);
}

}  // namespace

Node load(const fs::path& file, const Overrides& overrides) {
  std::vector<Link> chain;
  return override_with(load_over(file, {}, chain), overrides);
}

Override::Override(const std::string& typed) : where{"--set " + typed, 0, 0} {
  const std::size_t equals = typed.find('=');
  if (equals == std::string::npos || equals == 0) throw Error(where, "expected path=value");
  if (equals + 1 == typed.size()) throw Error(where, "expected a value; ~ takes an entry away, '' is an empty text");
  path = typed.substr(0, equals);
  value = parse_value(std::string_view(typed).substr(equals + 1), where);
}

Overrides typed_overrides(const std::vector<std::string>& texts) { return {texts.begin(), texts.end()}; }

std::string to_string(const Override& override) { return fmt::format("{}={}", override.path, flow(override.value)); }

Node override_with(Node document, const Overrides& overrides) {
  for (const Override& each : overrides) document = with(document, each.path, each.value, each.where);
  return document;
}

}  // namespace regista::config
