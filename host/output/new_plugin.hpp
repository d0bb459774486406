// SPDX-License-Identifier: MIT
// What a new plugin may be called, and its files, from a template. The templates are in share/regista/templates; their
// README.md says which placeholders there are.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "output/new_folder.hpp"

namespace regista::output {

// Why a new plugin cannot have this name, which becomes an id, a folder, a file and a target of CMake: in one line that
// names it; empty when it can.
std::string wrong_with_new_name(std::string_view name);

// What a placeholder stands for, by its name: {"NAME", "my_ball"}.
using PlaceholderValues = std::map<std::string, std::string, std::less<>>;

// The text with the value of NAME in the place of each @NAME@, in one pass: what a value says is left as it is. Throws
// BadInput for a placeholder that has none.
std::string filled_in(std::string_view text, const PlaceholderValues& values);

// All files of a new plugin, by name: those of the folders `shared`, `shared/<language>`, `<kind>`,
// `<kind>/<language>`. Throws BadInput where one of these is not there or cannot be read.
std::vector<NewFile> files_from_template(const std::filesystem::path& templates, const std::string& kind,
                                         const std::string& language, const PlaceholderValues& values);

}  // namespace regista::output
