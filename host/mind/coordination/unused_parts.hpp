// SPDX-License-Identifier: MIT
// Searches for parts of a team that probably have no effect: contexts that never apply, terms of the utility that
// change nothing, and segments that are too long for every packet. Also finds situations in which no context applies.
// The searches call the team's plugins in made-up scenes, and so need no knowledge about the plugins. The scenes may
// lack a situation in which a part has an effect. config::warnings() reports what the team's document alone shows.
//
// Scenes have no packets of teammates, so the searches do not judge contexts and terms whose plugin has a mailbox. All
// searches throw plugin::Failure if a plugin fails. Equal plans give equal findings.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "config/team_check.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/world_model.hpp"
#include "plugin/call_inputs.hpp"

namespace regista::mind {

// --- Made-up scenes.

inline constexpr std::uint64_t made_up_seed = 1;  // seed of scenes and plugins

// Returns whether the plugin has a mailbox, so that its answers may depend on packets, which a made-up scene lacks.
inline bool talks(const Part& part) { return part.found->description->implements(REGISTA_KIND_MAILBOX); }

// Random numbers for scenes. The standard library's distributions are not used: they differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  double real(double low, double high) {
    const double share = static_cast<double>(random_() >> 11) * 0x1p-53;
    return low + share * (high - low);
  }
  bool chance(double share) { return real(0.0, 1.0) < share; }
  int below(int count) { return static_cast<int>(real(0.0, count)); }
  // Returns a number whose logarithm is uniform.
  double log_real(double low, double high) { return low * std::exp(real(0.0, std::log(high / low))); }
  // Returns a multiple of 1/16 in [0, most). Sums of such numbers are exact, so sums that should be equal are equal.
  double sixteenths(double most) { return std::floor(real(0.0, 16.0 * most)) / 16.0; }

 private:
  std::mt19937_64 random_;
};

// Fills a world: robots and ball are known and anywhere on the field, robots have roles of the role list number `list`,
// the ball is in play. scene: another number gives each robot another role. own: number of the robot that has this
// world. out_of_play: number of a penalised robot; 0: none. The caller must then call world.close().
void make_up(DistributedWorldModel& world, const TeamPlan& plan, int list, int scene, double time, int own,
             int out_of_play, Dice& dice);

// --- Contexts. A scene is a moment of a short made-up game. The game may be in Ready, Set, play or a set play, at any
// time of a half and at any score that the mercy rule allows. The ball is known, lost or unknown. Robots are anywhere
// or around the ball. In each game, one robot of the team calls its conditions.

struct ContextFinding {
  int held = 0;         // number of scenes in which the context's condition held
  int in_force = 0;     // number of scenes in which the context was the first whose condition held
  int covered_by = -1;  // index of the first earlier context that held in all scenes in which this one held; -1: none
};

// [of the opponent, of this team][set play, from the kick-off on][Ready, Set, Playing]: in some scene, another context
// is in force than in open play.
using SetPlayContexts = std::array<std::array<std::array<bool, 3>, REGISTA_SET_PLAY_PENALTY_KICK>, 2>;

struct ContextFindings {
  int scenes = 0;
  int without = 0;                       // number of scenes in which no context's condition held
  std::vector<ContextFinding> contexts;  // in the order of TeamPlan::contexts()
  SetPlayContexts set_plays{};
};

ContextFindings idle_contexts(const TeamPlan& plan, plugin::CallTracing tracing = {});

// Returns a warning for each idle context, in the order of the contexts, then a warning about scenes without a context,
// then one for each set play of a team without a context of its own in a phase in which another set play has one.
std::vector<config::Warning> idle_context_warnings(const TeamPlan& plan, const ContextFindings& found);

// --- Terms. A term that gives all robots the same number for a task adds it to a whole column of the utility matrix.
// This matters only if some tasks get no robot and the assigner compares tasks. If each task gets a robot, the sum of
// every assignment grows by the same number (Kuhn, "The Hungarian method for the assignment problem", 1955).

// Returns whether a term has no effect in its context, for each term of each context in the order of
// TeamPlan::contexts(). A term with weight 0 is not reported, because its author chose the weight.
std::vector<bool> idle_terms(const TeamPlan& plan, plugin::CallTracing tracing = {});

// Returns, in the order of idle_terms(), whether a term needs waypoints but its context has no positioner to make
// waypoints. Such a term gives all robots one number for all tasks, but with made-up waypoints several numbers.
std::vector<bool> terms_without_waypoints(const TeamPlan& plan, plugin::CallTracing tracing = {});

// Returns a warning for each term that is idle in every context where it has a weight, and for each term that lacks
// waypoints in some context. A term that lacks waypoints in all its contexts gets only one warning.
std::vector<config::Warning> idle_term_warnings(const TeamPlan& plan, const std::vector<bool>& idle,
                                                const std::vector<bool>& without_waypoints);

// --- Waypoints before the own goal. A filter that keeps the tasks nearest to waypoints leaves the defenders out where
// its positioner makes no waypoint there: it depends on the positioner's sites (docs/fidelity.md).

// Returns for each context in what share of made-up scenes a waypoint lies in the middle of the rear 5/18 of the field
// (x < -2 m and |y| < 2 m on a field of 9 m by 6 m). 1 for contexts whose filter does not go by waypoints.
std::vector<double> guarded_shares(const TeamPlan& plan, plugin::CallTracing tracing = {});

// Returns a warning for each positioner that makes such a waypoint in less than half of the scenes of a context.
std::vector<config::Warning> guard_warnings(const TeamPlan& plan, const std::vector<double>& shares);

// --- Segments that are too long for every packet. The search lets the whole team decide and exchange packets for the
// first 3 s after a made-up kick-off. It does not find too long segments that a plugin offers at another time.

struct UnsendableSegment {
  std::size_t part = 0;     // index of the plugin's first part in TeamPlan::parts()
  std::uint64_t bytes = 0;  // size of the longest refused segment, without its heading
};

// Returns the findings in the order of the parts.
std::vector<UnsendableSegment> unsendable_segments(const TeamPlan& plan, plugin::CallTracing tracing = {});

std::vector<config::Warning> unsendable_segment_warnings(const TeamPlan& plan,
                                                         const std::vector<UnsendableSegment>& found);

}  // namespace regista::mind
