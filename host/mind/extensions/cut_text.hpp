// SPDX-License-Identifier: MIT
// As much of a plugin's text as a limit in bytes allows, cut between two characters of UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace regista::mind {

inline std::string_view cut_text(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  const auto continues = [](char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80u; };
  std::size_t end = bytes;
  // A character has at most four bytes; where more go on, this is no UTF-8.
  for (int i = 0; i < 3 && end > 0 && continues(text[end]); ++i) --end;
  return text.substr(0, end);
}

}  // namespace regista::mind
