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

  std::vector<double> goal_x, goal_y, facing_x, facing_y;
  std::vector<effort_to_pose::Point> opponents, team;
  std::vector<double> other_x, other_y;

  void setup(const regista::Environment& environment) {
    constexpr std::size_t most_opponents = 64;  // more than a world has; only memory depends on it
    for (auto* each : {&goal_x, &goal_y, &facing_x, &facing_y}) each->reserve(environment.roles().size());
    opponents.reserve(most_opponents);
    team.reserve(environment->team_size);
    for (auto* each : {&other_x, &other_y}) each->reserve(most_opponents + environment->team_size);
  }

  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    read_goals(frame);
    opponents.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      if (opponent.weight >= likely) opponents.push_back({opponent.position[0], opponent.position[1]});
    }
    team.clear();
    for (const int number : world.active()) team.push_back({world.robot(number).pose[0], world.robot(number).pose[1]});
    std::size_t row = 0;
    for (const int number : world.active()) {
      read_others(row);
      const auto heading = effort_to_pose::Direction::of(world.robot(number).pose[2]);
      effort_to_pose::score_row(team[row], heading, {goal_x, goal_y, facing_x, facing_y}, {other_x, other_y}, settings,
                                out.data() + row * out.stride());
      ++row;
    }
  }

 private:
  void read_goals(const regista::Frame& frame) {
    for (auto* each : {&goal_x, &goal_y, &facing_x, &facing_y}) each->clear();
    for (const regista::Task& task : frame.tasks()) {
      const auto facing = effort_to_pose::Direction::of(task.after[2]);
      goal_x.push_back(task.after[0]);
      goal_y.push_back(task.after[1]);
      facing_x.push_back(facing.x);
      facing_y.push_back(facing.y);
    }
  }
  // Seen from the robot of this row.
  void read_others(std::size_t row) {
    const effort_to_pose::Point& at = team[row];
    for (auto* each : {&other_x, &other_y}) each->clear();
    const auto add = [&](const effort_to_pose::Point& other) {
      other_x.push_back(other.x - at.x);
      other_y.push_back(other.y - at.y);
    };
    for (const effort_to_pose::Point& opponent : opponents) add(opponent);
    for (std::size_t mate = 0; mate < team.size(); ++mate) {
      if (mate != row) add(team[mate]);
    }
  }
};

}  // namespace

REGISTA_PLUGIN(EffortToPose, regista::utility)
