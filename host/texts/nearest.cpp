// SPDX-License-Identifier: MIT
#include "texts/nearest.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace regista::texts {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

template <class Name>
std::string_view nearest_of(std::string_view asked, std::span<const Name> known) {
  constexpr std::size_t longest = 64;  // nobody mistypes a longer name, and the work stays small
  if (asked.empty() || asked.size() > longest) return {};
  std::string_view best;
  std::size_t least = std::max<std::size_t>(1, (asked.size() + 2) / 3) + 1;
  for (const Name& name : known) {
    if (name.size() > asked.size() + least || asked.size() > name.size() + least) continue;
    const std::size_t distance = edit_distance(asked, name);
    if (distance < least && distance < std::max(asked.size(), name.size())) {
      least = distance;
      best = name;
    }
  }
  return best;
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool equal = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (equal ? 0u : 1u)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

std::string_view nearest(std::string_view asked, std::span<const std::string_view> known) {
  return nearest_of(asked, known);
}
std::string_view nearest(std::string_view asked, std::span<const std::string> known) {
  return nearest_of(asked, known);
}

}  // namespace regista::texts
