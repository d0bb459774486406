// SPDX-License-Identifier: MIT
#include "mind/coordination/coordination.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace regista::mind {
namespace {

// Returns the point on the line from `from` to `to` that is `distance` before `to`; `from` if the line is shorter.
Vector2d on_line(const Vector2d& from, const Vector2d& to, double distance) {
  const Vector2d back = from - to;
  const double length = back.norm();
  return length <= distance ? from : Vector2d(to + back * (distance / length));
}

// Returns the point where the ray from `from` through `towards` first meets the circle. If the ray misses the circle,
// returns the circle's point nearest to `from`. If `from` is inside the circle, returns the circle's point between the
// directions of `from` and `towards`, so that rules with different `towards` give different points.
Vector2d on_circle(const Vector2d& from, const Vector2d& towards, const Vector2d& centre, double radius) {
  const Vector2d out = from - centre;
  const double distance = out.norm();
  const Vector2d fallback = distance > 0.0 ? Vector2d(centre + out * (radius / distance)) : from;
  if (distance <= radius) {
    const Vector2d side = out + (towards - centre);
    return side.norm() > 0.0 ? Vector2d(centre + side.normalized() * radius) : fallback;
  }
  const Vector2d along = towards - from;
  const double a = along.squaredNorm(), b = out.dot(along), c = out.squaredNorm() - radius * radius;
  const double discriminant = b * b - a * c;
  if (a == 0.0 || discriminant < 0.0) return fallback;
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t >= 0.0 ? Vector2d(from + t * along) : fallback;
}

constexpr std::int32_t nobody = -1;  // regista_task::robot of a role that no robot may take now

// Returns regista_task::robot of a role: the robot that alone may take it now, 0 if any robot may. The number of robots
// in play comes from the referee, so a robot that hears nobody still knows that it is not alone.
std::int32_t only_robot(const config::Role& role, const DistributedWorldModel& world) {
  const auto in_play = [](const regista_robot& each) { return (each.flags & REGISTA_ROBOT_PENALISED) == 0; };
  if (role.least_in_play > 1 && std::ranges::count_if(world.robots, in_play) < role.least_in_play) return nobody;
  if (role.robots.empty()) return 0;
  const auto chosen = std::ranges::find_first_of(role.robots, world.active);
  return chosen == role.robots.end() ? role.robots.front() : *chosen;
}

// sum += weight * term. __restrict says that the arrays do not overlap, so the compiler can add two entries at once.
void add(double weight, std::span<const double> term, std::span<double> sum) {
  const double* const __restrict from = term.data();
  double* const __restrict to = sum.data();
  for (std::size_t i = 0; i < term.size(); ++i) to[i] += weight * from[i];
}

void place_task(regista_task& task, const config::TargetRule& rule, const NamedPoints& points) {
  const Vector2d point = target_of(rule, points);
  task.before[0] = task.after[0] = point.x();
  task.before[1] = task.after[1] = point.y();
}

// Turns the task's heading towards the place that the rule names. The task's position must already be set.
void face_task(regista_task& task, const config::TargetRule& rule, const NamedPoints& points) {
  const Vector2d facing = points.at(rule.facing) - Vector2d(task.before[0], task.before[1]);
  task.before[2] = task.after[2] = facing.isZero() ? 0.0 : angle_of(facing);
}

// A smaller move of the ball or of the robot may be noise of sensing, so it is not an event.
constexpr double ball_moved_at_least = 0.3, pose_moved_at_least = 0.2;  // m
// The ball counts as found again only if the robot had not seen it for this time or longer.
constexpr double ball_missed_at_least = 1.0;  // s
constexpr int goalkeeper = 1;                 // shirt number; the rules number the goalkeeper 1

}  // namespace

NamedPoints::NamedPoints(const config::FieldSize& field, double rolling_deceleration,
                         const DistributedWorldModel& world)
    : ball_known_(world.ball_known()) {
  const Vector2d ball = world.ball(), velocity = world.ball_velocity();
  const Vector2d rolled = ball + velocity * (velocity.norm() / (2.0 * rolling_deceleration));
  // A ball that leaves the field is put back on the line.
  const Vector2d corner(field.length / 2.0, field.width / 2.0);
  const Vector2d rest = rolled.cwiseMin(corner).cwiseMax(-corner);
  const double goal = field.length / 2.0, mark = goal - field.penalty_mark_distance, post = field.goal_width / 2.0;
  const auto at = [](double x, double y) { return Vector2d(x, y); };
  // In the order of config::Anchor: ball, ball at rest, goals, own posts, centre, penalty marks.
  anchors_ = {ball,         rest,           at(-goal, 0.0), at(goal, 0.0), at(-goal, post), at(-goal, -post),
              at(0.0, 0.0), at(-mark, 0.0), at(mark, 0.0)};
}

