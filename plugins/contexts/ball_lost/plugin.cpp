// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the ball of the world that the team has chosen, and what this robot has seen
// since. "Nobody has seen the ball" is not true for a robot that has; without own_sightings a team that is silent, and
// is judged on what all know, leaves the ball that it sees to search for it.
#include <algorithm>

#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

struct BallLost {
  static constexpr auto id = "ball_lost", version = "1.1.0",
                        summary = "Nobody has seen the ball for a while, or nobody knows it";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  ball_lost::Rule rule;
  bool own_sightings = true;
  static constexpr std::tuple parameters{
      regista::within(
          &BallLost::rule,
          regista::real("after", &ball_lost::Rule::after, {0.1, 60.0}, "s",
                        "Age of the last sighting by anyone beyond which the ball is lost; 4.5 in SPQR's released code")
              .tunable(),
          regista::real(
              "seen_again", &ball_lost::Rule::seen_again, {0.0, 10.0}, "s",
              "Sightings must span this long before a lost ball counts as found; 0, as published: one is enough")
              .tunable()),
      regista::boolean("own_sightings", &BallLost::own_sightings,
                       "What this robot has seen counts before it has sent it: it does not search for a ball that it "
                       "sees; without effect where the context is judged on what the robot knows itself (mine)")};

  ball_lost::Memory memory;

  void reset(std::uint64_t) { memory.forget(); }
  bool holds(const regista::Frame& frame) {
    const regista::World world = frame.world(), mine = frame.mine();
    bool known = world.ball_known();
    double age = world.ball().age;
    if (own_sightings && mine.ball_known()) {
      age = known ? std::min(age, mine.ball().age) : mine.ball().age;
      known = true;
    }
    return memory.update(rule, frame.time(), known, age);
  }
};

}  // namespace

REGISTA_PLUGIN(BallLost, regista::context)
