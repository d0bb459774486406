// SPDX-License-Identifier: MIT
#include "config/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>

#include "texts/message.hpp"

namespace regista::config {

std::string to_string(const Location& where) {
  if (where.line == 0) return where.file;
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

Error::Error(Location where, const std::string& message)
    : std::runtime_error(texts::one_line(to_string(where) + ": " + message)),
      where_(std::move(where)),
      before_message_(texts::one_line(to_string(where_) + ": ").size()) {}

struct Node::Data {
  Kind kind = Kind::null;
  Location where;
  std::string text;
  bool quoted = false;
  std::vector<Node> elements;
  std::vector<Entry> entries;
  std::vector<std::uint32_t> by_key;  // indices of entries, sorted by key: a large map costs no more than a small one
};

Node Node::scalar(std::string text, bool quoted, Location where) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::scalar;
  data->where = std::move(where);
  data->text = std::move(text);
  data->quoted = quoted;
  Node node;
  node.data_ = std::move(data);
  return node;
}

Node Node::sequence(std::vector<Node> elements, Location where) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::sequence;
  data->where = std::move(where);
  data->elements = std::move(elements);
  Node node;
  node.data_ = std::move(data);
  return node;
}

Node Node::map(std::vector<Entry> entries, Location where) {
  auto data = std::make_shared<Data>();
  data->kind = Kind::map;
  data->where = std::move(where);
  data->entries = std::move(entries);
  const std::vector<Entry>& all = data->entries;
  data->by_key.resize(all.size());
  std::iota(data->by_key.begin(), data->by_key.end(), 0u);
  std::sort(data->by_key.begin(), data->by_key.end(), [&](auto a, auto b) { return all[a].key < all[b].key; });
  assert(std::adjacent_find(data->by_key.begin(), data->by_key.end(),
                            [&](auto a, auto b) { return all[a].key == all[b].key; }) == data->by_key.end());
  Node node;
  node.data_ = std::move(data);
  return node;
}

Node Node::null(Location where) {
  auto data = std::make_shared<Data>();
  data->where = std::move(where);
  Node node;
  node.data_ = std::move(data);
  return node;
}

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
  const auto found = std::lower_bound(data_->by_key.begin(), data_->by_key.end(), key,
                                      [&](std::uint32_t i, std::string_view wanted) { return all[i].key < wanted; });
  if (found == data_->by_key.end() || all[*found].key != key) return {};
  return all[*found].value;
}

Node Node::laid() const {
  if (!data_) return {};
  auto data = std::make_shared<Data>(*data_);
  data->where.laid = true;
  for (Node& each : data->elements) each = each.laid();
  for (Entry& each : data->entries) {
    each.key_where.laid = true;
    each.value = each.value.laid();
  }
  Node node;
  node.data_ = std::move(data);
  return node;
}

bool same(const Node& a, const Node& b) {
  if (a.data_ == b.data_) return true;
  if (a.kind() != b.kind() || a.text() != b.text()) return false;
  if (a.elements().size() != b.elements().size() || a.entries().size() != b.entries().size()) return false;
  for (std::size_t i = 0; i < a.elements().size(); ++i) {
    if (!same(a.elements()[i], b.elements()[i])) return false;
  }
  for (const Node::Entry& entry : a.entries()) {
    const Node other = b[entry.key];
    if (!other || !same(entry.value, other)) return false;
  }
  return true;
}

}  // namespace regista::config
