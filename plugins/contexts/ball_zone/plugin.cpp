// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the ball of the world that the team has chosen. The box is in metres, as the
// places of the roles are: both are written for one size of field.
#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

struct BallZone {
  static constexpr auto id = "ball_zone", version = "1.0.0",
                        summary = "The ball is within a box of the field; an unknown ball is in none";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  double x_least = -100.0, x_most = 100.0, y_least = -100.0, y_most = 100.0, band = 0.3;
  static constexpr regista::Range metres{-100.0, 100.0};
  static constexpr std::tuple parameters{
      regista::real("x_least", &BallZone::x_least, metres, "m",
                    "The box towards the own goal line; 0 is the halfway line; our choice: no bound")
          .tunable(),
      regista::real("x_most", &BallZone::x_most, metres, "m",
                    "The box towards the opponent's goal line; below `x_least` it never holds; our choice: no bound")
          .tunable(),
      regista::real("y_least", &BallZone::y_least, metres, "m",
                    "The box towards the right touch line; our choice: no bound")
          .tunable(),
      regista::real("y_most", &BallZone::y_most, metres, "m",
                    "The box towards the left touch line; below `y_least` it never holds; our choice: no bound")
          .tunable(),
      regista::real("band", &BallZone::band, {0.0, 10.0}, "m",
                    "A ball once inside counts until it is so far beyond the box; our choice")
          .tunable()};

  ball_zone::Memory memory;

  void reset(std::uint64_t) { memory.forget(); }
  bool holds(const regista::Frame& frame) {
    const regista::World world = frame.world();
    const regista::Ball& ball = world.ball();
    return memory.update({x_least, x_most, y_least, y_most}, band, world.ball_known(), ball.position[0],
                         ball.position[1]);
  }
};

}  // namespace

REGISTA_PLUGIN(BallZone, regista::context)
