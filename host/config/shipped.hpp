// SPDX-License-Identifier: MIT
// The documents that come with the program, found by their names: `paper` is the team configs/teams/paper.yaml in the
// program's folder share/regista, wherever the program runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace regista::config {

// Returns the path of the shipped document NAME.yaml, or of the shipped folder of documents NAME ("openings"). The path
// is empty if no shipped document or folder has this name.
std::filesystem::path shipped(const std::string& name);

// Returns the names of all shipped documents, sorted.
std::vector<std::string> shipped_names();

// Returns the path of the shipped document that is called `written`. Returns `path` if the file `path` exists, if
// `written` contains a dot or a slash, or if no shipped document has this name. `path` is `written` with its folder.
std::filesystem::path own_or_shipped(const std::filesystem::path& path, const std::filesystem::path& written);
inline std::filesystem::path own_or_shipped(const std::filesystem::path& path) { return own_or_shipped(path, path); }

}  // namespace regista::config
