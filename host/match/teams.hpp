// SPDX-License-Identifier: MIT
// A match between two teams of minds: from two plans to fourteen minds, each alone, and the match they play.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "match/match.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"

namespace regista::match {

// One mind of a side, and all of them by their numbers. Their luck belongs to (seed, side), so that it stays when teams
// swap sides. Throws plugin::Failure when a plugin cannot be created. noting: see plugin/call_note.hpp; its side is set
// here.
mind::Mind mind(const mind::TeamPlan& plan, Side side, int number, std::uint64_t seed, plugin::Noting noting = {},
                const mind::Telling& telling = {});
std::vector<mind::Mind> minds(const mind::TeamPlan& plan, Side side, std::uint64_t seed, plugin::Noting noting = {},
                              const mind::Telling& telling = {});

// The team's table of roles, for the metrics.
std::vector<Role> roles(const mind::TeamPlan& plan);

// Called after each decision of a mind, when it is known what became of its packet; it cannot change it.
using AfterDecision = std::function<void(const mind::Mind&, const Decision&)>;

// Plays `setup` (its `roles` are taken from the plans). Throws as play() and Mind do.
Result play(Setup setup, const std::array<const mind::TeamPlan*, 2>& teams, const Observer* observer = nullptr,
            const AfterDecision& after = {}, plugin::Noting noting = {});

}  // namespace regista::match
