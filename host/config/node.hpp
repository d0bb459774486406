// SPDX-License-Identifier: MIT
// A YAML document as a tree that remembers where every value stood, so that whoever finds something wrong with it can
// say where. Immutable and cheap to copy; what it hands out by reference lives as long as any copy of the node or of
// one above it. The only users of yaml-cpp are the .cpp files of this room.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regista::config {

// A place in a file; line and column (in bytes) count from 1. Line 0: the file as a whole, or a value of the command
// line, whose file reads "--set path=value".
struct Location {
  std::string file;
  int line = 0, column = 0;
  // Of a value that a study lays over another document, as the command line does: relative names in it begin at the
  // current folder.
  bool laid = false;
  bool is_laid() const { return laid || line == 0; }
  friend bool operator==(const Location&, const Location&) = default;
};

// "file:line:column", or "file" where line is 0
std::string to_string(const Location&);

// A user error in a configuration; what() is one line "file:line:column: message", whatever control characters the
// name of the file or the message contain.
class Error : public std::runtime_error {
 public:
  Error(Location where, const std::string& message);
  const Location& where() const { return where_; }
  std::string message() const { return what() + before_message_; }  // what() without the place

 private:
  Location where_;
  std::size_t before_message_;
};

class Node {
 public:
  enum class Kind { absent, null, scalar, sequence, map };
  struct Entry;

  Node() = default;  // absent
  // A value without a place, or with one. The keys of a map are unique (the parser refuses others).
  static Node scalar(std::string text, bool quoted, Location where);
  static Node sequence(std::vector<Node> elements, Location where);
  static Node map(std::vector<Entry> entries, Location where);
  static Node null(Location where);

  Kind kind() const;
  explicit operator bool() const { return kind() != Kind::absent; }
  const Location& where() const;
  const std::string& text() const;              // scalar; empty for every other kind
  bool quoted() const;                          // scalar written in quotes: always text
  std::span<const Node> elements() const;       // sequence; empty for every other kind
  std::span<const Entry> entries() const;       // map, in written order; empty for every other kind
  Node operator[](std::string_view key) const;  // absent when missing, and for every kind but a map

  // The same, to be laid over another document.
  Node laid() const;

  // Same structure and texts, wherever they stood and however they were quoted; the order of keys does not matter.
  friend bool same(const Node&, const Node&);

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

struct Node::Entry {
  std::string key;
  Location key_where;
  Node value;
};

}  // namespace regista::config
