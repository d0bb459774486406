// SPDX-License-Identifier: MIT
// What a new plugin may be called: its name becomes an id, a folder, a file and a target of CMake.
#pragma once

#include <string>
#include <string_view>

namespace regista::cli {

// Why a new plugin cannot have this name, in one line that names it; empty when it can.
std::string wrong_with_new_name(std::string_view name);

}  // namespace regista::cli
