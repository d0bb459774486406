// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the chosen world's active robots against where the tasks are after their offset.
#include <vector>

#include <regista/utility.hpp>

#include "../frame_places.hpp"
#include "algorithm.hpp"

namespace {

struct Distance {
  static constexpr auto id = "distance", version = "1.0.0", summary = "Nearness of the robot to the task, linear";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  double reach = 11.0;
  static constexpr std::tuple parameters{
      regista::real("reach", &Distance::reach, {0.5, 100.0}, "m",
                    "Distance from which on the utility is 0; SPQR 2022: 11, about the diagonal of its field")
          .tunable()};

  std::vector<distance_utility::Point> robots;
  places::TargetList targets;

  void setup(const regista::Environment& environment) {
    robots.reserve(environment->team_size);
    targets.reserve(environment.roles().size());
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    read_robots(frame.world(), robots);
    targets.read_tasks(frame);
    distance_utility::score(robots, targets, reach, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(Distance, regista::utility)
