// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the chosen world's active robots against where the tasks are after their offset.
#include <vector>

#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

struct Distance {
  static constexpr auto id = "distance", version = "1.0.0", summary = "Nearness of the robot to the task, linear";
  double reach = 11.0;
  static constexpr std::tuple parameters{
      regista::real("reach", &Distance::reach, {0.5, 100.0}, "m",
                    "Distance from which on the utility is 0; SPQR 2022: 11, about the diagonal of its field")
          .tunable()};

  std::vector<distance_utility::Point> robots;
  std::vector<double> x, y;

  void setup(const regista::Environment& environment) {
    robots.reserve(environment->team_size);
    x.reserve(environment.roles().size());
    y.reserve(environment.roles().size());
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    robots.clear();
    x.clear();
    y.clear();
    for (const int number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      robots.push_back({robot.pose[0], robot.pose[1]});
    }
    for (const regista::Task& task : frame.tasks()) {
      x.push_back(task.after[0]);
      y.push_back(task.after[1]);
    }
    distance_utility::score(robots, {x, y}, reach, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(Distance, regista::utility)
