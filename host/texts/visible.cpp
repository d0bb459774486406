// SPDX-License-Identifier: MIT
#include "texts/visible.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace regista::texts {
namespace {

struct Character {
  char32_t code;
  std::size_t bytes;  // 0: these bytes are no character
};

// The character at the beginning of a text that is not empty.
Character first_of(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || text.size() < bytes) return {0, 0};
  char32_t code = lead & (0xffu >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {0, 0};
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code < least[bytes] || surrogate || code > 0x10ffff ? Character{0, 0} : Character{code, bytes};
}

bool unseen(char32_t code) {
  const auto within = [code](char32_t low, char32_t high) { return code >= low && code <= high; };
  const bool control = code < 0x20 || within(0x7f, 0x9f);
  const bool turns = code == 0x61c || within(0x200e, 0x200f) || within(0x202a, 0x202e) || within(0x2066, 0x2069);
  const bool no_width = code == 0xad || within(0x200b, 0x200d) || code == 0x2060 || code == 0xfeff;
  const bool breaks_line = within(0x2028, 0x2029);
  const bool no_character = within(0xfdd0, 0xfdef) || (code & 0xfffe) == 0xfffe || within(0xfff9, 0xfffb);
  return control || turns || no_width || breaks_line || no_character;
}

std::string escape(char32_t code) {
  switch (code) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return code < 0x100 ? fmt::format("\\x{:02x}", static_cast<std::uint32_t>(code))
                          : fmt::format("\\u{:04x}", static_cast<std::uint32_t>(code));
  }
}

std::string shown(std::string_view text, bool lines, std::size_t most) {
  std::string out;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return out + "...";
    const Character next = first_of(text);
    if (next.bytes == 0) {
      out += "\xef\xbf\xbd";
      text.remove_prefix(1);
      continue;
    }
    if (unseen(next.code) && !(lines && next.code == '\n'))
      out += escape(next.code);
    else
      out += text.substr(0, next.bytes);
    text.remove_prefix(next.bytes);
  }
  return out;
}

}  // namespace

std::string visible(std::string_view text) { return shown(text, false, std::string_view::npos); }
std::string visible_lines(std::string_view text) { return shown(text, true, std::string_view::npos); }
std::string visible_at_most(std::string_view text, std::size_t characters) { return shown(text, false, characters); }

}  // namespace regista::texts
