// SPDX-License-Identifier: MIT
// Writes what a scene says into plain vectors, and makes the scene of them.
#include <regista/testkit/frame_builder.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>

namespace regista::testkit {

int detail::role_row(const std::vector<std::string>& roles, std::string_view name) {
  const auto found = std::find(roles.begin(), roles.end(), name);
  if (found == roles.end()) throw std::logic_error("no role \"" + std::string(name) + "\" in this scene's table");
  return static_cast<int>(found - roles.begin());
}

WorldBuilder::WorldBuilder() {
  data_.game.phase = REGISTA_PHASE_PLAYING;
  data_.game.half = 1;
  data_.game.time_left = 600.0;
  team_size(7);
}

WorldBuilder& WorldBuilder::team_size(int robots) {
  const auto before = static_cast<int>(data_.robots.size());
  data_.robots.resize(static_cast<std::size_t>(robots));
  for (int n = before; n < robots; ++n) data_.robots[static_cast<std::size_t>(n)] = unknown(n + 1);
  return *this;
}

WorldBuilder& WorldBuilder::roles(std::vector<std::string> names) { return roles_ = std::move(names), *this; }

WorldBuilder& WorldBuilder::robot(int number) {
  if (number < 1 || number > static_cast<int>(data_.robots.size())) throw std::logic_error("robot: no such number");
  robot_ = number;
  opponent_ = false;
  current().flags |= REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_ACTIVE;
  return *this;
}

WorldBuilder& WorldBuilder::opponent(double x, double y) {
  regista_opponent o{};
  o.label = static_cast<std::int32_t>(data_.opponents.size()) + 1;
  o.position[0] = x;
  o.position[1] = y;
  o.covariance[0] = o.covariance[2] = 0.04;
  o.weight = 1.0;
  data_.opponents.push_back(o);
  opponent_ = true;
  return *this;
}

WorldBuilder& WorldBuilder::no_opponents() { return data_.opponents.clear(), *this; }

WorldBuilder& WorldBuilder::at(double x, double y) {
  double* to = opponent_ ? data_.opponents.back().position : current().pose;
  to[0] = x;
  to[1] = y;
  return *this;
}

WorldBuilder& WorldBuilder::heading(double angle) { return current().pose[2] = angle, *this; }

WorldBuilder& WorldBuilder::velocity(double vx, double vy, double turn_rate) {
  double* to = opponent_ ? data_.opponents.back().velocity : current().velocity;
  to[0] = vx;
  to[1] = vy;
  if (!opponent_) to[2] = turn_rate;
  return *this;
}

WorldBuilder& WorldBuilder::age(double seconds) {
  return (opponent_ ? data_.opponents.back().age : current().age) = seconds, *this;
}

WorldBuilder& WorldBuilder::weight(double probability) {
  if (!opponent_) throw std::logic_error("weight() follows opponent()");
  return data_.opponents.back().weight = probability, *this;
}

WorldBuilder& WorldBuilder::target(double x, double y) {
  regista_robot& r = current();
  r.target[0] = x;
  r.target[1] = y;
  r.flags |= REGISTA_ROBOT_HAS_TARGET;
  return *this;
}

WorldBuilder& WorldBuilder::role(std::string_view name) { return role(detail::role_row(roles_, name)); }

WorldBuilder& WorldBuilder::role(int id) { return current().role = id, *this; }

WorldBuilder& WorldBuilder::since(double time) { return current().role_since = time, *this; }

WorldBuilder& WorldBuilder::fallen(double seconds_until_up) {
  current().flags |= REGISTA_ROBOT_FALLEN;
  return current().time_until_up = seconds_until_up, *this;
}

WorldBuilder& WorldBuilder::penalised() {
  current().flags |= REGISTA_ROBOT_PENALISED;
  return inactive();
}

WorldBuilder& WorldBuilder::inactive() { return current().flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE}, *this; }

WorldBuilder& WorldBuilder::ball(double x, double y) {
  data_.ball = {};
  data_.ball.flags = REGISTA_BALL_KNOWN;
  data_.ball.position[0] = x;
  data_.ball.position[1] = y;
  for (const std::size_t i : {0u, 2u}) data_.ball.covariance[i] = 0.01;
  for (const std::size_t i : {7u, 9u}) data_.ball.covariance[i] = 0.04;
  return *this;
}

WorldBuilder& WorldBuilder::ball_velocity(double vx, double vy) {
  data_.ball.velocity[0] = vx;
  data_.ball.velocity[1] = vy;
  return *this;
}

WorldBuilder& WorldBuilder::phase(int phase, double phase_time) {
  data_.game.phase = phase;
  return data_.game.phase_time = phase_time, *this;
}

