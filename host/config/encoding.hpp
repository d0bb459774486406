// SPDX-License-Identifier: MIT
// What a file must be before it can be YAML: UTF-8 text without byte order mark or control characters, indented by
// spaces. yaml-cpp reads bytes outside of that silently as something else (0x04 ends its input).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace regista::config {

struct EncodingFlaw {
  int line, column;  // from 1
  std::string message;
};

// The first byte that may not stand where it does, if there is one.
std::optional<EncodingFlaw> encoding_flaw(std::string_view text);

}  // namespace regista::config
