// SPDX-License-Identifier: MIT
#include "config/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "config/document_files.hpp"
#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_chain = 16;

Node without(const Node& map, std::string_view key) {
  std::vector<Node::Entry> entries(map.entries().begin(), map.entries().end());
  std::erase_if(entries, [&](const Node::Entry& entry) { return entry.key == key; });
  return Node::map(std::move(entries), map.where());
}

// A chain of files in which each file extends the next file. Elements: the name as written, and the resolved path.
using Chain = std::vector<std::pair<std::string, fs::path>>;

Node load_over(const fs::path& file, const Location& asked_by, Chain& chain) {
  std::error_code failed;
  const fs::path identity = fs::weakly_canonical(file, failed);
  if (std::ranges::find(chain, identity, &Chain::value_type::second) != chain.end()) {
    std::string names;
    for (const auto& [name, of] : chain) names += name + " -> ";
    throw Error(asked_by, "extends itself: " + names + file.string());
  }
  if (chain.size() >= longest_chain)
    throw Error(asked_by, fmt::format("extends more than {} files", longest_chain - 1));
  Node document = parse(file, asked_by);
  const Node extends = document["extends"];
  if (!extends) return document;
  document = without(document, "extends");
  chain.emplace_back(file.string(), identity);
  return merge(load_over(named_file(extends, "extends"), extends.where(), chain), document);
}

using Entries = std::vector<Node::Entry>;

// Returns whether the sequence is a list of maps that all have names.
bool has_names(const Node& sequence) {
  const std::span<const Node> elements = sequence.elements();
  return !elements.empty() &&
         std::ranges::all_of(elements, [](const Node& each) { return each["name"].kind() == Node::Kind::scalar; });
}

std::vector<std::string> names_of(std::span<const Node> elements) {
  std::vector<std::string> names;
  for (const Node& each : elements) {
    if (const Node own = each["name"]) names.push_back(own.text());
  }
  return names;
}

// Returns the index of the element with this name; the number of elements if there is none.
std::size_t index_of(std::span<const Node> elements, std::string_view name) {
  const auto found = std::ranges::find_if(elements, [&](const Node& each) {
    const Node own = each["name"];
    return own && own.text() == name;
  });
  return static_cast<std::size_t>(found - elements.begin());
}

// Inserts `element` beside the list element NAME. `placed` has the key `before: NAME` or `after: NAME`.
void insert(std::vector<Node>& elements, const Node& placed, Node element) {
  const char* const key = placed["before"] ? "before" : "after";
  const Node beside = placed[key];
  if (beside.kind() != Node::Kind::scalar) {
    throw Error(beside.where(), fmt::format("{}: expected the name of an element, not {}", key, described(beside)));
  }
  const std::size_t index = index_of(elements, beside.text());
  if (index == elements.size()) {
    throw Error(beside.where(), texts::unknown("element", beside.text(), key, names_of(elements)));
  }
  elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(index + (placed["before"] ? 0 : 1)),
                  std::move(element));
}

Node with_name(const Node& element, const Node::Entry& entry) {
  Entries entries{{"name", entry.key_where, Node::scalar(entry.key, false, entry.key_where)}};
  entries.insert(entries.end(), element.entries().begin(), element.entries().end());
  return Node::map(std::move(entries), element.where());
}

// Lays one entry of a map over a list with named elements.
void merge_element(std::vector<Node>& elements, const Node::Entry& entry) {
  const std::size_t index = index_of(elements, entry.key);
  const bool there = index < elements.size();
  const auto at = elements.begin() + static_cast<std::ptrdiff_t>(index);
  if (entry.value.kind() == Node::Kind::null) {
    if (!there) {
      throw Error(entry.key_where,
                  "nothing to remove: " + texts::unknown("element", entry.key, "", names_of(elements)));
    }
    elements.erase(at);
    return;
  }
  if (entry.value.kind() != Node::Kind::map) {
    throw Error(entry.value.where(), fmt::format("{}: expected a map, not {}", entry.key, described(entry.value)));
  }
  if (const Node own = entry.value["name"]; own && own.text() != entry.key) {
    throw Error(own.where(), fmt::format("{} stands under another name, {}", texts::in_quotes(own.text()), entry.key));
  }
  const Node before = entry.value["before"], after = entry.value["after"];
  if (before && after) throw Error(after.where(), "before and after: one of them");
  const bool has_place = before || after;
  const Node over = without(without(entry.value, "before"), "after");
  if (!there && !has_place) {
    throw Error(entry.key_where, texts::unknown("element", entry.key, "", names_of(elements)) +
                                     "; a new one says where it goes, before: NAME or after: NAME");
  }
  if (!there) return insert(elements, entry.value, over["name"] ? over : with_name(over, entry));
  Node merged = merge(*at, over);
  if (!has_place) {
    *at = std::move(merged);
    return;
  }
  elements.erase(at);
  insert(elements, entry.value, std::move(merged));
}

// Returns the path up to the beginning of `rest`, for error messages.
std::string_view walked(std::string_view path, std::string_view rest) {
  std::string_view part = path.substr(0, path.size() - rest.size());
  if (part.ends_with('.')) part.remove_suffix(1);
  return part.empty() ? "the document" : part;
}

// Returns the first key of a path into a map. A key may contain dots (as in `use:`); the longest fitting key wins.
std::string_view first_key(const Node& map, std::string_view path) {
  std::string_view key = path.substr(0, path.find('.'));
  bool there = false;
  for (const Node::Entry& entry : map.entries()) {
    const bool fits = path == entry.key || (path.starts_with(entry.key) && path[entry.key.size()] == '.');
    if (fits && (!there || entry.key.size() > key.size())) {
      key = path.substr(0, entry.key.size());
      there = true;
    }
  }
  return key;
}

