// SPDX-License-Identifier: MIT
// The values of a team's document: plugins, contexts, roles, weights. Plugins are named here, but not opened. Their
// parameters stay YAML until host/plugin reads them. The coordination method is from Affinita et al., "Multi-Agent
// Coordination for a Partially Observable and Dynamic Robot Soccer Environment with Limited Communication", 2023.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.hpp"
#include "config/scalar.hpp"

namespace regista::config {

// --- Points of the field in a team's document: an anchor ("ball", "own_left_post") or coordinates [x, y] in metres of
// the field frame (origin in the centre, x towards the opponent's goal, y to the left).

enum class Anchor {
  ball,
  ball_rest,
  own_goal,
  opponent_goal,
  own_left_post,
  own_right_post,
  centre,
  own_penalty_mark,
  opponent_penalty_mark,
  point,
};

struct Place {
  Anchor anchor = Anchor::centre;
  std::array<double, 2> point{};  // only for the anchor `point`
};

// Returns the names of all anchors except `point`, in the order of the enumeration.
std::span<const std::string> anchor_names();

// Reads `ball` or [x, y]. Throws Error at the node, "what: reason".
Place to_place(const Node& node, std::string_view what);

// Writes a place in the form that to_place() reads.
Node written(const Place& place);

inline constexpr Range coordinates{-100.0, 100.0};  // m, range of the coordinates of a point

// A plugin in a team's document: `{plugin: greedy, file: old/greedy.so, params: {...}}`
struct PluginUse {
  std::string plugin;  // id; empty only for the positioner of a team without waypoints
  std::string file;    // absolute path of a pinned shared object; empty: the plugin search chooses
  Node params;         // map, or absent
  Location where;
};

// What a computation uses: the robot's own knowledge, or the common knowledge of all robots of the team.
enum class Knowledge { mine, common };

// The point on the segment from `from` to `to` at distance_from_to from `to`, m.
struct OnLine {
  Place from, to;
  double distance_from_to = 0.0;
};

// The point where the line from `from` to `towards` enters a circle around `centre`, m. The radius of the circle grows
// from least_radius to largest_radius as the distance of `from` grows from least_distance to largest_distance.
struct OnCircle {
  Place from, towards, centre;
  double least_radius = 0.8, largest_radius = 1.3;
  double least_distance = 1.0, largest_distance = 8.0;
};

// The rule for the place of a role: a point in the field frame, m. The members apply in the order of declaration.
struct TargetRule {
  using OnLine = config::OnLine;
  using OnCircle = config::OnCircle;

  // Exactly one of the next three members is set. It gives the first point, which the later members change.
  std::optional<Place> at;
  std::optional<OnLine> on_line;
  std::optional<OnCircle> on_circle;

  std::array<double, 2> shift{};  // added to the point, m
  std::optional<double> lateral;  // sets y to -sign(y of the ball) * lateral, m; > 0: the side opposite to the ball
  std::optional<std::array<double, 4>> within;  // limits x_min, x_max, y_min, y_max, m
  Place facing{Anchor::ball, {}};
  std::optional<Place> without_ball;  // replaces the point while no robot knows the ball
};

// A behaviour that roles may name. Its plugin chooses the actions of a robot with such a role.
struct Behaviour {
  std::string name;
  PluginUse use;  // default: the plugin with this name
};

constexpr int most_shirt_number = 99;

struct Role {
  std::string name;
  // Shirt numbers. The first of these robots that is active may take the role, and no other robot. Empty: any robot.
  std::vector<int> robots;
  int least_in_play = 1;  // the role is open only while at least this many robots of the team are not penalised
  bool required = false;
  bool offset = true;  // true: the role's place may move towards a waypoint
  int group = -1;      // a robot takes at most one role of a group; -1: no group
  // Name of the behaviour. The default is play_ball if the target is the ball without `shift` and `lateral`, otherwise
  // keep_goal for the role `goalkeeper`, otherwise support.
  std::string behaviour = "support";
  TargetRule target;
  Location where, behaviour_where;
};

struct RoleList {
  std::string name;
  std::vector<Role> roles;  // in order of importance; names are unique in this list only
};

struct UtilityTerm {
  std::string name;
  PluginUse use;
  double weight = 1.0;
  std::optional<std::array<double, 2>> tune;  // range of the weight for the tuner
};

struct TaskRules {
  enum class Keep { all, nearest_to_waypoints } keep = Keep::nearest_to_waypoints;
  double hysteresis = 0.0;      // m; a task that a robot plays counts as nearer to its waypoint by this distance
  double offset_at_most = 0.5;  // largest offset of a role's place, m; 0: no offset
  Knowledge knowledge = Knowledge::mine;  // knowledge for the placement of tasks
  // Knowledge for the positioner and for the choice of tasks. Default: `knowledge`.
  Knowledge waypoints_knowledge = Knowledge::mine, filter_knowledge = Knowledge::mine;
  bool walk_along_edges = false;
};

// The values that a context may change: the keys of `use:` except `roles` and `targets`.
struct Coordination {
  PluginUse positioner;  // empty plugin: no waypoints
  TaskRules tasks;
  Knowledge utility_knowledge = Knowledge::mine;
  std::vector<UtilityTerm> terms;
  PluginUse assigner, sender;
};

// A context. The values of Coordination are those of the team, with the context's `use:` laid over them.
struct Context : Coordination {
  std::string name;
  int priority = 0;
  PluginUse use;
  Knowledge knowledge = Knowledge::mine;  // knowledge for the condition of the context
  int role_list = 0;  // index into Team::role_lists, from `use: {roles: NAME}`; by default the first list
  // Targets by index of the role in the role list `role_list`. A missing element means the role's own target. Empty if
  // the context changes no target (`use: {targets: {ROLE: ...}}`).
  std::vector<std::optional<TargetRule>> targets;
  Location where;

  // Returns the target of `role`, which has the index `place` in the role list.
  const TargetRule& target_of(std::size_t place, const Role& role) const {
    return place < targets.size() && targets[place] ? *targets[place] : role.target;
  }

  // Returns whether any computation uses the common knowledge of the robots.
  bool uses_common() const {
    const auto any = {knowledge, tasks.knowledge, tasks.waypoints_knowledge, tasks.filter_knowledge, utility_knowledge};
    return std::ranges::find(any, Knowledge::common) != any.end();
  }
};

struct Team {
  std::string name;
  std::string title;                           // name for people, any text of one line; without a title the name
  std::string file;                            // path of the document
  PluginUse self, ball, opponents, teammates;  // predictors
  double forget_teammate_after = 25.0;         // s of silence until a robot forgets a teammate
  std::vector<RoleList> role_lists;
  std::vector<Behaviour> behaviours;  // behaviours with an entry in the document
  std::string behaviour_without_role = "search";
  std::vector<Context> contexts;  // highest priority first; the first context that holds is in force
  Location where, behaviour_without_role_where;

  // Returns the plugin of the behaviour `wanted`; without an entry in the document the plugin of this name, at `place`.
  PluginUse behaviour_named(const std::string& wanted, const Location& place) const {
    const auto found = std::ranges::find(behaviours, wanted, &Behaviour::name);
    return found == behaviours.end() ? PluginUse{wanted, "", {}, place} : found->use;
  }
};

}  // namespace regista::config
