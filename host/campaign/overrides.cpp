// SPDX-License-Identifier: MIT
#include "campaign/overrides.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace regista::campaign {
namespace {

constexpr std::array<std::string_view, 7> names{
    "home", "away", "rules", "robot", "home_disturbance", "away_disturbance", "opening"};

// The first part of a path, and the documents it is for.
bool is_for(std::string_view part, std::string_view document) {
  return part == document || (part == "disturbance" && document.ends_with("_disturbance"));
}

}  // namespace

SortedOverrides::SortedOverrides(const config::Overrides& all) {
  for (const std::string_view name : names) documents_.push_back({name, {}});
  for (const config::Override& each : all) {
    const std::size_t dot = each.path.find('.');
    const std::string_view first =
        dot == std::string::npos ? std::string_view() : std::string_view(each.path).substr(0, dot);
    const bool addressed = std::ranges::any_of(names, [first](std::string_view name) { return is_for(first, name); });
    for (Document& document : documents_) {
      const bool of_both = !addressed && (document.name == "home" || document.name == "away");
      if (of_both) document.overrides.push_back(each);
      if (is_for(first, document.name))
        document.overrides.emplace_back(each.path.substr(dot + 1), each.value, each.where);
    }
  }
}

const config::Overrides& SortedOverrides::of(std::string_view document) const {
  const auto found = std::ranges::find(documents_, document, &Document::name);
  assert(found != documents_.end());
  return found->overrides;
}

}  // namespace regista::campaign