Vector2d target_of(const config::TargetRule& rule, const NamedPoints& points) {
  if (!points.ball_known() && rule.without_ball) return points.at(*rule.without_ball);
  Vector2d point;
  if (rule.on_line) {
    point = on_line(points.at(rule.on_line->from), points.at(rule.on_line->to), rule.on_line->distance_from_to);
  } else if (rule.on_circle) {
    const auto& circle = *rule.on_circle;
    const Vector2d from = points.at(circle.from), centre = points.at(circle.centre);
    const double span = circle.largest_distance - circle.least_distance;
    const double share =
        span > 0.0 ? std::clamp(((from - centre).norm() - circle.least_distance) / span, 0.0, 1.0) : 0.0;
    point = on_circle(from, points.at(circle.towards), centre,
                      circle.least_radius + share * (circle.largest_radius - circle.least_radius));
  } else {
    point = points.at(rule.at.value_or(config::Place{}));
  }
  double x = point.x() + rule.shift[0], y = point.y() + rule.shift[1];
  if (rule.lateral) {
    const double ball_y = points.at({config::Anchor::ball, {}}).y();
    y = ball_y >= 0.0 ? -*rule.lateral : *rule.lateral;
  }
  if (rule.within) {
    const auto& [x_min, x_max, y_min, y_max] = *rule.within;
    x = std::clamp(x, x_min, x_max);
    y = std::clamp(y, y_min, y_max);
  }
  return {x, y};
}

void UtilityEstimationMatrix::estimate(std::span<plugin::Utility> plugins, std::span<const TermPart> terms,
                                       const regista_frame& frame, std::span<const std::int32_t> active,
                                       std::span<const regista_task> columns) {
  assert(plugins.size() == terms.size());
  const std::size_t entries = active.size() * columns.size();
  values_.assign(entries, 0.0);
  count_ = plugins.size();
  if (terms_.size() < count_) terms_.resize(count_);
  for (std::size_t k = 0; k < plugins.size(); ++k) {
    const std::span<const double> scored = plugins[k].score(frame, active.size(), columns.size());
    terms_[k].assign(scored.begin(), scored.end());
    add(terms[k].weight, scored, values_);
  }
  forbid(active, columns);
}

void UtilityEstimationMatrix::reserve(std::size_t entries, std::size_t plugins) {
  values_.reserve(entries);
  terms_.resize(plugins);
  for (std::vector<double>& each : terms_) each.reserve(entries);
}

void UtilityEstimationMatrix::forbid(std::span<const std::int32_t> active, std::span<const regista_task> columns) {
  for (std::size_t j = 0; j < columns.size(); ++j) {
    const int bound = columns[j].robot;
    if (bound == 0) continue;
    for (std::size_t i = 0; i < active.size(); ++i) {
      double* const row = values_.data() + i * columns.size();
      if (active[i] != bound) {
        row[j] = forbidden;
        continue;
      }
      for (std::size_t other = 0; other < columns.size(); ++other) {
        if (columns[other].robot != bound) row[other] = forbidden;
      }
    }
  }
}

Coordination::Coordination(const TeamPlan& plan, int own_number, std::vector<ContextParts> parts, FrameParts made)
    : plan_(&plan),
      own_number_(own_number),
      made_(made),
      parts_(std::move(parts)),
      filter_(plan.roles().size(), plugin::Positioner::point_capacity),
      matching_(plan.roles().size(), plugin::Positioner::point_capacity) {
  played_.reserve(static_cast<std::size_t>(plan.rules().team_size));
  wanting_.reserve(plan.roles().size());
  std::size_t terms = 0;
  for (const ContextPlan& context : plan.contexts()) terms = std::max(terms, context.terms.size());
  decision_.utility.reserve(static_cast<std::size_t>(plan.rules().team_size) * plan.roles().size(), terms);
  previous_.assign(static_cast<std::size_t>(plan.rules().team_size), REGISTA_NO_TASK);
  decision_.role_of = previous_;
  decision_.placement.points.reserve(plugin::Positioner::point_capacity);
  decision_.placement.edges.reserve(plugin::Positioner::edge_capacity);
}

