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

// How config names the place of an override.
std::string place(const std::string& override_text) { return "--set " + override_text; }

}  // namespace

SortedOverrides::SortedOverrides(const std::vector<std::string>& all) {
  for (const std::string_view name : names) documents_.push_back({name, {}, {}});
  for (const std::string& text : all) {
    bool addressed = false;
    const std::size_t dot = text.find('.');
    for (Document& document : documents_) {
      if (dot == std::string::npos || !is_for(std::string_view(text).substr(0, dot), document.name)) continue;
      document.overrides.push_back(text.substr(dot + 1));
      document.typed.push_back(text);
      addressed = true;
    }
    if (addressed) continue;
    for (Document& document : documents_) {
      if (document.name != "home" && document.name != "away") continue;
      document.overrides.push_back(text);
      document.typed.push_back(text);
    }
  }
}

const SortedOverrides::Document& SortedOverrides::find(std::string_view document) const {
  const auto found = std::ranges::find(documents_, document, &Document::name);
  assert(found != documents_.end());
  return *found;
}

const config::Overrides& SortedOverrides::of(std::string_view document) const { return find(document).overrides; }

config::Error SortedOverrides::as_typed(std::string_view document, const config::Error& error) const {
  const Document& asked = find(document);
  for (std::size_t i = 0; i < asked.overrides.size(); ++i) {
    if (error.where().file != place(asked.overrides[i])) continue;
    const std::string message = std::string(error.what()).substr(config::to_string(error.where()).size() + 2);
    // A path for both teams may be wrong for one of them.
    const bool for_both = asked.typed[i] == asked.overrides[i];
    return {{place(asked.typed[i]), 0, 0}, for_both ? std::string(document) + " team: " + message : message};
  }
  return error;
}

}  // namespace regista::campaign
