// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the frame's waypoints against where the tasks are after their offset.
#include <vector>

#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

struct WaypointProximity {
  static constexpr auto id = "waypoint_proximity", version = "1.0.0",
                        summary = "Nearness of the task to the nearest waypoint";
  static constexpr unsigned reads = REGISTA_READS_WAYPOINTS;
  waypoint_utility::Settings settings;
  static constexpr std::array<const char*, 2> forms{"inverse", "linear"};
  static constexpr std::tuple parameters{regista::within(
      &WaypointProximity::settings,
      regista::choice("form", &waypoint_utility::Settings::form, forms,
                      "inverse: 1 / (1 + d / scale); linear: 1 - d / scale, not below 0. The paper gives no formula"),
      regista::real("scale", &waypoint_utility::Settings::scale, {0.05, 20.0}, "m",
                    "Distance at which the utility is half (inverse) or nothing (linear); our choice")
          .tunable()
          .log_scale(),
      regista::boolean("weighted", &waypoint_utility::Settings::weighted,
                       "Multiply by the score of the waypoint; our choice"))};

  std::vector<int> numbers;
  std::vector<waypoint_utility::Point> targets;
  std::vector<waypoint_utility::Waypoint> waypoints;

  void setup(const regista::Environment& environment) {
    numbers.reserve(environment->team_size);
    targets.reserve(environment.roles().size());
    waypoints.reserve(64);
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    numbers.clear();
    targets.clear();
    waypoints.clear();
    for (const int number : frame.world().active()) numbers.push_back(number);
    for (const regista::Task& task : frame.tasks()) targets.push_back({task.after[0], task.after[1]});
    for (const regista::Waypoint& point : frame.waypoints()) {
      waypoints.push_back({point.x, point.y, point.score, point.task, point.robot});
    }
    waypoint_utility::score(numbers, targets, waypoints, settings, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(WaypointProximity, regista::utility)
