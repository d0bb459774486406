// SPDX-License-Identifier: MIT
#include "texts/message.hpp"

#include <fmt/format.h>

#include "texts/nearest.hpp"
#include "texts/visible.hpp"

namespace regista::texts {

std::string one_line(std::string_view text) { return visible(text); }

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return '"' + one_line(text) + '"';
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // not inside a character
  return '"' + one_line(text.substr(0, end)) + "...\"";
}

std::string join(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) {
    if (!list.empty()) list += ", ";
    list += one_line(name);
  }
  return list;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string unknown(std::string_view what, std::string_view asked, std::string_view where,
                    std::span<const std::string> known) {
  std::string message = fmt::format("unknown {} {}", what, in_quotes(asked));
  if (!where.empty()) message += fmt::format(" in {}", where);
  if (const std::string_view near = nearest(asked, known); !near.empty()) {
    message += fmt::format("; nearest: {}", in_quotes(near));
  }
  constexpr std::size_t most = 24;
  if (!known.empty()) {
    message += "; known: " + join(known.first(std::min(known.size(), most)));
    if (known.size() > most) message += fmt::format(" and {} more", known.size() - most);
  }
  return message;
}

}  // namespace regista::texts
