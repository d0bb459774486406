// SPDX-License-Identifier: MIT
// The paper's pipeline (Affinita et al. 2023), run by every robot alone: context -> tasks -> V -> filter and offset ->
// utility estimation matrix -> Phi. A straight line of steps, each of which fills its part of the Decision.
#pragma once

#include <optional>
#include <vector>

#include "mind/coordination/context_parts.hpp"
#include "mind/coordination/decision.hpp"
#include "mind/coordination/task_filter.hpp"
#include "mind/coordination/waypoint_matching.hpp"
#include "mind/coordination/worlds.hpp"
#include "mind/frame_parts.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/world_model.hpp"

namespace regista::mind {

class Coordination {
 public:
  // `parts` in the order of the team's contexts.
  Coordination(const TeamPlan& plan, int own_number, std::vector<ContextParts> parts, FrameParts made);

  const Decision& decide(const WorldModel& world, double time, std::uint64_t tick);
  // As if this context held, and all that the robot believes were common: for scenes that are made up.
  const Decision& decide_in(int context, const DistributedWorldModel& world, double time, std::uint64_t tick);

  const Decision& decision() const { return decision_; }
  // The frame of the last decision, null before the first.
  const regista_frame* last_frame() const { return decision_.frame.size != 0 ? &decision_.frame : nullptr; }
  plugin::Sender& sender() { return parts_[static_cast<std::size_t>(decision_.context)].sender; }
  // Nothing is assigned any more: the robot left the game, or no context holds.
  void forget_roles();

 private:
  const config::Context& context() const;
  const DistributedWorldModel& world_for(config::Knowledge knowledge, const Worlds& worlds);
  bool moves(const regista_task& task) const;
  void begin(const Worlds& worlds, double time, std::uint64_t tick);
  const Decision& decide_in_context(const Worlds& worlds);
  void list_tasks(const Worlds& worlds, config::Knowledge knowledge);
  void place_kept_tasks(const Worlds& worlds, config::Knowledge knowledge);
  void place();
  void forget_placement();
  void keep_tasks(const DistributedWorldModel& world);
  void offset_tasks();
  void estimate_times(const DistributedWorldModel& world);
  void estimate_utilities(const DistributedWorldModel& world);
  void assign(const DistributedWorldModel& world);
  void take_own_role();

  const TeamPlan* plan_;
  int own_number_;
  FrameParts made_;
  std::vector<ContextParts> parts_;
  TaskFilter filter_;
  WaypointMatching matching_;
  std::vector<std::int32_t> played_;            // ids of tasks, -1 for none
  std::vector<std::size_t> wanting_;            // kept tasks that move to a waypoint
  std::optional<config::Knowledge> listed_in_;  // world asked for the tasks of this decision, once they are listed
  Decision decision_;
  std::vector<std::int32_t> previous_;  // role_of, one decision ago
};

}  // namespace regista::mind
