// SPDX-License-Identifier: MIT
#include "mind/coordination/coordination.hpp"

#include <algorithm>
#include <cmath>

#include "mind/coordination/context_provider.hpp"
#include "mind/coordination/target.hpp"

namespace regista::mind {
namespace {

template <class T>
regista_span span(const std::vector<T>& elements) {
  return {elements.data(), static_cast<std::uint32_t>(elements.size()), sizeof(T)};
}

void place_task(regista_task& task, const config::TargetRule& rule, const Anchors& anchors) {
  const Vector2d point = target_of(rule, anchors);
  task.before[0] = task.after[0] = point.x();
  task.before[1] = task.after[1] = point.y();
}

// Of a task that has its place.
void face_task(regista_task& task, const config::TargetRule& rule, const Anchors& anchors) {
  const Vector2d facing = anchors.at(rule.facing) - Vector2d(task.before[0], task.before[1]);
  task.before[2] = task.after[2] = facing.isZero() ? 0.0 : angle_of(facing);
}

}  // namespace

Coordination::Coordination(const TeamPlan& plan, int own_number, std::vector<ContextParts> parts, FrameParts made)
    : plan_(&plan),
      own_number_(own_number),
      made_(made),
      parts_(std::move(parts)),
      filter_(plan.roles().size(), plugin::Positioner::point_capacity),
      matching_(plan.roles().size(), plugin::Positioner::point_capacity) {
  played_.reserve(static_cast<std::size_t>(plan.rules().team_size));
  wanting_.reserve(plan.roles().size());
  previous_.assign(static_cast<std::size_t>(plan.rules().team_size), REGISTA_NO_TASK);
  decision_.role_of = previous_;
  decision_.placement.points.reserve(plugin::Positioner::point_capacity);
  decision_.placement.edges.reserve(plugin::Positioner::edge_capacity);
}

const config::Context& Coordination::context() const {
  return plan_->team().contexts[static_cast<std::size_t>(decision_.context)];
}

// The world of a step; plugins called next see it as frame.world().
const DistributedWorldModel& Coordination::world_for(config::Knowledge knowledge, const Worlds& worlds) {
  decision_.frame.knowledge = raw(worlds.answering(knowledge));
  return worlds.of(knowledge);
}

// The rules let the task move to a waypoint.
bool Coordination::moves(const regista_task& task) const {
  return context().tasks.offset_at_most > 0.0 && plan_->roles()[static_cast<std::size_t>(task.id)].role->offset;
}

const Decision& Coordination::decide(const WorldModel& world, double time, std::uint64_t tick) {
  const Worlds worlds(world.mine(), world.common(), own_number_);
  begin(worlds, time, tick);
  decision_.context = decision_.frame.context = choose_context(plan_->team().contexts, parts_, worlds, decision_.frame);
  if (decision_.context < 0) {
    forget_roles();
    return decision_;
  }
  return decide_in_context(worlds);
}

const Decision& Coordination::decide_in(int context, const DistributedWorldModel& world, double time,
                                        std::uint64_t tick) {
  const Worlds worlds(world, world, own_number_);
  begin(worlds, time, tick);
  decision_.context = decision_.frame.context = context;
  return decide_in_context(worlds);
}

void Coordination::begin(const Worlds& worlds, double time, std::uint64_t tick) {
  regista_frame& frame = decision_.frame;
  // "Unknown" is an answer of an assigner, no task.
  std::ranges::transform(decision_.role_of, previous_.begin(), [](std::int32_t id) { return std::max(id, -1); });
  frame = {};
  frame.size = sizeof frame;
  frame.own_number = own_number_;
  frame.tick = tick;
  frame.time = time;
  frame.mine = &worlds.mine().raw;
  frame.common = &worlds.common().raw;
  frame.previous = span(previous_);
  frame.context = decision_.context;
}

const Decision& Coordination::decide_in_context(const Worlds& worlds) {
  const config::TaskRules& rules = context().tasks;
  listed_in_.reset();
  world_for(rules.waypoints_knowledge, worlds);
  list_tasks(worlds, rules.waypoints_knowledge);
  place();
  list_tasks(worlds, rules.filter_knowledge);
  keep_tasks(worlds.of(rules.filter_knowledge));
  place_kept_tasks(worlds, rules.knowledge);
  offset_tasks();

  const DistributedWorldModel& utility_world = world_for(context().utility_knowledge, worlds);
  estimate_times(utility_world);
  estimate_utilities(utility_world);
  assign(utility_world);
  take_own_role();
  return decision_;
}

void Coordination::list_tasks(const Worlds& worlds, config::Knowledge knowledge) {
  if (listed_in_ == knowledge) return;
  listed_in_ = knowledge;
  const Anchors anchors(plan_->rules().field, plan_->rules().ball.rolling_deceleration, worlds.of(knowledge));
  const int list = context().role_list;
  decision_.tasks.clear();
  const auto& roles = plan_->team().role_lists[static_cast<std::size_t>(list)].roles;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const config::Role& role = roles[i];
    regista_task& task = decision_.tasks.emplace_back();
    task = {};
    task.id = plan_->first_role(list) + static_cast<int>(i);
    task.priority = static_cast<std::int32_t>(i);
    task.group = role.group;
    task.robot = role.robot;
    task.flags = (role.required ? std::uint32_t{REGISTA_TASK_REQUIRED} : 0u) |
                 (context().tasks.walk_along_edges ? std::uint32_t{REGISTA_TASK_ALONG_EDGES} : 0u);
    const config::TargetRule& rule = context().target_of(i, role);
    place_task(task, rule, anchors);
    if (made_.facings_of_all_tasks()) face_task(task, rule, anchors);
  }
  decision_.frame.tasks = span(decision_.tasks);
}

