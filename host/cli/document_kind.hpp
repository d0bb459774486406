// SPDX-License-Identifier: MIT
// Kinds of documents as commands take them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/documents.hpp"

namespace regista::cli {

std::vector<std::string> kind_names();

// Throws BadInput, with the command's name, for what is no kind.
config::DocumentKind kind_named(const std::string& name, std::string_view command);

}  // namespace regista::cli
