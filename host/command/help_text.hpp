// SPDX-License-Identifier: MIT
// What --help says of a command: how it is called, what it takes, and its notes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "command/declaration.hpp"

namespace regista::command {

// Lines of at most `width` columns, each ended; words and examples that are longer than that are left whole.
std::string help_text(const CommandDeclaration& command, std::size_t width);

// Notes: paragraphs have an empty line between them and are filled anew; lines that begin with a space stay as they
// are, for they are examples. A line that ends with a colon stands alone.
std::string filled(std::string_view notes, std::size_t width);

}  // namespace regista::command
