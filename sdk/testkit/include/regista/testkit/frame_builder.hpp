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

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <regista/testkit/environment_builder.hpp>
#include <regista/testkit/scene.hpp>

namespace regista::testkit {

namespace detail {

// The row of `name`. Throws std::logic_error when the table has none.
int role_row(const std::vector<std::string>& roles, std::string_view name);

}  // namespace detail

// One of the two worlds. What follows robot() or opponent() is about that one.
class WorldBuilder {
 public:
  WorldBuilder();
  WorldBuilder& team_size(int robots);
  WorldBuilder& roles(std::vector<std::string> names);

  WorldBuilder& robot(int number);
  WorldBuilder& opponent(double x, double y);
  WorldBuilder& no_opponents();
  WorldBuilder& at(double x, double y);
  WorldBuilder& heading(double angle);
  WorldBuilder& velocity(double vx, double vy, double turn_rate = 0.0);
  WorldBuilder& age(double seconds);
  WorldBuilder& weight(double probability);
  WorldBuilder& target(double x, double y);
  // The role it claims.
  WorldBuilder& role(std::string_view name);
  WorldBuilder& role(int id);
  // When it took that role, in match time.
  WorldBuilder& since(double time);
  WorldBuilder& fallen(double seconds_until_up);
  WorldBuilder& penalised();
  WorldBuilder& inactive();

  WorldBuilder& ball(double x, double y);
  WorldBuilder& no_ball() { return data_.ball = {}, *this; }
  WorldBuilder& ball_velocity(double vx, double vy);
  WorldBuilder& ball_age(double seconds) { return data_.ball.age = seconds, *this; }

  WorldBuilder& game(const regista_game& game) { return data_.game = game, *this; }
  WorldBuilder& phase(int phase, double phase_time = 0.0);
  WorldBuilder& set_play(int set_play, bool own_kick);
  WorldBuilder& score(int own, int opponent);

  // For what no function above names.
  WorldData& data() { return data_; }
  const WorldData& data() const { return data_; }

 private:
  static regista_robot unknown(int number);
  regista_robot& current();

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
  FrameBuilder& roles(std::vector<std::string> names);

  FrameBuilder& robot(int number) { return task_ = false, mine_.robot(number), *this; }
  FrameBuilder& opponent(double x, double y) { return task_ = false, mine_.opponent(x, y), *this; }
  FrameBuilder& heading(double angle);
  FrameBuilder& at(double x, double y);
  FrameBuilder& velocity(double vx, double vy, double turn_rate = 0.0);
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
  FrameBuilder& task(std::string_view role_name);
  FrameBuilder& task(int id);
  FrameBuilder& id(int row);
  FrameBuilder& priority(int place);
  FrameBuilder& group(int number);
  FrameBuilder& only_for(int robot_number);
  FrameBuilder& required();
  FrameBuilder& along_edges();
  // Where the offset step moved it.
  FrameBuilder& after(double x, double y);

  FrameBuilder& waypoint(double x, double y, double waypoint_score = 1.0, int task_index = -1, int robot_number = 0);
  FrameBuilder& edge(std::uint32_t from, std::uint32_t to);
  FrameBuilder& previous(int robot_number, std::string_view role_name);
  FrameBuilder& previous(int robot_number, int task_id);

  // Changes of the common world against `mine`, made when the scene is built.
  FrameBuilder& common(std::function<void(WorldBuilder&)> change);
  // For what no function above names.
  FrameBuilder& mine(const std::function<void(WorldBuilder&)>& change);

  Scene build() const;

 private:
  regista_task& last_task();

  SceneData data_;
  WorldBuilder mine_;
  std::vector<std::string> roles_ = usual_roles();
  std::vector<std::pair<int, int>> previous_;
  std::vector<std::function<void(WorldBuilder&)>> changes_;
  bool task_ = false;
};

}  // namespace regista::testkit
