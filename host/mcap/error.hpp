// SPDX-License-Identifier: MIT
// What goes wrong with a file, in one line: "match.mcap: cannot be written: No space left on device".
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace regista::mcap {

class Error : public std::runtime_error {
 public:
  // `reason` goes on after the file's name: "is empty", "cannot be opened: Permission denied".
  Error(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason) {}
};

}  // namespace regista::mcap
