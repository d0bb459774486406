// SPDX-License-Identifier: MIT
// From a template to the files of a new plugin. The templates stand in share/regista/templates; their README.md says
// which placeholders there are.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "output/new_folder.hpp"

namespace regista::cli {

// What a placeholder stands for, by its name: {"NAME", "my_ball"}.
using PlaceholderValues = std::map<std::string, std::string, std::less<>>;

// The text with the value of NAME in the place of each @NAME@, in one pass: what a value says is left as it is. Throws
// BadInput for a placeholder that has none.
std::string filled_in(std::string_view text, const PlaceholderValues& values);

// All files of a new plugin, by name: those of the folders `shared`, `shared/<language>`, `<kind>`,
// `<kind>/<language>`. Throws BadInput where one of these is not there or cannot be read.
std::vector<output::NewFile> files_from_template(const std::filesystem::path& templates, const std::string& kind,
                                                 const std::string& language, const PlaceholderValues& values);

}  // namespace regista::cli
