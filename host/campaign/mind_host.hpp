// SPDX-License-Identifier: MIT
// Minds of one team in a process of their own: answers the questions of a match until it is ended.
#pragma once

#include <cstdint>

#include "campaign/limits.hpp"
#include "campaign/mind_channel.hpp"
#include "match/side.hpp"
#include "mind/team_plan.hpp"
#include "plugin/call_note.hpp"

namespace regista::campaign {

// What a play looks at beyond what it needs itself.
struct Examination {
  plugin::Look look = plugin::Look::seldom;
  bool hides = false;    // see plugin::Noting
  bool answers = false;  // what plugins answered is handed over with each outcome
  // See process/confinement.hpp; what is tried is noted. At the end it is said what plugins keep in their files'
  // memory.
  bool confined = false;
};

// Whose minds a process has: all of a side, or one.
struct MindPlace {
  match::Side side = match::Side::home;
  int robot = 0;  // number, from 1; 0: all of them
};

// To be called in a fresh copy of the match's process, which it never leaves. The first answer says that the minds have
// been created. Nothing leaves it: what called it belongs to the match's process, of which this is a copy.
[[noreturn]] void serve_minds(const mind::TeamPlan& plan, const MindPlace& place, std::uint64_t seed,
                              const Examination& examination, MindChannel& channel) noexcept;

}  // namespace regista::campaign
