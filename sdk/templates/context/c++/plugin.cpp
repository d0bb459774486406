// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which call it answers.
#include <cmath>

#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0", summary = "Holds while the ball is near the own goal";
  // Of a frame it reads nothing but what every plugin is shown; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  double near = 2.5, margin = 0.5;
  static constexpr std::tuple parameters{
      regista::real("near", &Plugin::near, {0.1, 20.0}, "m", "Distance of the ball from the goal below which it holds")
          .tunable(),
      regista::real("margin", &Plugin::margin, {0.0, 5.0}, "m", "How much farther the ball must be until it ends")
          .tunable()};

  double goal_x = 0.0;
  Nearness algorithm;

  void setup(const regista::Environment& environment) { goal_x = -environment->field_length / 2.0; }
  void reset(std::uint64_t) { algorithm.forget(); }

  bool holds(const regista::Frame& frame) {
    if (!frame.world().ball_known()) {
      algorithm.forget();
      return false;
    }
    const regista::Ball& ball = frame.world().ball();
    return algorithm.update(std::hypot(ball.position[0] - goal_x, ball.position[1]), near, margin);
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::context)
