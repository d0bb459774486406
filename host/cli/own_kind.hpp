// SPDX-License-Identifier: MIT
// A file is replaced only by one of its own kind: a slip of the hand must not cost results, teams or plugins.
#pragma once

#include <filesystem>
#include <string_view>

namespace regista::cli {

// Throws BadInput when there is an ordinary file of this name that is not empty and does not begin so. what:
// "recording".
void refuse_other_kinds(std::string_view option, const std::filesystem::path& file, std::string_view begin,
                        std::string_view what);

}  // namespace regista::cli
