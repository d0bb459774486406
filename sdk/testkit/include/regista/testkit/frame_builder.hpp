// SPDX-License-Identifier: MIT
// Readable scenes:
//
//   const Scene scene = FrameBuilder{}
//       .team_size(7).own(3).time(12.0)
//       .robot(1).at(-4, 0)
//       .robot(3).at(0, 1).heading(0.5).role("striker").since(10.0)
//       .opponent(1.0, 0.5)
//       .ball(0, 0).ball_age(0.5)
//       .task("striker").at(0, 0)
//       .task("supporter").at(-1, 0)
//       .waypoint(1, 2).waypoint(2, 2).edge(0, 1)
//       .previous(3, "striker")
//       .common([](WorldBuilder& world) { world.robot(3).at(0.2, 1.1); })
//       .build();
//
// Robots that are named are known and active; the others are neither. `common` equals `mine` but for what common()
// changes. A role's name stands for its row in the table of roles: usual_roles(), or what roles() says.
#pragma once

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <regista/testkit/environment_builder.hpp>
#include <regista/testkit/scene.hpp>

namespace regista::testkit {

namespace detail {

inline int role_row(const std::vector<std::string>& roles, std::string_view name) {
  const auto found = std::find(roles.begin(), roles.end(), name);
  if (found == roles.end()) throw std::logic_error("no role \"" + std::string(name) + "\" in this scene's table");
  return static_cast<int>(found - roles.begin());
}

}  // namespace detail

// One of the two worlds. What follows robot() or opponent() is about that one.
class WorldBuilder {
 public:
  WorldBuilder() {
    data_.game.phase = REGISTA_PHASE_PLAYING;
    data_.game.half = 1;
    data_.game.time_left = 600.0;
    team_size(7);
  }
  WorldBuilder& team_size(int robots) {
    const auto before = static_cast<int>(data_.robots.size());
    data_.robots.resize(static_cast<std::size_t>(robots));
    for (int n = before; n < robots; ++n) data_.robots[static_cast<std::size_t>(n)] = unknown(n + 1);
    return *this;
  }
  WorldBuilder& roles(std::vector<std::string> names) { return roles_ = std::move(names), *this; }

  WorldBuilder& robot(int number) {
    if (number < 1 || number > static_cast<int>(data_.robots.size())) throw std::logic_error("robot: no such number");
    robot_ = number;
    opponent_ = false;
    current().flags |= REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_ACTIVE;
    return *this;
  }
  WorldBuilder& opponent(double x, double y) {
    regista_opponent o{};
    o.label = static_cast<std::int32_t>(data_.opponents.size()) + 1;
    o.position[0] = x;
    o.position[1] = y;
    o.covariance[0] = o.covariance[3] = 0.04;
    o.weight = 1.0;
    data_.opponents.push_back(o);
    opponent_ = true;
    return *this;
  }
  WorldBuilder& no_opponents() { return data_.opponents.clear(), *this; }
  WorldBuilder& at(double x, double y) {
    double* to = opponent_ ? data_.opponents.back().position : current().pose;
    to[0] = x;
    to[1] = y;
    return *this;
  }
  WorldBuilder& heading(double angle) { return current().pose[2] = angle, *this; }
  WorldBuilder& velocity(double vx, double vy, double turn_rate = 0.0) {
    double* to = opponent_ ? data_.opponents.back().velocity : current().velocity;
    to[0] = vx;
    to[1] = vy;
    if (!opponent_) to[2] = turn_rate;
    return *this;
  }
  WorldBuilder& age(double seconds) {
    return (opponent_ ? data_.opponents.back().age : current().age) = seconds, *this;
  }
  WorldBuilder& weight(double probability) {
    if (!opponent_) throw std::logic_error("weight() follows opponent()");
    return data_.opponents.back().weight = probability, *this;
  }
  WorldBuilder& target(double x, double y) {
    regista_robot& r = current();
    r.target[0] = x;
    r.target[1] = y;
    r.flags |= REGISTA_ROBOT_HAS_TARGET;
    return *this;
  }
  // The role it claims.
  WorldBuilder& role(std::string_view name) { return role(detail::role_row(roles_, name)); }
  WorldBuilder& role(int id) { return current().role = id, *this; }
  // When it took that role, in match time.
  WorldBuilder& since(double time) { return current().role_since = time, *this; }
  WorldBuilder& fallen(double seconds_until_up) {
    current().flags |= REGISTA_ROBOT_FALLEN;
    return current().time_until_up = seconds_until_up, *this;
  }
  WorldBuilder& penalised() {
    current().flags |= REGISTA_ROBOT_PENALISED;
    return inactive();
  }
  WorldBuilder& inactive() { return current().flags &= ~std::uint32_t{REGISTA_ROBOT_ACTIVE}, *this; }

