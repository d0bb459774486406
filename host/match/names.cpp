// SPDX-License-Identifier: MIT
#include "match/names.hpp"

#include <algorithm>
#include <array>

namespace regista::match {
namespace {

constexpr std::array<std::string_view, 5> phases{"initial", "ready", "set", "playing", "finished"};
constexpr std::array<std::string_view, 7> set_plays{"none",        "kick_off",          "kick_in",     "goal_kick",
                                                    "corner_kick", "pushing_free_kick", "penalty_kick"};
constexpr std::array<std::string_view, 4> play_kinds{"shot", "pass", "clearance", "duel"};
constexpr std::array<std::string_view, 9> play_outcomes{"none",        "goal", "saved", "missed",   "arrived",
                                                        "intercepted", "lost", "won",   "undecided"};

std::string one_word(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == ' ' || c == '-'; }, '_');
  return text;
}

}  // namespace

std::string_view name(mind::Phase phase) { return phases.at(static_cast<std::size_t>(phase)); }
std::string_view name(mind::SetPlay set_play) { return set_plays.at(static_cast<std::size_t>(set_play)); }

std::string word(EventKind kind) { return one_word(name(kind)); }
std::string_view name(PlayKind kind) { return play_kinds.at(static_cast<std::size_t>(kind)); }
std::string_view name(PlayOutcome outcome) { return play_outcomes.at(static_cast<std::size_t>(outcome)); }

std::string word(Offence offence) { return one_word(name(offence)); }

std::vector<std::string> role_names(const std::vector<Role>& roles) {
  std::vector<std::string> names;
  for (const Role& role : roles) {
    const bool unique = std::ranges::count(roles, role.name, &Role::name) == 1;
    names.push_back(unique ? role.name : role.list + '.' + role.name);
  }
  return names;
}

}  // namespace regista::match
