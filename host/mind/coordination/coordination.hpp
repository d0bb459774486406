// SPDX-License-Identifier: MIT
// Coordination runs the pipeline of the paper (Affinita et al. 2023) in every robot: context -> tasks -> V (waypoints)
// -> filter and offset of tasks -> utility estimation matrix -> Phi (the assignment of tasks to robots). See Decision.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "config/rules.hpp"
#include "config/team.hpp"
#include "mind/coordination/task_filter.hpp"
#include "mind/percepts.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/world_model.hpp"
#include "plugin/kinds.hpp"
#include "regista/abi.h"

namespace regista::mind {

// Computes the points that a team's rules can name (config::Place), such as the ball, from one world. Field frame.
class NamedPoints {
 public:
  // `rolling_deceleration`: deceleration of the rolling ball, m/s^2; gives the point where the ball will come to rest.
  NamedPoints(const config::FieldSize& field, double rolling_deceleration, const DistributedWorldModel& world);
  bool ball_known() const { return ball_known_; }
  Vector2d at(const config::Place& place) const {
    if (place.anchor == config::Anchor::point) return {place.point[0], place.point[1]};
    return anchors_[static_cast<std::size_t>(place.anchor)];
  }

 private:
  bool ball_known_;
  std::array<Vector2d, static_cast<std::size_t>(config::Anchor::point)> anchors_;
};

// Returns the position that a rule of the team's document gives to a task.
Vector2d target_of(const config::TargetRule& rule, const NamedPoints& points);

// Returns a view of rows x columns values, stored row by row, as a matrix for plugins.
inline regista_matrix matrix(const std::vector<double>& values, std::size_t rows, std::size_t columns) {
  return {values.data(), static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
          static_cast<std::uint32_t>(columns), 0};
}

// The paper's Utility Estimation Matrix (UEM). An entry says how well an active robot (the row) would play a kept task
// (the column). The entry is the weighted sum of the values of the context's utility plugins; minus infinity: the robot
// must not take the task. The paper filters columns of the full matrix; Regista filters tasks earlier, to save time.
class UtilityEstimationMatrix {
 public:
  static constexpr double forbidden = -std::numeric_limits<double>::infinity();

  // Calls every plugin with `frame` and computes the matrix. active, columns: robots and tasks of the frame. plugins[k]
  // belongs to terms[k]. A task that is bound to a robot is forbidden to others, and other tasks to this robot.
  void estimate(std::span<plugin::Utility> plugins, std::span<const TermPart> terms, const regista_frame& frame,
                std::span<const std::int32_t> active, std::span<const regista_task> columns);
  void clear() { values_.clear(); }
  // Makes room for so many entries of so many plugins, so that a change of context allocates nothing.
  void reserve(std::size_t entries, std::size_t plugins);

  const std::vector<double>& values() const { return values_; }  // rows x columns
  // By plugin: rows x columns, without weight.
  std::span<const std::vector<double>> terms() const { return std::span(terms_).first(count_); }

 private:
  void forbid(std::span<const std::int32_t> active, std::span<const regista_task> columns);

  std::vector<double> values_;
  std::vector<std::vector<double>> terms_;  // the first count_ are of the latest frame
  std::size_t count_ = 0;
};

struct ContextParts {  // The plugin instances of one context in one robot's mind.
  plugin::Context condition;
  std::optional<plugin::Positioner> positioner;
  std::vector<plugin::Utility> terms;
  plugin::Assigner assigner;
  plugin::Sender sender;
};

// The two worlds of one decision (world_model.hpp: `mine` is what this robot knows, `common` what packets told all
// robots), and the choice of a world for each step. The common world may count this robot as inactive, for example if
// it has sent nothing for Team::forget_teammate_after. So that it gets a task, every step then uses the world `mine`.
class Worlds {
 public:
  Worlds(const DistributedWorldModel& mine, const DistributedWorldModel& common, int own_number)
      : mine_(&mine), common_(&common), speaks_for_self_(common.is_active(own_number) || !mine.is_active(own_number)) {}

  // Returns the world that a step uses if the team's document asks for `asked`.
  config::Knowledge answering(config::Knowledge asked) const {
    return speaks_for_self_ ? asked : config::Knowledge::mine;
  }
  const DistributedWorldModel& of(config::Knowledge asked) const {
    return answering(asked) == config::Knowledge::common ? *common_ : *mine_;
  }
  const DistributedWorldModel& mine() const { return *mine_; }
  const DistributedWorldModel& common() const { return *common_; }