const config::Context& Coordination::context() const {
  return plan_->team().contexts[static_cast<std::size_t>(decision_.context)];
}

// Returns the world of a step, and makes it frame.world() for the plugins of this step.
const DistributedWorldModel& Coordination::world_for(config::Knowledge knowledge, const Worlds& worlds) {
  decision_.frame.knowledge = raw(worlds.answering(knowledge));
  return worlds.of(knowledge);
}

// Returns whether the team's document allows that the task moves to a waypoint.
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
  // REGISTA_UNKNOWN_TASK becomes -1, because an unknown task is not a previous task.
  std::ranges::transform(decision_.role_of, previous_.begin(), [](std::int32_t id) { return std::max(id, -1); });
  frame = {};
  frame.size = sizeof frame;
  frame.own_number = own_number_;
  frame.tick = tick;
  frame.time = time;
  frame.mine = &worlds.mine().raw;
  frame.common = &worlds.common().raw;
  frame.previous = abi_span(previous_);
  frame.context = decision_.context;
}

const Decision& Coordination::decide_in_context(const Worlds& worlds) {
  const config::TaskRules& rules = context().tasks;
  listed_in_.reset();
  world_for(rules.waypoints_knowledge, worlds);
  list_tasks(worlds, rules.waypoints_knowledge);
  const auto index = static_cast<std::size_t>(decision_.context);
  if (auto& positioner = parts_[index].positioner) {
    positioner->place(decision_.frame, decision_.placement);
  } else {
    forget_placement();
  }
  list_tasks(worlds, rules.filter_knowledge);
  keep_tasks(worlds.of(rules.filter_knowledge));
  place_kept_tasks(worlds, rules.knowledge);
  offset_tasks();

  const DistributedWorldModel& utility_world = world_for(context().utility_knowledge, worlds);
  estimate_times(utility_world);
  decision_.utility.estimate(parts_[index].terms, plan_->contexts()[index].terms, decision_.frame, utility_world.active,
                             decision_.columns);
  assign(utility_world);
  take_own_role();
  return decision_;
}

void Coordination::list_tasks(const Worlds& worlds, config::Knowledge knowledge) {
  if (listed_in_ == knowledge) return;
  listed_in_ = knowledge;
  const DistributedWorldModel& world = worlds.of(knowledge);
  const NamedPoints points(plan_->rules().field, plan_->rules().ball.rolling_deceleration, world);
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
    task.robot = only_robot(role, world);
    task.flags = (role.required ? std::uint32_t{REGISTA_TASK_REQUIRED} : 0u) |
                 (context().tasks.walk_along_edges ? std::uint32_t{REGISTA_TASK_ALONG_EDGES} : 0u);
    const config::TargetRule& rule = context().target_of(i, role);
    place_task(task, rule, points);
    if (made_.facings_of_all_tasks) face_task(task, rule, points);
  }
  decision_.frame.tasks = abi_span(decision_.tasks);
}

