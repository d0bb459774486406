// SPDX-License-Identifier: MIT
#include "texts/message.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numeric>

namespace regista::texts {
namespace {

char lower_letter(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

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
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  if (code == '\t') return "\\t";
  const auto number = static_cast<std::uint32_t>(code);
  return code < 0x100 ? fmt::format("\\x{:02x}", number) : fmt::format("\\u{:04x}", number);
}

std::string shown(std::string_view text, bool lines, std::size_t most) {
  std::string out;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count == most) return out + "...";
    const Character next = first_character(text);
    if (next.bytes == 0) {
      out += "\xef\xbf\xbd";
    } else if (unseen(next.code) && !(lines && next.code == '\n')) {
      out += escape(next.code);
    } else {
      out += text.substr(0, next.bytes);
    }
    text.remove_prefix(std::max<std::size_t>(next.bytes, 1));
  }
  return out;
}

}  // namespace

std::string one_line(std::string_view text) { return visible(text); }

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  if (text.size() <= longest) return '"' + one_line(text) + '"';
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;  // cuts between characters
  return '"' + one_line(text.substr(0, end)) + "...\"";
}

std::string join(std::span<const std::string> names) {
  return fmt::format("{}", fmt::join(names_of(names, one_line), ", "));
}

std::string plural(std::uint64_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string with_article(std::string_view noun) {
  const bool vowel = std::string_view("aeio").find(noun.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", noun);
}

std::string with_backslashes(std::string_view text, std::string_view before) {
  std::string out;
  for (const char c : text) {
    if (before.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string duration(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
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

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), lower_letter);
  return text;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char one, char other) { return lower_letter(one) == lower_letter(other); };
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (same(a[i - 1], b[j - 1]) ? 0u : 1u)});
      const bool swapped = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view nearest(std::string_view asked, std::span<const std::string> known) {
  constexpr std::size_t longest = 64;  // limits the work; a longer text is probably no mistyped name
  if (asked.empty() || asked.size() > longest) return {};
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, (asked.size() + 2) / 3) + 1;
  for (const std::string& name : known) {
    if (name.size() > asked.size() + least || asked.size() > name.size() + least) continue;
    const std::size_t distance = edit_distance(asked, name);
    if (distance < least && distance < std::max(asked.size(), name.size())) {
      least = distance;
      best = name;
    }
  }
  return best;
}

Character first_character(std::string_view text) {
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

std::string visible(std::string_view text) { return shown(text, false, std::string_view::npos); }
std::string visible_lines(std::string_view text) { return shown(text, true, std::string_view::npos); }
std::string visible_at_most(std::string_view text, std::size_t characters) { return shown(text, false, characters); }

}  // namespace regista::texts
