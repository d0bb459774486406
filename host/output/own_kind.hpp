// SPDX-License-Identifier: MIT
// A file is replaced by one of its own kind: a slip of the hand must not cost results, teams or plugins. A kind is
// known by how its files begin.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "output/file_use.hpp"

namespace regista::output {

struct OwnKind {
  std::string_view what;  // "recording"
  std::span<const std::string_view> begins;
  bool needs_force = false;         // to replace one of its own kind: what cost time
  std::string_view cheap = {};      // how those begin that cost none, and are replaced without it by one of their like
  bool replaces_others = false;     // with --force
  bool moved_to_its_place = false;  // written under another name first, so it is the folder that must be writable
  std::string_view advice = {};     // beside --force
};

// Of everything but results, which the store looks after, and folders.
OwnKind own_kind(Writes what);

// What an ordinary file holds, seen from a kind.
enum class Found {
  nothing,   // it is empty
  own,       // one of the kind
  cheap,     // one of the kind that costs no time
  database,  // of SQLite: results are, whatever they are called
  other,
};
// Whether the file is a database of SQLite.
bool is_database(const std::filesystem::path& file);
Found found_in(const std::filesystem::path& file, const OwnKind& kind);

}  // namespace regista::output