  WorldBuilder& ball(double x, double y) {
    data_.ball = {};
    data_.ball.flags = REGISTA_BALL_KNOWN;
    data_.ball.position[0] = x;
    data_.ball.position[1] = y;
    for (const std::size_t i : {0u, 5u}) data_.ball.covariance[i] = 0.01;
    for (const std::size_t i : {10u, 15u}) data_.ball.covariance[i] = 0.04;
    return *this;
  }
  WorldBuilder& no_ball() { return data_.ball = {}, *this; }
  WorldBuilder& ball_velocity(double vx, double vy) {
    data_.ball.velocity[0] = vx;
    data_.ball.velocity[1] = vy;
    return *this;
  }
  WorldBuilder& ball_age(double seconds) { return data_.ball.age = seconds, *this; }

  WorldBuilder& game(const regista_game& game) { return data_.game = game, *this; }
  WorldBuilder& phase(int phase, double phase_time = 0.0) {
    data_.game.phase = phase;
    return data_.game.phase_time = phase_time, *this;
  }
  WorldBuilder& set_play(int set_play, bool own_kick) {
    data_.game.set_play = set_play;
    return data_.game.own_kick = own_kick ? 1 : 0, *this;
  }
  WorldBuilder& score(int own, int opponent) {
    data_.game.own_score = own;
    return data_.game.opponent_score = opponent, *this;
  }

  // For what no function above names.
  WorldData& data() { return data_; }
  const WorldData& data() const { return data_; }

 private:
  static regista_robot unknown(int number) {
    regista_robot r{};
    r.number = number;
    r.role = -1;
    for (const std::size_t i : {0u, 4u, 8u}) r.covariance[i] = 0.01;
    return r;
  }
  regista_robot& current() {
    if (opponent_ || robot_ == 0) throw std::logic_error("this says something about a robot: robot() comes first");
    return data_.robots.at(static_cast<std::size_t>(robot_ - 1));
  }

  WorldData data_;
  std::vector<std::string> roles_ = usual_roles();
  int robot_ = 0;
  bool opponent_ = false;
};

// What follows robot(), opponent() or task() is about that one.
class FrameBuilder {
 public:
  FrameBuilder& name(std::string text) { return data_.name = std::move(text), *this; }
  FrameBuilder& team_size(int robots) { return mine_.team_size(robots), *this; }
  FrameBuilder& own(int number) { return data_.own_number = number, *this; }
  FrameBuilder& time(double seconds) { return data_.time = seconds, *this; }
  FrameBuilder& tick(std::uint64_t count) { return data_.tick = count, *this; }
  FrameBuilder& knowledge(int mine_or_common) { return data_.knowledge = mine_or_common, *this; }
  FrameBuilder& context(int index) { return data_.context = index, *this; }
  FrameBuilder& walk_speed(double metres_per_second) { return data_.walk_speed = metres_per_second, *this; }
  // The table of roles that names refer to; give EnvironmentBuilder the same.
  FrameBuilder& roles(std::vector<std::string> names) {
    roles_ = names;
    return mine_.roles(std::move(names)), *this;
  }

