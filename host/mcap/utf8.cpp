// SPDX-License-Identifier: MIT
#include "mcap/utf8.hpp"

#include <cstddef>

namespace regista::mcap {

bool is_utf8(std::string_view bytes) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  for (std::size_t i = 0; i < bytes.size();) {
    const unsigned first = at(i++);
    if (first < 0x80) continue;
    const std::size_t more = first >= 0xc2 && first <= 0xdf   ? 1
                             : (first & 0xf0) == 0xe0         ? 2
                             : first >= 0xf0 && first <= 0xf4 ? 3
                                                              : 0;
    if (more == 0 || bytes.size() - i < more) return false;
    // Neither overlong forms, nor surrogates, nor beyond U+10FFFF: all seen at the second byte.
    const unsigned lowest = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
    const unsigned highest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
    if (at(i) < lowest || at(i) > highest) return false;
    for (std::size_t k = 1; k < more; ++k) {
      if ((at(i + k) & 0xc0) != 0x80) return false;
    }
    i += more;
  }
  return true;
}

}  // namespace regista::mcap
