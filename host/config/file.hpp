// SPDX-License-Identifier: MIT
// Files that a configuration names: found, or refused with a line that says who asked and what there is instead.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

// The whole content of a regular file of at most `largest_file` bytes. Throws Error at `asked_by` (at the file itself
// when that is not given) where there is none, and at the file where it is too large or not a file; `expected` says in
// that case what should have been there.
std::string read_file(const std::filesystem::path& file, const Location& asked_by = {},
                      std::string_view expected = "a file");

// The whole content, whatever its size; nothing where it cannot be read.
std::optional<std::string> file_content(const std::filesystem::path& file);

// A file that a value names: relative to the file the value stands in, for a value of the command line to the current
// folder. Throws Error at the value when that is not text, or empty; `what` is its path, such as "sender.file".
std::filesystem::path named_file(const Node& value, std::string_view what);

// named_file, absolute; throws Error at the value also when there is no such file.
std::filesystem::path existing_file(const Node& value, std::string_view what);

}  // namespace regista::config
