// SPDX-License-Identifier: MIT
#include "config/overlay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "config/scalar.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

using Entries = std::vector<Node::Entry>;

Entries::iterator find(Entries& entries, std::string_view key) {
  return std::find_if(entries.begin(), entries.end(), [&](const Node::Entry& entry) { return entry.key == key; });
}

std::vector<std::string> keys_of(const Node& map) {
  std::vector<std::string> keys;
  for (const Node::Entry& entry : map.entries()) keys.push_back(entry.key);
  return keys;
}

// Whether `over` puts another plugin into the place of the one in `base`.
bool names_another_plugin(const Node& base, const Node& over) {
  const Node before = base["plugin"], after = over["plugin"];
  return before && after && before.text() != after.text();
}

// A list of maps, each with a name of its own.
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

std::size_t index_of(std::span<const Node> elements, std::string_view name) {
  const auto found = std::ranges::find_if(elements, [&](const Node& each) { return each["name"].text() == name; });
  return static_cast<std::size_t>(found - elements.begin());
}

// Where an element goes that says `before: NAME` or `after: NAME`.
struct Placed {
  Node element;  // without these keys
  Node before, after;
};

Placed placed(const Node& element) {
  Entries entries;
  Placed out;
  for (const Node::Entry& entry : element.entries()) {
    if (entry.key == "before") {
      out.before = entry.value;
    } else if (entry.key == "after") {
      out.after = entry.value;
    } else {
      entries.push_back(entry);
    }
  }
  if (out.before && out.after) throw Error(out.after.where(), "before and after: one of them");
  out.element = Node::map(std::move(entries), element.where());
  return out;
}

void insert(std::vector<Node>& elements, const Placed& placed, Node element) {
  const Node& beside = placed.before ? placed.before : placed.after;
  if (beside.kind() != Node::Kind::scalar) {
    throw Error(beside.where(), fmt::format("{}: expected the name of an element, not {}",
                                            placed.before ? "before" : "after", described(beside)));
  }
  const std::size_t index = index_of(elements, beside.text());
  if (index == elements.size()) {
    throw Error(beside.where(),
                texts::unknown("element", beside.text(), placed.before ? "before" : "after", names_of(elements)));
  }
  elements.insert(elements.begin() + static_cast<std::ptrdiff_t>(index + (placed.before ? 0 : 1)), std::move(element));
}

Node with_name(const Node& element, const Node::Entry& entry) {
  Entries entries{{"name", entry.key_where, Node::scalar(entry.key, false, entry.key_where)}};
  entries.insert(entries.end(), element.entries().begin(), element.entries().end());
  return Node::map(std::move(entries), element.where());
}

// One entry of a map that is laid over a list by name.
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
  const Placed over = placed(entry.value);
  const bool has_place = over.before || over.after;
  if (!there && !has_place) {
    throw Error(entry.key_where, texts::unknown("element", entry.key, "", names_of(elements)) +
                                     "; a new one says where it goes, before: NAME or after: NAME");
  }
  if (!there) {
    insert(elements, over, over.element["name"] ? over.element : with_name(over.element, entry));
    return;
  }
  Node merged = merge(*at, over.element);
  if (!has_place) {
    *at = std::move(merged);
    return;
  }
  elements.erase(at);
  insert(elements, over, std::move(merged));
}

Node merge_by_name(const Node& base, const Node& over) {
  std::vector<Node> elements(base.elements().begin(), base.elements().end());
  for (const Node::Entry& entry : over.entries()) merge_element(elements, entry);
  return Node::sequence(std::move(elements), over.where());
}

// The path as its error messages name it, up to where `rest` begins.
std::string_view walked(std::string_view path, std::string_view rest) {
  std::string_view part = path.substr(0, path.size() - rest.size());
  if (part.ends_with('.')) part.remove_suffix(1);
  return part.empty() ? "the document" : part;
}

// The first key of a path into a map. A key may itself contain dots (those of `use:` do): the longest that fits is
// meant.
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

// Which element of a list part of a path means: that of this name, else the one at this index, which need not exist.
// Nothing: neither a name of one nor a number.
std::optional<std::size_t> element_meant(const Node& sequence, std::string_view name) {
  const std::span<const Node> elements = sequence.elements();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Node own = elements[i]["name"];
    if (own && own.text() == name) return i;
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  const bool number = error == std::errc{} && end == name.data() + name.size();
  return number ? std::optional(index) : std::nullopt;
}

struct Overlay {
  std::string_view path;
  const Node& value;
  const Location& where;

  Node lay(const Node& node, std::string_view rest) const {
    switch (node.kind()) {
      case Node::Kind::map:
        return lay_map(node, rest);
      case Node::Kind::sequence:
        return lay_sequence(node, rest);
      default:
        throw Error(where, fmt::format("{} is {}, which has no parts", walked(path, rest), described(node)));
    }
  }

  Node lay_map(const Node& map, std::string_view rest) const {
    const std::string_view key = first_key(map, rest);
    if (key.empty()) throw Error(where, fmt::format("{}: empty name in the path", texts::in_quotes(path)));
    const bool last = key.size() == rest.size();
    if (last) return merge(map, Node::map({{std::string(key), where, value}}, map.where()));
    const std::string_view below = rest.substr(key.size() + 1);
    Entries entries(map.entries().begin(), map.entries().end());
    const auto found = find(entries, key);
    if (found == entries.end()) {
      entries.push_back({std::string(key), where, lay_map(Node::map({}, where), below)});
    } else if (found->value.kind() == Node::Kind::null) {
      found->value = lay_map(Node::map({}, where), below);
    } else {
      found->value = lay(found->value, below);
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

Node merge(const Node& base, const Node& over) {
  if (base.kind() == Node::Kind::sequence && over.kind() == Node::Kind::map && has_names(base))
    return merge_by_name(base, over);
  if (base.kind() != Node::Kind::map || over.kind() != Node::Kind::map) return over;
  const bool other_plugin = names_another_plugin(base, over);
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
      throw Error(entry.key_where, "nothing to remove: " + texts::unknown("key", entry.key, "", keys_of(base)));
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
  if (first.size() + 1 == path.size()) return {};  // ends in a dot
  const std::string_view rest = path.substr(std::min(path.size(), first.size() + 1));
  if (map) return value_at(document[first], rest);
  const std::optional<std::size_t> meant = element_meant(document, first);
  return meant && *meant < document.elements().size() ? value_at(document.elements()[*meant], rest) : Node();
}

}  // namespace regista::config
