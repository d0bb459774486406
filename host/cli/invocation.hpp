// SPDX-License-Identifier: MIT
// How the program was started, and what it was built or installed with.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace regista::cli {

struct StudyKind;

// Outlives the commands.
struct Invocation {
  std::vector<std::string> arguments;  // the first is the name of the program
  std::filesystem::path executable{};  // its own file; empty when the system does not know
  std::span<const StudyKind> studies{};

  // A file or folder that belongs to the program, as "share/regista/viewer.html", whether it is there or not; empty
  // when the system does not know where the program is.
  std::filesystem::path own(const std::filesystem::path& name) const {
    return executable.empty() ? executable : (executable.parent_path() / ".." / name).lexically_normal();
  }
};

}  // namespace regista::cli
