// SPDX-License-Identifier: MIT
// A team as its YAML page says it: which plugins, which contexts, which roles, which weights. Values only; plugins are
// named, not opened (host/plugin does that), and their parameters stay located YAML until their declaration is known.
// The system is Affinita et al., "Multi-Agent Coordination for a Partially Observable and Dynamic Robot Soccer
// Environment with Limited Communication", 2023.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/place.hpp"

namespace regista::config {

// `{plugin: greedy, file: old/greedy.so, params: {...}}`
struct PluginUse {
  std::string plugin;  // id; empty only for the positioner of a team without waypoints
  std::string file;    // pinned shared object, absolute; empty: whatever the search finds
  Node params;         // map, or absent
  Location where;
};

enum class Knowledge { mine, common };

// On the segment between two places, so far from its second end. m
struct OnLine {
  Place from, to;
  double distance_from_to = 0.0;
};

// Where the line from `from` to `towards` enters a circle whose radius grows with the distance of `from`. m
struct OnCircle {
  Place from, towards, centre;
  double least_radius = 0.8, largest_radius = 1.3;
  double least_distance = 1.0, largest_distance = 8.0;  // of `from` from the centre, between which it grows
};

// Where a role is played, as data. Steps are applied from top to bottom; the result is a point of the field frame.
struct TargetRule {
  using OnLine = config::OnLine;
  using OnCircle = config::OnCircle;

  // Exactly one of the three gives the point to start from:
  std::optional<Place> at;
  std::optional<OnLine> on_line;
  std::optional<OnCircle> on_circle;

  std::array<double, 2> shift{};                // m
  std::optional<double> across;                 // then y := -sign(y of the ball) * across: the far side, if > 0
  std::optional<std::array<double, 4>> within;  // x_min, x_max, y_min, y_max
  Place facing{Anchor::ball, {}};
  std::optional<Place> without_ball;  // used instead while nobody knows the ball
};

// How roles act that name it.
struct Behaviour {
  std::string name;
  PluginUse use;  // unless the page says it, the plugin of that name
};

struct Role {
  std::string name;
  int robot = 0;  // shirt number that alone may take it; 0 = any
  bool required = false;
  bool offset = true;  // may be moved towards a waypoint
  int group = -1;      // at most one role of a group per robot; -1 = none
  // Name of a behaviour. Unless the page says it: play_ball for a target that is the unmoved ball, keep_goal for the
  // role named goalkeeper, support for all others.
  std::string behaviour = "support";
  TargetRule target;
  Location where, behaviour_where;
};

struct RoleList {
  std::string name;         // role names are unique in a list; the same name may stand in several lists
  std::vector<Role> roles;  // in order of importance
};

struct UtilityTerm {
  std::string name;
  PluginUse use;
  double weight = 1.0;
  std::optional<std::array<double, 2>> tune;  // range for the tuner
  Location where;
};

struct TaskRules {
  enum class Keep { all, nearest_to_waypoints } keep = Keep::nearest_to_waypoints;
  double hysteresis = 0.0;      // m: a task that a robot is said to play counts as so much nearer to the waypoints
  double offset_at_most = 0.5;  // m, 0 = off
  Knowledge knowledge = Knowledge::mine;  // that tasks are placed in
  // That the positioner sees and that tasks are chosen in; unless the page says it, as `knowledge`.
  Knowledge waypoints_knowledge = Knowledge::mine, filter_knowledge = Knowledge::mine;
  bool walk_along_edges = false;
};

// What is in force while a context holds. The values are the team's own with the context's `use:` laid over.
struct Context {
  std::string name;
  int priority = 0;
  PluginUse use;
  Knowledge knowledge = Knowledge::mine;  // that the condition is asked about
  int role_list = 0;                      // index into Team::role_lists; `use: {roles: NAME}`, else the first
  // By place in that list; nothing: the role's own. Empty when it moves none (`use: {targets: {ROLE: ...}}`).
  std::vector<std::optional<TargetRule>> targets;
  PluginUse positioner;
  TaskRules tasks;
  Knowledge utility_knowledge = Knowledge::mine;
  std::vector<UtilityTerm> terms;
  PluginUse assigner;
  PluginUse sender;
  Location where;

  // Where the role at this place of the list is played.
  const TargetRule& target_of(std::size_t place, const Role& role) const {
    return place < targets.size() && targets[place] ? *targets[place] : role.target;
  }

  // Something in it is computed on what all robots know.
  bool uses_common() const {
    const auto any = {knowledge, tasks.knowledge, tasks.waypoints_knowledge, tasks.filter_knowledge, utility_knowledge};
    return std::find(any.begin(), any.end(), Knowledge::common) != any.end();
  }
};

struct Team {
  std::string name;
  std::string file;                            // where it was read
  PluginUse self, ball, opponents, teammates;  // predictors
  double forget_teammate_after = 25.0;         // s of silence until a teammate is given up
  std::vector<RoleList> role_lists;
  std::vector<Behaviour> behaviours;  // those that the page says something of
  std::string behaviour_without_role = "search";
  std::vector<Context> contexts;  // highest priority first; the first that holds is in force
  Location where, behaviour_without_role_where;

  // What is meant by the name of a behaviour. `where`: it was written there.
  PluginUse behaviour_named(const std::string& wanted, const Location& place) const {
    for (const Behaviour& each : behaviours) {
      if (each.name == wanted) return each.use;
    }
    return {wanted, "", {}, place};
  }
};

}  // namespace regista::config
