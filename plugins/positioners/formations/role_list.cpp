// SPDX-License-Identifier: MIT
#include "role_list.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace formations {
namespace {

constexpr std::string_view blank = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t exchanged = corner + (a[i] == b[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({exchanged, corner + 1, row[j] + 1});
    }
  }
  return row.back();
}

void add_rows(std::string_view key, std::string_view value, const std::string& where, std::span<const Role> roles,
              std::vector<RoleEntry>& out) {
  const std::size_t before = out.size();
  for (std::size_t row = 0; row < roles.size(); ++row) {
    const Role& role = roles[row];
    if (key == role.name || key == role.list + "/" + role.name) {
      out.push_back({row, value, where + ": " + std::string(key)});
    }
  }
  if (out.size() > before) return;
  std::vector<std::string> names;
  for (const Role& role : roles) {
    names.push_back(key.find('/') == std::string_view::npos ? role.name : role.list + "/" + role.name);
  }
  const std::string nearest = nearest_name(key.substr(0, 100), names);
  throw std::invalid_argument(where + ": no role " + quoted(key) +
                              (names.empty() ? "; the team has none" : "; the nearest is \"" + nearest + "\""));
}

}  // namespace

std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text.substr(0, 40)) out += c >= ' ' && c <= '~' ? c : '?';
  return out + (text.size() > 40 ? "...\"" : "\"");
}

std::string nearest_name(std::string_view name, std::span<const std::string> names) {
  if (names.empty()) return {};
  return *std::ranges::min_element(names, {}, [&](const std::string& other) { return edits(name, other); });
}

std::vector<RoleEntry> role_entries(std::string_view text, std::span<const Role> roles, std::string_view what) {
  std::vector<RoleEntry> general, of_lists;
  std::vector<std::string_view> keys;
  std::size_t line = 1;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view rest = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    rest = rest.substr(0, rest.find('#'));
    const std::string where = std::string(what) + ": line " + std::to_string(line++);
    while (!rest.empty()) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      const std::string_view entry = trimmed(rest.substr(0, comma));
      rest.remove_prefix(std::min(comma + 1, rest.size()));
      if (entry.empty()) continue;
      const std::size_t colon = entry.find(':');
      if (colon == std::string_view::npos) {
        throw std::invalid_argument(where + ": " + quoted(entry) + " has no colon; an entry is \"role: value\"");
      }
      const std::string_view key = trimmed(entry.substr(0, colon)), value = trimmed(entry.substr(colon + 1));
      if (std::ranges::find(keys, key) != keys.end()) {
        throw std::invalid_argument(where + ": " + quoted(key) + " stands twice");
      }
      keys.push_back(key);
      add_rows(key, value, where, roles, key.find('/') == std::string_view::npos ? general : of_lists);
    }
  }
  general.insert(general.end(), of_lists.begin(), of_lists.end());
  return general;
}

void read_numbers(std::string_view text, std::span<double> out, const std::string& where) {
  std::string_view rest = trimmed(text);
  for (double& number : out) {
    const std::string_view word = rest.substr(0, rest.find_first_of(blank));
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (word.empty() || error != std::errc() || end != word.data() + word.size() || !std::isfinite(number)) {
      throw std::invalid_argument(where + ": " + quoted(text) + " is not " +
                                  (out.size() == 1 ? "a number" : std::to_string(out.size()) + " numbers"));
    }
    rest = trimmed(rest.substr(word.size()));
  }
  if (!rest.empty()) throw std::invalid_argument(where + ": " + quoted(rest) + " is too much");
}

}  // namespace formations
