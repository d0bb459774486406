// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the ball and the robots of the world that the team has chosen. Robots that are
// penalised, lost or fallen have no ball.
#include <algorithm>
#include <cmath>

#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

using possession::State;

struct Possession {
  static constexpr auto id = "possession", version = "1.0.0", summary = "Who is at the ball: us, them, none or a fight";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON;
  State who = State::us;
  possession::Rule rule;
  double likely = 0.5;
  static constexpr std::array<const char*, 4> states{"us", "them", "none", "fight"};
  static constexpr std::tuple parameters{
      regista::choice("who", &Possession::who, states,
                      "Who must be at the ball; fight: both sides; planned by SPQR. An unknown ball is none of the "
                      "four"),
      regista::within(&Possession::rule,
                      regista::real("reach", &possession::Rule::reach, {0.05, 5.0}, "m",
                                    "A side is at the ball when one of its robots is so near; SPQR: 0.5")
                          .tunable(),
                      regista::real("margin", &possession::Rule::margin, {0.0, 5.0}, "m",
                                    "It stays so until all of its robots are so much farther away; our choice")
                          .tunable(),
                      regista::real("settle", &possession::Rule::settle, {0.0, 10.0}, "s",
                                    "A change counts when it has lasted so long; our choice")
                          .tunable()),
      regista::real("likely", &Possession::likely, {0.0, 1.0}, "1",
                    "Opponents whose existence is less probable do not count; our choice")
          .tunable()};

  possession::Memory memory;

  void reset(std::uint64_t) { memory.forget(); }
  bool holds(const regista::Frame& frame) { return memory.update(rule, frame.time(), nearest(frame.world())) == who; }

 private:
  std::optional<possession::Nearest> nearest(const regista::World& world) const {
    if (!world.ball_known()) return std::nullopt;
    const double x = world.ball().position[0], y = world.ball().position[1];
    double us = possession::nobody, them = possession::nobody;  // squared
    for (const int number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      if ((robot.flags & REGISTA_ROBOT_FALLEN) != 0) continue;
      const double dx = robot.pose[0] - x, dy = robot.pose[1] - y;
      us = std::min(us, dx * dx + dy * dy);
    }
    for (const regista::Opponent& opponent : world.opponents()) {
      if (opponent.weight < likely) continue;
      const double dx = opponent.position[0] - x, dy = opponent.position[1] - y;
      them = std::min(them, dx * dx + dy * dy);
    }
    return possession::Nearest{std::sqrt(us), std::sqrt(them)};
  }
};

}  // namespace

REGISTA_PLUGIN(Possession, regista::context)
