// SPDX-License-Identifier: MIT
// YAML text -> Node tree. A strict subset of YAML 1.2: one document, a map at its top, keys of plain text and unique,
// no tags, no merge keys, aliases only while the whole stays small. Built on yaml-cpp's events, because its tree
// accepts duplicate keys and expands aliases without bound.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

inline constexpr std::size_t largest_file = std::size_t{1} << 20;  // bytes
inline constexpr std::size_t most_nodes = 50'000;                  // values in a document, aliases expanded
inline constexpr int deepest = 64;                                 // maps and lists inside each other, aliases expanded

// Reads a file. Throws Error at `asked_by` when it cannot be opened (the file itself where that is not given), and
// Error inside the file for everything that is wrong with it.
Node parse(const std::filesystem::path& file, const Location& asked_by = {});

// The same for a text in memory; `name` stands for the file in Locations.
Node parse_text(std::string_view text, const std::string& name);

// One value of any kind, as it stands on the command line after "path=". Every Location is `where`.
Node parse_value(std::string_view text, const Location& where);

}  // namespace regista::config
