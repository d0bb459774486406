// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which call it answers.
#include <cmath>

#include <regista/utility.hpp>

#include "algorithm.hpp"

namespace {

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0", summary = "Nearness of the robot to the task";
  // Of a frame it reads nothing but what every plugin is shown; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  double half_at = 2.0;
  static constexpr std::tuple parameters{
      regista::real("half_at", &Plugin::half_at, {0.1, 20.0}, "m", "Distance at which half of the utility is left")
          .tunable()};

  // Rows are the active robots, columns the tasks.
  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    for (std::size_t row = 0; row < out.rows(); ++row) {
      const regista::Robot& robot = world.robot(world.active()[row]);
      for (std::size_t column = 0; column < out.columns(); ++column) {
        const regista::Task& task = frame.tasks()[column];
        out(row, column) = nearness(std::hypot(task.after[0] - robot.pose[0], task.after[1] - robot.pose[1]), half_at);
      }
    }
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::utility)
