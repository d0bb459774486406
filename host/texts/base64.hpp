// SPDX-License-Identifier: MIT
// Base64 of RFC 4648, section 4: bytes as text that may stand in a page.
#pragma once

#include <string>
#include <string_view>

namespace regista::texts {

inline void append_base64(std::string& to, std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
  to.reserve(to.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    to += digits[group >> 18];
    to += digits[group >> 12 & 63];
    to += i + 1 < bytes.size() ? digits[group >> 6 & 63] : '=';
    to += i + 2 < bytes.size() ? digits[group & 63] : '=';
  }
}

}  // namespace regista::texts
