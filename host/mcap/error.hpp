// SPDX-License-Identifier: MIT
// What goes wrong with a file, in one line: "match.mcap: cannot be written: No space left on device".
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace regista::mcap {

class Error : public std::runtime_error {
 public:
  // `reason` goes on after the file's name: "is empty", "cannot be opened: Permission denied".
  Error(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason) {}
};

// What the system says of an error number.
inline std::string reason(int error) { return std::generic_category().message(error); }

}  // namespace regista::mcap
