// SPDX-License-Identifier: MIT
// Parses YAML text into a tree of nodes. Accepts a strict subset of YAML 1.2: one document with a map at its top,
// unique keys of plain text, no tags, no merge keys, and aliases only while the expanded document stays within
// most_nodes and `deepest`. Uses the events of yaml-cpp, because the tree of yaml-cpp accepts duplicate keys and
// expands aliases without limit.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

inline constexpr std::size_t largest_file = std::size_t{1} << 20;  // largest size of a document, bytes
inline constexpr std::size_t most_nodes = 50'000;                  // values in a document after expansion of aliases
inline constexpr int deepest = 64;  // depth of nested maps and lists after expansion of aliases

// Reads a file. Throws Error at `asked_by` (default: at the file) for an unreadable file, or at a mistake in the file.
Node parse(const std::filesystem::path& file, const Location& asked_by = {});

// Reads a text in memory like parse(). `name` becomes the file name in all Locations.
Node parse_text(std::string_view text, const std::string& name);

// Reads one YAML value of any kind, such as the text behind "path=" in --set. All Locations of the result are `where`.
Node parse_value(std::string_view text, const Location& where);

}  // namespace regista::config