WorldBuilder& WorldBuilder::set_play(int set_play, bool own_kick) {
  data_.game.set_play = set_play;
  return data_.game.own_kick = own_kick ? 1 : 0, *this;
}

WorldBuilder& WorldBuilder::score(int own, int opponent) {
  data_.game.own_score = own;
  return data_.game.opponent_score = opponent, *this;
}

regista_robot WorldBuilder::unknown(int number) {
  regista_robot r{};
  r.number = number;
  r.role = -1;
  for (const std::size_t i : {0u, 2u, 5u}) r.covariance[i] = 0.01;
  return r;
}

regista_robot& WorldBuilder::current() {
  if (opponent_ || robot_ == 0) throw std::logic_error("this says something about a robot: robot() comes first");
  return data_.robots.at(static_cast<std::size_t>(robot_ - 1));
}

FrameBuilder& FrameBuilder::roles(std::vector<std::string> names) {
  roles_ = names;
  return mine_.roles(std::move(names)), *this;
}

FrameBuilder& FrameBuilder::heading(double angle) {
  if (!task_) return mine_.heading(angle), *this;
  return last_task().before[2] = last_task().after[2] = angle, *this;
}

FrameBuilder& FrameBuilder::at(double x, double y) {
  if (!task_) return mine_.at(x, y), *this;
  regista_task& t = last_task();
  t.before[0] = t.after[0] = x;
  t.before[1] = t.after[1] = y;
  return *this;
}

FrameBuilder& FrameBuilder::velocity(double vx, double vy, double turn_rate) {
  return mine_.velocity(vx, vy, turn_rate), *this;
}

FrameBuilder& FrameBuilder::task(std::string_view role_name) { return task(detail::role_row(roles_, role_name)); }

FrameBuilder& FrameBuilder::task(int id) {
  regista_task t{};
  t.id = id;
  t.priority = static_cast<std::int32_t>(data_.tasks.size());
  t.group = -1;
  data_.tasks.push_back(t);
  task_ = true;
  return *this;
}

FrameBuilder& FrameBuilder::id(int row) { return last_task().id = row, *this; }

FrameBuilder& FrameBuilder::priority(int place) { return last_task().priority = place, *this; }

FrameBuilder& FrameBuilder::group(int number) { return last_task().group = number, *this; }

FrameBuilder& FrameBuilder::only_for(int robot_number) { return last_task().robot = robot_number, *this; }

FrameBuilder& FrameBuilder::required() { return last_task().flags |= REGISTA_TASK_REQUIRED, *this; }

FrameBuilder& FrameBuilder::along_edges() { return last_task().flags |= REGISTA_TASK_ALONG_EDGES, *this; }

FrameBuilder& FrameBuilder::after(double x, double y) {
  last_task().after[0] = x;
  return last_task().after[1] = y, *this;
}

FrameBuilder& FrameBuilder::waypoint(double x, double y, double waypoint_score, int task_index, int robot_number) {
  return data_.waypoints.push_back({x, y, waypoint_score, task_index, robot_number}), *this;
}

FrameBuilder& FrameBuilder::edge(std::uint32_t from, std::uint32_t to) {
  return data_.edges.push_back({from, to}), *this;
}

FrameBuilder& FrameBuilder::previous(int robot_number, std::string_view role_name) {
  return previous(robot_number, detail::role_row(roles_, role_name));
}

FrameBuilder& FrameBuilder::previous(int robot_number, int task_id) {
  return previous_.emplace_back(robot_number, task_id), *this;
}

FrameBuilder& FrameBuilder::common(std::function<void(WorldBuilder&)> change) {
  return changes_.push_back(std::move(change)), *this;
}

FrameBuilder& FrameBuilder::mine(const std::function<void(WorldBuilder&)>& change) { return change(mine_), *this; }

Scene FrameBuilder::build() const {
  SceneData data = data_;
  WorldBuilder mine = mine_;
  const auto own = static_cast<std::size_t>(data.own_number - 1);
  mine.data().robots.at(own).flags |= REGISTA_ROBOT_SELF;
  WorldBuilder common = mine;
  for (const auto& change : changes_) change(common);
  data.mine = mine.data();
  data.common = common.data();
  data.previous.assign(data.mine.robots.size(), -1);
  for (const auto& [number, task_id] : previous_) data.previous.at(static_cast<std::size_t>(number - 1)) = task_id;
  return Scene(std::move(data));
}

regista_task& FrameBuilder::last_task() {
  if (data_.tasks.empty()) throw std::logic_error("this says something about a task: task() comes first");
  return data_.tasks.back();
}

}  // namespace regista::testkit