// Those that are kept are played where this world has them, and face what it has there.
void Coordination::place_kept_tasks(const Worlds& worlds, config::Knowledge knowledge) {
  const bool listed = listed_in_ == knowledge, face = made_.facings() && !(listed && made_.facings_of_all_tasks());
  if (listed && !face) return;
  const Anchors anchors(plan_->rules().field, plan_->rules().ball.rolling_deceleration, worlds.of(knowledge));
  for (const std::size_t index : decision_.kept) {
    regista_task& task = decision_.tasks[index];
    const RoleRow& row = plan_->roles()[static_cast<std::size_t>(task.id)];
    const config::TargetRule& rule = context().target_of(static_cast<std::size_t>(row.priority), *row.role);
    if (!listed) place_task(task, rule, anchors);
    if (face) face_task(task, rule, anchors);
  }
}

void Coordination::place() {
  auto& positioner = parts_[static_cast<std::size_t>(decision_.context)].positioner;
  if (positioner) {
    positioner->place(decision_.frame, decision_.placement);
  } else {
    forget_placement();
  }
}

void Coordination::forget_placement() {
  decision_.placement.points.clear();
  decision_.placement.edges.clear();
  decision_.placement.cells.clear();
  decision_.placement.vertices.clear();
}

void Coordination::keep_tasks(const DistributedWorldModel& world) {
  const config::TaskRules& rules = context().tasks;
  played_.clear();
  for (const int number : world.active) played_.push_back(world.robot(number).role);
  filter_.keep(decision_.tasks, decision_.placement.points, world.active, played_,
               {rules.hysteresis, rules.keep == config::TaskRules::Keep::all}, decision_.kept);
}

