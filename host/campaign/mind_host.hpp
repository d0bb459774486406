// SPDX-License-Identifier: MIT
// The minds of one team in a process of their own: answers the questions of a match until it is ended.
#pragma once

#include <cstdint>

#include "campaign/limits.hpp"
#include "campaign/mind_channel.hpp"
#include "match/side.hpp"
#include "mind/team_plan.hpp"

namespace regista::campaign {

// What a play looks at beyond what it needs itself.
struct Examination {
  bool closely = false;           // at every call, see plugin::Noting
  bool digest_decisions = false;  // to tell where another play differs first
};

// To be called in a fresh copy of the match's process, which it never leaves. The first answer says that the minds have
// been created. Nothing leaves it: what called it belongs to the match's process, of which this is a copy.
[[noreturn]] void serve_minds(const mind::TeamPlan& plan, match::Side side, std::uint64_t seed,
                              const Examination& examination, MindChannel& channel) noexcept;

}  // namespace regista::campaign
