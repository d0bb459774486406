// SPDX-License-Identifier: MIT
// How the program was started, and what it was built or installed with.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "plugin/catalogue.hpp"

namespace regista::results {

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

// Plugins as commands look for them: in the folders of `--plugins`, then in those of the environment variable
// REGISTA_PLUGIN_PATH, then in the one that belongs to the program: ../lib/regista/plugins, seen from its own folder.
// Throws config::Error for a folder of an option that is none.
plugin::Catalogue open_plugins(const std::vector<std::string>& folders, const Invocation& invocation);

// The same for what is stored in a file of results, whose folders these are. Throws BadInput for one that is gone, with
// what to write instead.
plugin::Catalogue open_stored_plugins(const std::string& file, const std::vector<std::string>& folders,
                                      const Invocation& invocation);

}  // namespace regista::results