  FrameBuilder& robot(int number) { return task_ = false, mine_.robot(number), *this; }
  FrameBuilder& opponent(double x, double y) { return task_ = false, mine_.opponent(x, y), *this; }
  FrameBuilder& heading(double angle) {
    if (!task_) return mine_.heading(angle), *this;
    return last_task().before[2] = last_task().after[2] = angle, *this;
  }
  FrameBuilder& at(double x, double y) {
    if (!task_) return mine_.at(x, y), *this;
    regista_task& t = last_task();
    t.before[0] = t.after[0] = x;
    t.before[1] = t.after[1] = y;
    return *this;
  }
  FrameBuilder& velocity(double vx, double vy, double turn_rate = 0.0) {
    return mine_.velocity(vx, vy, turn_rate), *this;
  }
  FrameBuilder& age(double seconds) { return mine_.age(seconds), *this; }
  FrameBuilder& weight(double probability) { return mine_.weight(probability), *this; }
  FrameBuilder& target(double x, double y) { return mine_.target(x, y), *this; }
  FrameBuilder& role(std::string_view role_name) { return mine_.role(role_name), *this; }
  FrameBuilder& role(int id) { return mine_.role(id), *this; }
  FrameBuilder& since(double match_time) { return mine_.since(match_time), *this; }
  FrameBuilder& fallen(double seconds_until_up) { return mine_.fallen(seconds_until_up), *this; }
  FrameBuilder& penalised() { return mine_.penalised(), *this; }
  FrameBuilder& inactive() { return mine_.inactive(), *this; }

  FrameBuilder& ball(double x, double y) { return mine_.ball(x, y), *this; }
  FrameBuilder& no_ball() { return mine_.no_ball(), *this; }
  FrameBuilder& ball_velocity(double vx, double vy) { return mine_.ball_velocity(vx, vy), *this; }
  FrameBuilder& ball_age(double seconds) { return mine_.ball_age(seconds), *this; }
  FrameBuilder& game(const regista_game& game) { return mine_.game(game), *this; }
  FrameBuilder& phase(int phase, double phase_time = 0.0) { return mine_.phase(phase, phase_time), *this; }
  FrameBuilder& set_play(int set_play, bool own_kick) { return mine_.set_play(set_play, own_kick), *this; }
  FrameBuilder& score(int own, int opponent) { return mine_.score(own, opponent), *this; }

  // A task: its id is the role's row, its priority its place among the tasks.
  FrameBuilder& task(std::string_view role_name) { return task(detail::role_row(roles_, role_name)); }
  FrameBuilder& task(int id) {
    regista_task t{};
    t.id = id;
    t.priority = static_cast<std::int32_t>(data_.tasks.size());
    t.group = -1;
    data_.tasks.push_back(t);
    task_ = true;
    return *this;
  }
  FrameBuilder& id(int row) { return last_task().id = row, *this; }
  FrameBuilder& priority(int place) { return last_task().priority = place, *this; }
  FrameBuilder& group(int number) { return last_task().group = number, *this; }
  FrameBuilder& only_for(int robot_number) { return last_task().robot = robot_number, *this; }
  FrameBuilder& required() { return last_task().flags |= REGISTA_TASK_REQUIRED, *this; }
  // Where the offset step moved it.
  FrameBuilder& after(double x, double y) {
    last_task().after[0] = x;
    return last_task().after[1] = y, *this;
  }

  FrameBuilder& waypoint(double x, double y, double waypoint_score = 1.0, int task_index = -1, int robot_number = 0) {
    return data_.waypoints.push_back({x, y, waypoint_score, task_index, robot_number}), *this;
  }
  FrameBuilder& edge(std::uint32_t from, std::uint32_t to) { return data_.edges.push_back({from, to}), *this; }
  FrameBuilder& previous(int robot_number, std::string_view role_name) {
    return previous(robot_number, detail::role_row(roles_, role_name));
  }
  FrameBuilder& previous(int robot_number, int task_id) { return previous_.emplace_back(robot_number, task_id), *this; }

  // Changes of the common world against `mine`, made when the scene is built.
  FrameBuilder& common(std::function<void(WorldBuilder&)> change) {
    return changes_.push_back(std::move(change)), *this;
  }
  // For what no function above names.
  FrameBuilder& mine(const std::function<void(WorldBuilder&)>& change) { return change(mine_), *this; }

  Scene build() const {
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

 private:
  regista_task& last_task() {
    if (data_.tasks.empty()) throw std::logic_error("this says something about a task: task() comes first");
    return data_.tasks.back();
  }

  SceneData data_;
  WorldBuilder mine_;
  std::vector<std::string> roles_ = usual_roles();
  std::vector<std::pair<int, int>> previous_;
  std::vector<std::function<void(WorldBuilder&)>> changes_;
  bool task_ = false;
};

}  // namespace regista::testkit
