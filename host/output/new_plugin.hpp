// SPDX-License-Identifier: MIT
// Checks the name of a new plugin, and makes its files from templates. The templates are in share/regista/templates;
// README.md in that folder lists the placeholders.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "output/replaced_file.hpp"

namespace regista::output {

// Returns the reason why a new plugin cannot have this name, one line; empty for a valid name. The name becomes an id,
// a folder, a file and a CMake target.
std::string wrong_with_new_name(std::string_view name);

// The value of each placeholder by its name: {"NAME", "my_ball"}.
using PlaceholderValues = std::map<std::string, std::string, std::less<>>;

// Replaces each @NAME@ by the value of NAME, in one pass: placeholders in values are not replaced. Throws BadInput for
// a placeholder without a value.
std::string filled_in(std::string_view text, const PlaceholderValues& values);

// Returns all files of a new plugin, by name, from the folders `shared`, `shared/<language>`, `<kind>`,
// `<kind>/<language>`. Throws BadInput if one of these folders is missing or unreadable.
std::vector<NewFile> files_from_template(const std::filesystem::path& templates, const std::string& kind,
                                         const std::string& language, const PlaceholderValues& values);

}  // namespace regista::output
