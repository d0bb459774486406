// SPDX-License-Identifier: MIT
// What things of a match are called in logs, recordings and reports: lower case, words joined by underscores.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "match/game_state.hpp"
#include "match/metrics.hpp"
#include "match/play_event.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

std::string_view name(mind::Phase phase);
std::string_view name(mind::SetPlay set_play);

// name(kind) as one word: "kick_off".
std::string word(EventKind kind);
std::string word(Offence offence);
std::string_view name(PlayKind kind);
std::string_view name(PlayOutcome outcome);

// Reason of a packet, for REGISTA_EVENT_*: "role_changed".

// What each role of a team's table is called where one word is wanted: its name, or "list.name" when several lists have
// a role of that name.
std::vector<std::string> role_names(const std::vector<Role>& roles);

}  // namespace regista::match