void Coordination::offset_tasks() {
  auto& waypoints = decision_.placement.points;
  wanting_.clear();
  for (const std::size_t index : decision_.kept) {
    if (moves(decision_.tasks[index])) wanting_.push_back(index);
  }
  matching_.match(decision_.tasks, wanting_, waypoints);
  decision_.columns.clear();
  for (const std::size_t index : decision_.kept) {
    regista_task& task = decision_.columns.emplace_back(decision_.tasks[index]);
    if (moves(task)) offset(task, static_cast<int>(index), waypoints, context().tasks.offset_at_most);
  }
  // From here on the frame's tasks are the kept ones, and waypoints name tasks by their place in the frame.
  for (regista_waypoint& waypoint : decision_.placement.points) {
    if (waypoint.task < 0) continue;
    const auto place = std::ranges::find(decision_.kept, static_cast<std::size_t>(waypoint.task));
    waypoint.task = place == decision_.kept.end() ? -1 : static_cast<std::int32_t>(place - decision_.kept.begin());
  }
  decision_.frame.tasks = span(decision_.columns);
  decision_.frame.waypoints = span(waypoints);
  decision_.frame.edges = span(decision_.placement.edges);
}

// Straight walk at full speed, once the robot stands. Turning is left out: it takes a second at most, and is what the
// bearing term of a utility weighs.
void Coordination::estimate_times(const DistributedWorldModel& world) {
  if (!made_.times()) return;
  const std::size_t rows = world.active.size(), columns = decision_.columns.size();
  const double slowness = 1.0 / plan_->robot().walk.forward;
  decision_.time_to_task.resize(rows * columns);
  for (std::size_t i = 0; i < rows; ++i) {
    const regista_robot& robot = world.robot(world.active[i]);
    for (std::size_t j = 0; j < columns; ++j) {
      const double dx = decision_.columns[j].after[0] - robot.pose[0];
      const double dy = decision_.columns[j].after[1] - robot.pose[1];
      decision_.time_to_task[i * columns + j] = robot.time_until_up + slowness * std::sqrt(dx * dx + dy * dy);
    }
  }
  decision_.frame.time_to_task = matrix(decision_.time_to_task, rows, columns);
}

void Coordination::estimate_utilities(const DistributedWorldModel& world) {
  const auto context = static_cast<std::size_t>(decision_.context);
  decision_.utility.estimate(parts_[context].terms, plan_->contexts()[context].terms, decision_.frame, world.active,
                             decision_.columns);
}

void Coordination::assign(const DistributedWorldModel& world) {
  const std::size_t rows = world.active.size(), columns = decision_.columns.size();
  decision_.assigned.assign(rows, REGISTA_NO_TASK);
  parts_[static_cast<std::size_t>(decision_.context)].assigner.assign(
      decision_.frame, decision_.utility.view(rows, columns), decision_.assigned);
  std::ranges::fill(decision_.role_of, REGISTA_NO_TASK);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::int32_t column = decision_.assigned[i];
    decision_.role_of[static_cast<std::size_t>(world.active[i] - 1)] =
        column >= 0 ? decision_.columns[static_cast<std::size_t>(column)].id : column;
  }
}

void Coordination::take_own_role() {
  int role = decision_.role_of[static_cast<std::size_t>(own_number_ - 1)];
  // While the others have not agreed, the robot goes on with what it does, if that still exists.
  if (role == REGISTA_UNKNOWN_TASK) role = decision_.own_role;
  decision_.own_task = nullptr;
  for (regista_task& task : decision_.columns) {
    if (task.id != role) continue;
    decision_.own_task = &task;
    if (moves(task)) offset_to_own(task, own_number_, decision_.placement.points, context().tasks.offset_at_most);
  }
  if (decision_.own_task == nullptr) role = -1;
  if (role != decision_.own_role) {
    decision_.own_role = role;
    decision_.own_role_since = decision_.frame.time;
  }
}

void Coordination::forget_roles() {
  decision_.tasks.clear();
  forget_placement();
  decision_.kept.clear();
  decision_.columns.clear();
  decision_.assigned.clear();
  decision_.utility.clear();
  std::ranges::fill(decision_.role_of, REGISTA_NO_TASK);
  take_own_role();
}

}  // namespace regista::mind
