// SPDX-License-Identifier: MIT
#include "plugin/markdown_text.hpp"

#include <algorithm>

namespace regista::plugin {
namespace {

bool one_of(char c, std::string_view characters) { return characters.find(c) != std::string_view::npos; }

}  // namespace

std::string as_text(std::string_view text) {
  const bool paired = std::ranges::count(text, '`') % 2 == 0 && text.find("``") == std::string_view::npos;
  bool in_code = false;
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '`' && paired) in_code = !in_code;
    const bool begins_tag = c == '<' && i + 1 < text.size() && text[i + 1] != ' ';
    const bool escaped = c == '|' || (c == '`' && !paired) || (!in_code && (begins_tag || one_of(c, "\\*[]")));
    if (escaped) out += '\\';
    out += c;
  }
  return out;
}

std::string as_paragraph(std::string_view text) {
  std::string out;
  if (!text.empty() && one_of(text.front(), "#+-=~>")) out += '\\';
  return out += as_text(text);
}

std::string as_code(std::string_view text) {
  std::size_t longest = 0, run = 0;
  std::string inside;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
    if (c == '|') inside += '\\';  // else it would end the cell, even here
    inside += c;
  }
  const std::string fence(longest + 1, '`');
  const std::string_view space = longest == 0 ? "" : " ";
  std::string out = fence;
  out += space;
  out += inside;
  out += space;
  return out += fence;
}

}  // namespace regista::plugin