// Returns the index of the list element that a part of a path addresses: by its name, otherwise by its index. The index
// may be out of range. Returns nothing for a part that is neither a known name nor a number.
std::optional<std::size_t> element_meant(const Node& sequence, std::string_view name) {
  const std::size_t index = index_of(sequence.elements(), name);
  return index < sequence.elements().size() ? index : number_in<std::size_t>(name);
}

struct Overlay {
  std::string_view path;
  const Node& value;
  const Location& where;

  Node lay(const Node& node, std::string_view rest) const {
    if (node.kind() == Node::Kind::map) return lay_map(node, rest);
    if (node.kind() == Node::Kind::sequence) return lay_sequence(node, rest);
    throw Error(where, fmt::format("{} is {}, which has no parts", walked(path, rest), described(node)));
  }

  Node lay_map(const Node& map, std::string_view rest) const {
    const std::string_view key = first_key(map, rest);
    if (key.empty()) throw Error(where, fmt::format("{}: empty name in the path", texts::in_quotes(path)));
    const bool last = key.size() == rest.size();
    if (last) return merge(map, Node::map({{std::string(key), where, value}}, map.where()));
    const std::string_view below = rest.substr(key.size() + 1);
    Entries entries(map.entries().begin(), map.entries().end());
    const auto found = std::ranges::find(entries, key, &Node::Entry::key);
    const bool there = found != entries.end() && found->value.kind() != Node::Kind::null;
    Node laid = lay(there ? found->value : Node::map({}, where), below);
    if (found == entries.end()) {
      entries.push_back({std::string(key), where, std::move(laid)});
    } else {
      found->value = std::move(laid);
    }
    return Node::map(std::move(entries), map.where());
  }

  Node lay_sequence(const Node& sequence, std::string_view rest) const {
    const std::string_view name = rest.substr(0, rest.find('.'));
    std::vector<Node> elements(sequence.elements().begin(), sequence.elements().end());
    const std::size_t index = element(sequence, name, rest);
    if (name.size() < rest.size()) {
      elements[index] = lay(elements[index], rest.substr(name.size() + 1));
    } else if (value.kind() == Node::Kind::null) {
      elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(index));
    } else {
      elements[index] = merge(elements[index], value);
    }
    return Node::sequence(std::move(elements), sequence.where());
  }

  std::size_t element(const Node& sequence, std::string_view name, std::string_view rest) const {
    const std::span<const Node> elements = sequence.elements();
    const std::optional<std::size_t> meant = element_meant(sequence, name);
    if (meant && *meant < elements.size()) return *meant;
    if (meant) {
      throw Error(where,
                  fmt::format("{} has {} elements; there is no {}", walked(path, rest), elements.size(), *meant));
    }
    throw Error(where, texts::unknown("element", name, walked(path, rest), names_of(elements)));
  }
};

}  // namespace

Node load(const fs::path& file, const Overrides& overrides) {
  Chain chain;
  return override_with(load_over(own_or_shipped(file), {}, chain), overrides);
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

Node merge(const Node& base, const Node& over) {
  if (base.kind() == Node::Kind::sequence && over.kind() == Node::Kind::map && has_names(base)) {
    std::vector<Node> elements(base.elements().begin(), base.elements().end());
    for (const Node::Entry& entry : over.entries()) merge_element(elements, entry);
    return Node::sequence(std::move(elements), over.where());
  }
  if (base.kind() != Node::Kind::map || over.kind() != Node::Kind::map) return over;
  const Node before = base["plugin"], after = over["plugin"];
  const bool other_plugin = before && after && before.text() != after.text();
  Entries entries;
  std::map<std::string_view, std::size_t> places;  // key of base -> index in entries
  for (const Node::Entry& entry : base.entries()) {
    if (over[entry.key].kind() == Node::Kind::null) continue;
    if (other_plugin && (entry.key == "params" || entry.key == "file")) continue;
    places.emplace(entry.key, entries.size());
    entries.push_back(entry);
  }
  for (const Node::Entry& entry : over.entries()) {
    if (entry.value.kind() == Node::Kind::null) {
      if (base[entry.key]) continue;
      throw Error(entry.key_where,
                  "nothing to remove: " +
                      texts::unknown("key", entry.key, "", texts::names_of(base.entries(), &Node::Entry::key)));
    }
    const auto place = places.find(entry.key);
    if (place == places.end()) {
      entries.push_back(entry);
    } else {
      Node::Entry& below = entries[place->second];
      below = {entry.key, entry.key_where, merge(below.value, entry.value)};
    }
  }
  return Node::map(std::move(entries), over.where());
}

Node with(const Node& document, std::string_view path, const Node& value, const Location& where) {
  return Overlay{path, value, where}.lay(document, path);
}

Node value_at(const Node& document, std::string_view path) {
  if (path.empty()) return document;
  const bool map = document.kind() == Node::Kind::map;
  const std::string_view first = map ? first_key(document, path) : path.substr(0, path.find('.'));
  if (first.size() + 1 == path.size()) return {};  // the path ends in a dot
  const std::string_view rest = path.substr(std::min(path.size(), first.size() + 1));
  if (map) return value_at(document[first], rest);
  const std::optional<std::size_t> meant = element_meant(document, first);
  return meant && *meant < document.elements().size() ? value_at(document.elements()[*meant], rest) : Node();
}

}  // namespace regista::config
