// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the ball of the world that the team has chosen.
#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

struct BallLost {
  static constexpr auto id = "ball_lost", version = "1.0.0",
                        summary = "Nobody has seen the ball for a while, or nobody knows it";
  ball_lost::Rule rule;
  static constexpr std::tuple parameters{regista::within(
      &BallLost::rule,
      regista::real("after", &ball_lost::Rule::after, {0.1, 60.0}, "s",
                    "Age of the last sighting by anyone beyond which the ball is lost; 4.5 in SPQR's released code")
          .tunable(),
      regista::real("seen_again", &ball_lost::Rule::seen_again, {0.0, 10.0}, "s",
                    "Sightings must span this long before a lost ball counts as found; 0, as published: one is enough")
          .tunable())};

  ball_lost::Memory memory;

  void reset(std::uint64_t) { memory.forget(); }
  bool holds(const regista::Frame& frame) {
    const regista::World world = frame.world();
    return memory.update(rule, frame.time(), world.ball_known(), world.ball().age);
  }
};

}  // namespace

REGISTA_PLUGIN(BallLost, regista::context)
