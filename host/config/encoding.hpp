// SPDX-License-Identifier: MIT
// What a file must be before it can be YAML: UTF-8 text without byte order mark or control characters, indented by
// spaces. yaml-cpp reads bytes outside of that silently as something else (0x04 ends its input).
#pragma once

#include <string>
#include <string_view>

namespace regista::config {

// Throws Error at the first byte that may not stand there. `name` is what messages call the text.
void check_encoding(std::string_view text, const std::string& name);

}  // namespace regista::config