void Coordination::place_kept_tasks(const Worlds& worlds, config::Knowledge knowledge) {
  const bool listed = listed_in_ == knowledge, face = made_.facings && !(listed && made_.facings_of_all_tasks);
  if (listed && !face) return;
  const NamedPoints points(plan_->rules().field, plan_->rules().ball.rolling_deceleration, worlds.of(knowledge));
  for (const std::size_t index : decision_.kept) {
    regista_task& task = decision_.tasks[index];
    const RoleRow& row = plan_->roles()[static_cast<std::size_t>(task.id)];
    const config::TargetRule& rule = context().target_of(static_cast<std::size_t>(row.priority), *row.role);
    if (!listed) place_task(task, rule, points);
    if (face) face_task(task, rule, points);
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
  // The frame's tasks become the kept tasks. Waypoints must therefore name tasks by index in `columns`, not in `tasks`.
  for (regista_waypoint& waypoint : decision_.placement.points) {
    if (waypoint.task < 0) continue;
    const auto place = std::ranges::find(decision_.kept, static_cast<std::size_t>(waypoint.task));
    waypoint.task = place == decision_.kept.end() ? -1 : static_cast<std::int32_t>(place - decision_.kept.begin());
  }
  decision_.frame.tasks = abi_span(decision_.columns);
  decision_.frame.waypoints = abi_span(waypoints);
  decision_.frame.edges = abi_span(decision_.placement.edges);
}

// Computes for each robot and task the time of a straight walk at full speed, plus the time until the robot stands.
// Ignores turning, because a turn takes at most one second and a bearing term of the utility can weigh turning.
void Coordination::estimate_times(const DistributedWorldModel& world) {
  if (!made_.times) return;
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

void Coordination::assign(const DistributedWorldModel& world) {
  const std::size_t rows = world.active.size(), columns = decision_.columns.size();
  decision_.assigned.assign(rows, REGISTA_NO_TASK);
  parts_[static_cast<std::size_t>(decision_.context)].assigner.assign(
      decision_.frame, matrix(decision_.utility.values(), rows, columns), decision_.assigned);
  std::ranges::fill(decision_.role_of, REGISTA_NO_TASK);
  for (std::size_t i = 0; i < rows; ++i) {
    const std::int32_t column = decision_.assigned[i];
    decision_.role_of[static_cast<std::size_t>(world.active[i] - 1)] =
        column >= 0 ? decision_.columns[static_cast<std::size_t>(column)].id : column;
  }
}

void Coordination::take_own_role() {
  int role = decision_.role_of[static_cast<std::size_t>(own_number_ - 1)];
  // While the assignment is unknown, the robot keeps its role, if the role's task is among the kept tasks.
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

int choose_context(std::span<const config::Context> contexts, std::span<ContextParts> parts, const Worlds& worlds,
                   regista_frame& frame) {
  assert(contexts.size() == parts.size());
  int chosen = -1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    frame.knowledge = raw(worlds.answering(contexts[i].knowledge));
    if (parts[i].condition.holds(frame) && chosen < 0) chosen = static_cast<int>(i);
  }
  return chosen;
}

void EventDetector::detect(const Percepts& percepts, const WorldModel& world, const Decision& decision, bool searching,
                           std::vector<regista_event>& out) {
  out.clear();
  const auto add = [&out](int kind, double value) { out.push_back({kind, 0, value}); };
  const DistributedWorldModel& mine = world.mine();
  const DistributedWorldModel& common = world.common();
  const double now = percepts.time;

  if (common.ball_known()) team_ball_seen_at_ = now - common.ball_state.age;
  if (percepts.whistle) add(REGISTA_EVENT_WHISTLE, 0.0);
  if (world.local().sees_ball()) {
    const regista_track& ball = world.local().balls().front();
    const double unseen = now - ball_seen_at_;
    // A search in the previous decision also counts, because the sight of the ball may have ended the search now.
    if ((searching || searching_) && unseen > ball_missed_at_least) add(REGISTA_EVENT_BALL_FOUND, unseen);
    if (own_number_ == goalkeeper && unseen > ball_missed_at_least) add(REGISTA_EVENT_GOALKEEPER_SAW_BALL, unseen);
    const double lacked = now - team_ball_seen_at_;
    if (lacked > ball_missed_at_least) add(REGISTA_EVENT_BALL_KNOWN_AGAIN, lacked);
    if (common.ball_known()) {
      const double moved = (Vector2d(ball.x, ball.y) - common.ball()).norm();
      if (moved > ball_moved_at_least) add(REGISTA_EVENT_BALL_MOVED, moved);
    }
    ball_seen_at_ = now;
  }
  if (decision.own_role != role_ && !first_) add(REGISTA_EVENT_ROLE_CHANGED, decision.own_role);
  if (decision.context != context_ && !first_) add(REGISTA_EVENT_CONTEXT_CHANGED, decision.context);
  const regista_robot& told = common.robot(own_number_);
  if ((told.flags & REGISTA_ROBOT_KNOWN) != 0) {
    const regista_robot& self = mine.robot(own_number_);
    const double moved = std::hypot(self.pose[0] - told.pose[0], self.pose[1] - told.pose[1]);
    if (moved > pose_moved_at_least) add(REGISTA_EVENT_POSE_MOVED, moved);
  }
  if (percepts.fallen && !fallen_) add(REGISTA_EVENT_FELL, 0.0);
  if (!percepts.fallen && fallen_) add(REGISTA_EVENT_GOT_UP, 0.0);
  if (penalised_ && !percepts.penalised) add(REGISTA_EVENT_RETURNED, 0.0);
  if (mine.game.phase != phase_) add(REGISTA_EVENT_PHASE_CHANGED, mine.game.phase);

  role_ = decision.own_role;
  context_ = decision.context;
  phase_ = mine.game.phase;
  fallen_ = percepts.fallen;
  penalised_ = percepts.penalised;
  searching_ = searching;
  first_ = false;
}

}  // namespace regista::mind
