// SPDX-License-Identifier: MIT
// Lays one document over another: values of the upper document replace values of the lower one. `extends`, `--set
// path=value` and the `use:` of a context work in this way. load() reads a document with everything that it extends.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "config/node.hpp"

namespace regista::config {

// A value that is laid over a document at a path.
struct Override {
  std::string path;
  Node value;
  Location where;  // where the path is written

  Override(std::string path_, Node value_, Location where_)
      : path(std::move(path_)), value(std::move(value_)), where(std::move(where_)) {}
  // Reads "path=value", where the value is YAML. `where` becomes "--set path=value". Throws Error for another form.
  Override(const std::string& typed);
  Override(const char* typed) : Override(std::string(typed)) {}
};

using Overrides = std::vector<Override>;  // in the order in which they are laid over a document

Overrides typed_overrides(const std::vector<std::string>& texts);
std::string to_string(const Override& override);  // "path=value"

// Reads a document and lays the overrides over it. A document with the key `extends: FILE` is first laid over FILE,
// which may extend another file. A relative FILE begins at the folder of the document that names it. `file` and FILE
// may also be the name of a shipped document. Every value keeps its Location in its file or override.
Node load(const std::filesystem::path& file, const Overrides& overrides = {});

Node override_with(Node document, const Overrides& overrides);

// Lays `over` over `base`. Maps are merged key by key. Any other value replaces the value of `base`; null removes the
// value of `base`. If a map of `over` names another `plugin` than `base`, the keys `params` and `file` of `base` are
// removed, because they belong to the old plugin. If `over` has a map where `base` has a list with named elements, each
// value of this map is laid over the element with this name. Null removes the element. A new name adds an element. The
// key `before` or `after` names the neighbour of a new or moved element. Values keep their Locations. Throws Error at a
// null for a key that `base` lacks, and at a new element that names no existing neighbour.
Node merge(const Node& base, const Node& over);

// Lays `value` over the value of `document` at a dotted path. Null removes the old value. A path addresses elements of
// a list of maps by their `name`, and elements of any list by their index from 0. A path may end in new keys, which get
// the location `where`. Throws Error at `where` if the path leads through a scalar or to a missing element.
Node with(const Node& document, std::string_view path, const Node& value, const Location& where);

// Returns the value at a path in the syntax of with(); an absent node if the document has no value at this path.
Node value_at(const Node& document, std::string_view path);

}  // namespace regista::config