 private:
  const DistributedWorldModel *mine_, *common_;
  bool speaks_for_self_;  // false: each step uses `mine`
};

// The results of all steps of one robot's decision, for later steps and recorders. Valid until the next decision.
struct Decision {
  // The frame as the last step left it, for the sender plugin: `frame.knowledge` names the world in which the utilities
  // were estimated. The spans point into Decision and the world model.
  regista_frame frame{};
  int context = -1;                    // index into Team::contexts; -1: no context's condition holds
  std::vector<regista_task> tasks;     // M: all tasks of the context
  plugin::Placement placement;         // V; waypoints name tasks by index in `columns`
  std::vector<std::size_t> kept;       // indices of the kept tasks in `tasks`, ascending
  std::vector<regista_task> columns;   // N: kept tasks, moved towards their waypoints
  std::vector<double> time_to_task;    // rows x columns: time of a robot to a task, s
  UtilityEstimationMatrix utility;     // rows x columns
  std::vector<std::int32_t> assigned;  // Phi: by row, a column, REGISTA_NO_TASK or REGISTA_UNKNOWN_TASK
  std::vector<std::int32_t> role_of;   // by robot (n - 1): row of the table of roles; -1: none; -2: unknown
  int own_role = -1;
  double own_role_since = 0.0;             // match time at which this robot took the role, s
  const regista_task* own_task = nullptr;  // this robot's entry of `columns`, or null

  std::size_t rows() const { return assigned.size(); }  // number of active robots
};

class Coordination {
 public:
  // `parts` must be in the order of TeamPlan::contexts(). `made`: the frame parts to compute.
  Coordination(const TeamPlan& plan, int own_number, std::vector<ContextParts> parts, FrameParts made);

  const Decision& decide(const WorldModel& world, double time, std::uint64_t tick);
  // Decides in a made-up scene: the given context is in force, and `world` is both world `mine` and world `common`.
  const Decision& decide_in(int context, const DistributedWorldModel& world, double time, std::uint64_t tick);

  const Decision& decision() const { return decision_; }
  // Returns the frame of the last decision; null if no decision has been made.
  const regista_frame* last_frame() const { return decision_.frame.size != 0 ? &decision_.frame : nullptr; }
  plugin::Sender& sender() { return parts_[static_cast<std::size_t>(decision_.context)].sender; }
  // Must be called when the robot has left the game. The next decision then keeps no role from earlier decisions.
  void forget_roles();

 private:
  const config::Context& context() const;
  const DistributedWorldModel& world_for(config::Knowledge knowledge, const Worlds& worlds);
  bool moves(const regista_task& task) const;
  void begin(const Worlds& worlds, double time, std::uint64_t tick);
  const Decision& decide_in_context(const Worlds& worlds);
  void list_tasks(const Worlds& worlds, config::Knowledge knowledge);
  void place_kept_tasks(const Worlds& worlds, config::Knowledge knowledge);
  void forget_placement();
  void keep_tasks(const DistributedWorldModel& world);
  void offset_tasks();
  void estimate_times(const DistributedWorldModel& world);
  void assign(const DistributedWorldModel& world);
  void take_own_role();

  const TeamPlan* plan_;
  int own_number_;
  FrameParts made_;
  std::vector<ContextParts> parts_;
  TaskFilter filter_;
  WaypointMatching matching_;
  std::vector<std::int32_t> played_;            // task ids that active robots play; -1: no task
  std::vector<std::size_t> wanting_;            // indices of kept tasks that move to a waypoint
  std::optional<config::Knowledge> listed_in_;  // world that gave the places of `tasks`; empty: no list yet
  Decision decision_;
  std::vector<std::int32_t> previous_;  // Decision::role_of of the previous decision
};

// The paper's Context Provider: returns the index of the context with the highest priority whose condition holds; -1 if
// no condition holds. `contexts` and `parts` have equal length; the highest priority comes first. Calls every
// condition, because conditions may have a memory. Sets `frame.knowledge` to the world that each context names.
int choose_context(std::span<const config::Context> contexts, std::span<ContextParts> parts, const Worlds& worlds,
                   regista_frame& frame);

// Returns the value of `knowledge` for regista_frame::knowledge.
inline std::int32_t raw(config::Knowledge knowledge) {
  return static_cast<std::int32_t>(knowledge == config::Knowledge::common ? REGISTA_COMMON : REGISTA_MINE);
}

// Detects the events e of Affinita et al. 2023: what happened to this robot since its last decision and may interest
// its teammates. The sender plugin decides whether an event is worth a packet, which has a Report, not the event.
class EventDetector {
 public:
  explicit EventDetector(int own_number) : own_number_(own_number) {}

  // Fills `out` with the events since the last call, once a decision. `searching`: the own role looks for the ball.
  void detect(const Percepts& percepts, const WorldModel& world, const Decision& decision, bool searching,
              std::vector<regista_event>& out);

 private:
  int own_number_;
  bool first_ = true;
  int role_ = -1, context_ = -1, phase_ = 0;
  bool fallen_ = false, penalised_ = false, searching_ = false;
  double ball_seen_at_ = 0.0, team_ball_seen_at_ = 0.0;
};

}  // namespace regista::mind
