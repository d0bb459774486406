// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the chosen world's active robots against the opponent's goal.
#include <vector>

#include <plugins/utilities/frame_places.hpp>
#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

struct GoalBearing {
  static constexpr auto id = "goal_bearing", version = "1.0.0",
                        summary = "How little the robot must turn to face the opponent's goal";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  goal_bearing::Form form = goal_bearing::Form::angle;
  static constexpr std::array<const char*, 2> forms{"angle", "cosine"};
  static constexpr std::tuple parameters{
      regista::choice("form", &GoalBearing::form, forms,
                      "angle: (pi - |a|) / pi as in SPQR 2022, weight 0.05; cosine: (1 + cos a) / 2, our choice")};

  std::vector<goal_bearing::Pose> robots;
  goal_bearing::Point goal{};

  void setup(const regista::Environment& environment) {
    robots.reserve(environment->team_size);
    goal = {environment->field_length / 2.0, 0.0};
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    read_robots(frame.world(), robots);
    goal_bearing::score(robots, goal, form, out.data(), out.columns(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(GoalBearing, regista::utility)
