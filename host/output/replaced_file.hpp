// SPDX-License-Identifier: MIT
// A file that is there whole or not at all: written beside its place under another name, then moved there. What stood
// there before is lost only when the new file is complete.
#pragma once

#include <filesystem>
#include <string_view>

namespace regista::output {

enum class Existing { refused, replaced };

// Throws BadInput when the file exists and is not to be replaced (the message names --force), is no ordinary file, or
// cannot be made there, or when markup would replace what is none; WriteError when its bytes cannot be kept, as on a
// full disk.
void write_whole(const std::filesystem::path& file, std::string_view bytes, Existing existing);

}  // namespace regista::output
