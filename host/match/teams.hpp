// SPDX-License-Identifier: MIT
// Creates minds from team plans and plays a match between two teams.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "match/match.hpp"
#include "match/metrics_world.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"

namespace regista::match {

// mind() creates one mind of a side; minds() all of them, by robot number. Random numbers depend on (seed, side), so
// they stay with the side when two teams swap sides. Both set tracing.side, and throw plugin::Failure like Mind.
mind::Mind mind(const mind::TeamPlan& plan, Side side, int number, std::uint64_t seed, plugin::CallTracing tracing = {},
                const mind::MindOptions& options = {});
std::vector<mind::Mind> minds(const mind::TeamPlan& plan, Side side, std::uint64_t seed,
                              plugin::CallTracing tracing = {}, const mind::MindOptions& options = {});

// Returns the team's table of roles in the form that the metrics need.
std::vector<Role> roles(const mind::TeamPlan& plan);

// Receives each decision with its mind, after the referee has charged the packet. The function cannot change the match.
using AfterDecision = std::function<void(const mind::Mind&, const Decision&)>;

// Plays a match of two teams. The plans give roles, reasons and plugin metrics. Throws what play() and Mind throw.
Result play(Setup setup, const std::array<const mind::TeamPlan*, 2>& teams, const Observer* observer = nullptr,
            const AfterDecision& after = {}, plugin::CallTracing tracing = {});

// Reads what a mind believes in its world `mine`: a ball that its camera has not refuted, and active teammates.
void belief_of(const mind::Mind& mind, Belief& out);

}  // namespace regista::match
