// SPDX-License-Identifier: MIT
// Contexts of a team that are never in force, and situations that none of them takes. Both are found out by asking the
// conditions in made-up scenes, so it holds for plugins that nobody here has heard of; and both are but likely: there
// may be a scene that was not thought of. What follows from the page alone is config::warnings().
//
// A scene is a moment of a short course of the game: Ready, Set and play with and without a set play, any score that a
// game goes on with, any time of either half, the ball known, lost or unknown, robots anywhere or about the ball; each
// course is seen by one robot of the team. Conditions with a mailbox are believed to heed what scenes do not tell.
#pragma once

#include <vector>

#include "config/team_warnings.hpp"
#include "mind/team_plan.hpp"
#include "plugin/call_note.hpp"

namespace regista::mind {

struct ContextFinding {
  int held = 0;         // scenes in which its condition held
  int in_force = 0;     // scenes in which it was the first that held
  int covered_by = -1;  // the first one above it that held whenever it did; -1: none did
};

struct ContextFindings {
  int scenes = 0;
  int without = 0;                       // scenes in which no condition held
  std::vector<ContextFinding> contexts;  // in the order of TeamPlan::contexts()
};

// Calls the conditions and notes the calls; throws plugin::Failure. The same plan gives the same answer.
ContextFindings idle_contexts(const TeamPlan& plan, plugin::Noting noting = {});

// In the order of the contexts; at last, that there are scenes without any.
std::vector<config::Warning> idle_context_warnings(const TeamPlan& plan, const ContextFindings& found);

}  // namespace regista::mind
