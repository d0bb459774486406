// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the chosen world's active robots against where the tasks are after their offset.
#include <vector>

#include <regista/utility.hpp>

#include "../frame_places.hpp"
#include "algorithm.hpp"

namespace {

struct InverseDistance {
  static constexpr auto id = "inverse_distance", version = "1.0.0",
                        summary = "One over the distance to the task, as in SPQR 2023";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  inverse_distance::Settings settings;
  static constexpr std::tuple parameters{regista::within(
      &InverseDistance::settings,
      regista::real("eps", &inverse_distance::Settings::eps, {1e-10, 10.0}, "m",
                    "Added to the distance, and as radians to the bearing error; at the task the utility is its "
                    "inverse; SPQR 2023: 1e-10")
          .tunable()
          .log_scale(),
      regista::real("bearing_weight", &inverse_distance::Settings::bearing_weight, {0.0, 10.0}, "rad",
                    "w in the term w / (|a| + eps) of the bearing error a that is added; SPQR 2023: 0, 2024: 0.01")
          .tunable())};

  std::vector<inverse_distance::Pose> robots;
  places::TargetList targets;

  void setup(const regista::Environment& environment) {
    robots.reserve(environment->team_size);
    targets.reserve(environment.roles().size());
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    read_robots(frame.world(), robots);
    targets.read_tasks(frame);
    inverse_distance::score(robots, targets, settings, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(InverseDistance, regista::utility)
