// SPDX-License-Identifier: MIT
// A hash for what each step of a decision came to, so that of two plays of the same match the first step that differs
// can be named, and with it the plugins that computed it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "mind/mind.hpp"
#include "mind/team_plan.hpp"

namespace regista::match {

inline constexpr std::size_t decision_steps = 12;

// By step, in the order in which they are computed.
using DecisionDigest = std::array<std::uint64_t, decision_steps>;

// "the own pose", "the ball", ..., "whether to send".
std::string_view step_name(std::size_t step);

DecisionDigest digest_of(const mind::Mind& mind, const mind::Outcome& outcome);

// The ids of the team's plugins that have a part in this step: "distance, bearing". Empty: the host's own work.
std::string plugins_of_step(const mind::TeamPlan& plan, std::size_t step);

}  // namespace regista::match
