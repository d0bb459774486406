// SPDX-License-Identifier: MIT
// Segments of a team's plugins that no packet can ever take, so that teammates never hear them. Found out by letting
// the whole team decide and hear each other for some seconds at a kick-off that nobody plays: so it holds for plugins
// that nobody here has heard of, and it is but likely: a plugin may say more at another time.
#pragma once

#include <cstdint>
#include <vector>

#include "config/team_warnings.hpp"
#include "mind/team_plan.hpp"
#include "plugin/call_note.hpp"

namespace regista::mind {

struct UnsendableSegment {
  std::size_t part = 0;     // the first of TeamPlan::parts() with its plugin
  std::uint64_t bytes = 0;  // without the heading: the longest that was refused
};

// By part. Notes the calls; throws plugin::Failure. The same plan gives the same answer.
std::vector<UnsendableSegment> unsendable_segments(const TeamPlan& plan, plugin::Noting noting = {});

std::vector<config::Warning> unsendable_segment_warnings(const TeamPlan& plan,
                                                         const std::vector<UnsendableSegment>& found);

}  // namespace regista::mind
