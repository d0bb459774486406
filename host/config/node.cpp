// SPDX-License-Identifier: MIT
#include "config/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>

namespace regista::config {

struct Node::Data {
  Kind kind = Kind::null;
  Location where;
  std::string text = {};
  bool quoted = false;
  std::vector<Node> elements = {};
  std::vector<Entry> entries = {};
  // Indices of the map's entries, sorted by key, for fast search in a large map.
  std::vector<std::uint32_t> by_key = {};
};

Node::Node(Data data) : data_(std::make_shared<const Data>(std::move(data))) {}

Node Node::scalar(std::string text, bool quoted, Location where) {
  return Node({.kind = Kind::scalar, .where = std::move(where), .text = std::move(text), .quoted = quoted});
}

Node Node::sequence(std::vector<Node> elements, Location where) {
  return Node({.kind = Kind::sequence, .where = std::move(where), .elements = std::move(elements)});
}

Node Node::map(std::vector<Entry> entries, Location where) {
  Data data{.kind = Kind::map, .where = std::move(where), .entries = std::move(entries)};
  const auto key = [&](std::uint32_t i) -> const std::string& { return data.entries[i].key; };
  data.by_key.resize(data.entries.size());
  std::iota(data.by_key.begin(), data.by_key.end(), 0u);
  std::ranges::sort(data.by_key, {}, key);
  assert(std::ranges::adjacent_find(data.by_key, {}, key) == data.by_key.end());
  return Node(std::move(data));
}

Node Node::null(Location where) { return Node({.where = std::move(where)}); }

Node::Kind Node::kind() const { return data_ ? data_->kind : Kind::absent; }

const Location& Node::where() const {
  static const Location nowhere;
  return data_ ? data_->where : nowhere;
}

const std::string& Node::text() const {
  static const std::string none;
  return data_ ? data_->text : none;
}

bool Node::quoted() const { return data_ && data_->quoted; }

std::span<const Node> Node::elements() const { return data_ ? std::span(data_->elements) : std::span<const Node>{}; }

std::span<const Node::Entry> Node::entries() const {
  return data_ ? std::span(data_->entries) : std::span<const Entry>{};
}

Node Node::operator[](std::string_view key) const {
  if (kind() != Kind::map) return {};
  const std::vector<Entry>& all = data_->entries;
  const auto found =
      std::ranges::lower_bound(data_->by_key, key, {}, [&](std::uint32_t i) -> std::string_view { return all[i].key; });
  return found == data_->by_key.end() || all[*found].key != key ? Node() : all[*found].value;
}

Node Node::laid() const {
  if (!data_) return {};
  Data data = *data_;
  data.where.laid = true;
  for (Node& each : data.elements) each = each.laid();
  for (Entry& each : data.entries) {
    each.key_where.laid = true;
    each.value = each.value.laid();
  }
  return Node(std::move(data));
}

bool same(const Node& a, const Node& b) {
  if (a.data_ == b.data_) return true;
  if (a.kind() != b.kind() || a.text() != b.text() || a.entries().size() != b.entries().size()) return false;
  return std::ranges::equal(a.elements(), b.elements(), same) &&
         std::ranges::all_of(a.entries(), [&](const Node::Entry& entry) {
           const Node other = b[entry.key];
           return other && same(entry.value, other);
         });
}

static bool plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         c == '+' || c == '-';
}

std::string flow_text(std::string_view text, bool quoted) {
  const bool readable = !text.empty() && std::all_of(text.begin(), text.end(), plain);
  const bool marker = text.starts_with("-") && (text.size() == 1 || text == "---");
  const bool null = text == "null" || text == "Null" || text == "NULL" || text == "...";
  if (!quoted && readable && !marker && !null) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string flow(const Node& node) {
  std::string out;
  switch (node.kind()) {
    case Node::Kind::scalar:
      return flow_text(node.text(), node.quoted());
    case Node::Kind::sequence:
      for (const Node& element : node.elements()) out += (out.empty() ? "" : ", ") + flow(element);
      return '[' + out + ']';
    case Node::Kind::map:
      for (const Node::Entry& entry : node.entries()) {
        out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", flow_text(entry.key, false), flow(entry.value));
      }
      return '{' + out + '}';
    default:
      return "~";
  }
}

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
