// SPDX-License-Identifier: MIT
// Terms of a team's utility that can change nothing. A term that gives all robots the same number for a task moves a
// whole column of the utility matrix. That decides which tasks are done where some stay undone. It decides nothing
// where the assigner compares robots task by task, nor where each task gets a robot anyway, for the sum of every
// assignment then grows by the same number (Kuhn, "The Hungarian method for the assignment problem", 1955).
//
// Both are found out by calling the plugins on made-up scenes, so it holds for plugins that nobody here has heard of.
// Scenes do not tell what teammates say: whoever has a mailbox is believed to heed it.
#pragma once

#include <vector>

#include "config/team_warnings.hpp"
#include "mind/team_plan.hpp"
#include "plugin/call_note.hpp"

namespace regista::mind {

// For each term of each context, in the order of TeamPlan::contexts(), whether it was found idle there. A weight of 0
// is no finding: whoever wrote it knows. Calls the team's plugins and notes the calls; throws plugin::Failure. The same
// plan gives the same answer.
std::vector<bool> idle_terms(const TeamPlan& plan, plugin::Noting noting = {});

// For each term of each context, in the same order, whether it rewards nearness to waypoints that its context has not:
// in a context without a positioner, it gave all robots the same number for all tasks, but others when there were
// waypoints. As above, a weight of 0 is no finding.
std::vector<bool> terms_without_waypoints(const TeamPlan& plan, plugin::Noting noting = {});

// A warning for each term that is idle in every context where it has a weight, and for each that lacks waypoints in
// some context. Of one that lacks them in all it is enough to say that.
std::vector<config::Warning> idle_term_warnings(const TeamPlan& plan, const std::vector<bool>& idle,
                                                const std::vector<bool>& without_waypoints);

}  // namespace regista::mind
