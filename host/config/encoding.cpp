// SPDX-License-Identifier: MIT
#include "config/encoding.hpp"

#include <fmt/format.h>

#include <utility>

namespace regista::config {
namespace {

// Length of the well-formed UTF-8 sequence at the beginning of `text`, 0 where there is none (Unicode 15, table 3-7).
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const auto in = [](unsigned value, unsigned least, unsigned most) { return value >= least && value <= most; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (in(first, 0xc2, 0xdf)) return in(byte(1), 0x80, 0xbf) ? 2 : 0;
  if (in(first, 0xe0, 0xef)) {
    const unsigned least = first == 0xe0 ? 0xa0 : 0x80, most = first == 0xed ? 0x9f : 0xbf;
    return in(byte(1), least, most) && in(byte(2), 0x80, 0xbf) ? 3 : 0;
  }
  if (in(first, 0xf0, 0xf4)) {
    const unsigned least = first == 0xf0 ? 0x90 : 0x80, most = first == 0xf4 ? 0x8f : 0xbf;
    return in(byte(1), least, most) && in(byte(2), 0x80, 0xbf) && in(byte(3), 0x80, 0xbf) ? 4 : 0;
  }
  return 0;
}

}  // namespace

std::optional<EncodingFlaw> encoding_flaw(std::string_view text) {
  constexpr std::size_t longest_line = 65536;  // yaml-cpp may look ahead to the end of a line
  if (text.starts_with("\xef\xbb\xbf")) {
    return EncodingFlaw{1, 1, "begins with a byte order mark; save it as UTF-8 without one"};
  }
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    return EncodingFlaw{1, 1, "is UTF-16 text; save it as UTF-8"};
  }
  int line = 1;
  std::size_t line_start = 0;
  bool indenting = true;
  for (std::size_t i = 0; i < text.size();) {
    const auto flaw = [&](std::string message) {
      return EncodingFlaw{line, static_cast<int>(i - line_start) + 1, std::move(message)};
    };
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '\n') {
      ++line;
      line_start = ++i;
      indenting = true;
      continue;
    }
    if (i - line_start >= longest_line) return flaw(fmt::format("line is longer than {} bytes", longest_line));
    if (byte == '\t' && indenting) return flaw("tab in the indentation; use spaces");
    if (byte == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) return flaw("carriage return inside a line");
    if ((byte < 0x20 && byte != '\t' && byte != '\r') || byte == 0x7f) {
      return flaw(fmt::format("byte 0x{:02x} is not text; is this a binary file?", byte));
    }
    if (byte != ' ') indenting = false;
    const std::size_t length = sequence_length(text.substr(i, 4));
    if (length == 0) return flaw(fmt::format("byte 0x{:02x} is not UTF-8", byte));
    i += length;
  }
  return std::nullopt;
}

}  // namespace regista::config
