// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the chosen world's active robots against the tasks, or against the opponent's
// goal.
#include <vector>

#include <regista/utility.hpp>

#include "../frame_places.hpp"
#include "algorithm.hpp"

namespace {

enum class Towards { task, opponent_goal };

struct Bearing {
  static constexpr auto id = "bearing", version = "1.0.0", summary = "How little the robot must turn to face the task";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  bearing_utility::Form form = bearing_utility::Form::cosine;
  Towards towards = Towards::task;
  static constexpr std::array<const char*, 2> forms{"cosine", "angle"};
  static constexpr std::array<const char*, 2> aims{"task", "opponent_goal"};
  static constexpr std::tuple parameters{
      regista::choice("form", &Bearing::form, forms,
                      "cosine: (1 + cos a) / 2, without trigonometry per task; angle: (pi - |a|) / pi as in SPQR 2022"),
      regista::choice("towards", &Bearing::towards, aims,
                      "What the robot should face; SPQR 2022 has a term for either, each with weight 0.05")};

  std::vector<bearing_utility::Direction> directions;  // of robot n at n - 1
  std::vector<bearing_utility::Robot> robots;
  places::TargetList targets;
  double goal_x = 0.0;

  void setup(const regista::Environment& environment) {
    directions.resize(environment->team_size);
    robots.reserve(environment->team_size);
    targets.reserve(environment.roles().size());
    goal_x = environment->field_length / 2.0;
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    robots.clear();
    for (const int number : frame.world().active()) {
      const regista::Robot& robot = frame.world().robot(number);
      bearing_utility::Direction& ahead = directions[static_cast<std::size_t>(number - 1)];
      ahead.turn(robot.pose[2]);
      robots.push_back({robot.pose[0], robot.pose[1], ahead});
    }
    if (towards == Towards::task) {
      targets.read_tasks(frame);
    } else {
      targets.repeat({goal_x, 0.0}, frame.tasks().size());
    }
    bearing_utility::score(robots, targets, form, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(Bearing, regista::utility)
