// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the chosen world's active robots and the poses of the tasks after their offset.
// Obstacles are the other active robots of the team and the opponents.
#include <vector>

#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

struct EffortToPose {
  static constexpr auto id = "effort_to_pose", version = "1.0.0",
                        summary = "How little way, turning and avoiding it takes to the task's pose (CS Freiburg)";
  static constexpr unsigned reads =
      REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON | REGISTA_READS_FACINGS;
  effort_to_pose::Settings settings;
  double likely = 0.5;
  using S = effort_to_pose::Settings;
  static constexpr regista::Range share{0.0, 1.0};
  static constexpr std::tuple parameters{
      regista::within(
          &EffortToPose::settings,
          regista::real("distance_weight", &S::distance_weight, share, "1", "Share of the way (assumption)").tunable(),
          regista::real("turn_weight", &S::turn_weight, share, "1",
                        "Share of the turn from the robot's heading towards the pose (assumption)")
              .tunable(),
          regista::real("final_turn_weight", &S::final_turn_weight, share, "1",
                        "Share of the turn from the way to the pose's heading (assumption)")
              .tunable(),
          regista::real("obstacles_weight", &S::obstacles_weight, share, "1",
                        "Share of the robots in the way (assumption)")
              .tunable(),
          regista::real("farthest", &S::farthest, {0.5, 200.0}, "m",
                        "Longer ways count as this one (assumption: the diagonal of the field)"),
          regista::real("near", &S::near, {0.01, 5.0}, "m",
                        "Within this distance the turn towards the pose counts less and less (assumption)"),
          regista::real("clearance", &S::clearance, {0.0, 5.0}, "m",
                        "A robot nearer to the straight way is an obstacle (assumption: two radii of a robot)")
              .tunable(),
          regista::real("most_obstacles", &S::most_obstacles, {0.1, 22.0}, "1",
                        "More obstacles are no worse than so many (assumption)")),
      regista::real("likely", &EffortToPose::likely, {0.0, 1.0}, "1",
                    "Opponents whose existence is less probable are no obstacles (assumption)")
          .tunable()};

  std::vector<effort_to_pose::Target> targets;
  std::vector<effort_to_pose::Point> opponents, others;

  void setup(const regista::Environment& environment) {
    constexpr std::size_t most_opponents = 64;  // more than a world has; only memory depends on it
    targets.reserve(environment.roles().size());
    opponents.reserve(most_opponents);
    others.reserve(most_opponents + environment->team_size);
  }

  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    targets.clear();
    for (const regista::Task& task : frame.tasks()) {
      targets.push_back({{task.after[0], task.after[1]}, effort_to_pose::Direction::of(task.after[2])});
    }
    opponents.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      if (opponent.weight >= likely) opponents.push_back({opponent.position[0], opponent.position[1]});
    }
    std::size_t row = 0;
    for (const int number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      others.assign(opponents.begin(), opponents.end());
      for (const int other : world.active()) {
        if (other != number) others.push_back({world.robot(other).pose[0], world.robot(other).pose[1]});
      }
      const effort_to_pose::Point at{robot.pose[0], robot.pose[1]};
      const auto heading = effort_to_pose::Direction::of(robot.pose[2]);
      for (std::size_t column = 0; column < targets.size(); ++column) {
        out(row, column) = effort_to_pose::effort_to_pose(at, heading, targets[column], others, settings);
      }
      ++row;
    }
  }
};

}  // namespace

REGISTA_PLUGIN(EffortToPose, regista::utility)
