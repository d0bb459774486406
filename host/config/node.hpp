// SPDX-License-Identifier: MIT
// A YAML document as a tree of nodes, and functions that write it as YAML. Each node has its place in the file. Nodes
// are immutable and cheap to copy. A reference into a node is valid while a copy of it or of one around it exists.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/errors.hpp"

namespace regista::config {

class Node {
 public:
  enum class Kind { absent, null, scalar, sequence, map };
  struct Entry;

  Node() = default;  // an absent node
  // Each function makes a node; `where` is the node's place. Precondition of map(): no key occurs twice.
  static Node scalar(std::string text, bool quoted = false, Location where = {});
  static Node sequence(std::vector<Node> elements, Location where = {});
  static Node map(std::vector<Entry> entries, Location where = {});
  static Node null(Location where);

  Kind kind() const;
  explicit operator bool() const { return kind() != Kind::absent; }
  const Location& where() const;
  const std::string& text() const;              // text of a scalar; empty for other kinds
  bool quoted() const;                          // true for a scalar in quotes, which is always text
  std::span<const Node> elements() const;       // elements of a sequence; empty for other kinds
  std::span<const Entry> entries() const;       // entries of a map in written order; empty for other kinds
  Node operator[](std::string_view key) const;  // absent for a missing key or if this node is not a map

  // Returns a copy of this node and of all nodes inside, in which Location::laid is true.
  Node laid() const;

  // Returns whether two nodes have equal structures and texts. Ignores places, quotes and the order of keys.
  friend bool same(const Node&, const Node&);

 private:
  struct Data;
  explicit Node(Data data);
  std::shared_ptr<const Data> data_;
};

struct Node::Entry {
  std::string key;
  Location key_where;
  Node value;
};

template <class Things, class Write>
Node sequence_of(const Things& things, Write written) {
  std::vector<Node> elements;
  for (const auto& each : things) elements.push_back(written(each));
  return Node::sequence(std::move(elements));
}

// Writes a node as YAML in one line: `{roles: searching, sender.params.period: 4}`
std::string flow(const Node& node);

// Writes a scalar as YAML. Adds double quotes if `quoted`, or if YAML could read the plain text as another value.
std::string flow_text(std::string_view text, bool quoted);

// Writes a map as YAML for people: one line for each value, indented maps, and one line for each element of a list of
// maps. Reading this text gives the same tree. Precondition: the map is not empty.
std::string block(const Node& map, int indent = 0);

}  // namespace regista::config
