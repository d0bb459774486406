// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the ball and the robots of the world that the team has chosen. Robots that are
// penalised, lost or fallen do not count.
#include <vector>

#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

struct NumbersNearBall {
  static constexpr auto id = "numbers_near_ball", version = "1.0.0",
                        summary = "Own robots minus opponents near the ball lie in a range; not with an unknown ball";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON;
  int least = 1, most = 100;
  double reach = 1.5, margin = 0.3, likely = 0.5;
  static constexpr std::tuple parameters{
      regista::integer(
          "least", &NumbersNearBall::least, {-100, 100}, "1",
          "Own robots minus opponents near the ball, at least; planned by SPQR; above `most`: never holds"),
      regista::integer("most", &NumbersNearBall::most, {-100, 100}, "1",
                       "Own robots minus opponents near the ball, at most"),
      regista::real("reach", &NumbersNearBall::reach, {0.05, 20.0}, "m",
                    "A robot is near when it is so near the ball; SPQR: 1.5")
          .tunable(),
      regista::real("margin", &NumbersNearBall::margin, {0.0, 20.0}, "m",
                    "It stays so until it is so much farther away; our choice")
          .tunable(),
      regista::real("likely", &NumbersNearBall::likely, {0.0, 1.0}, "1",
                    "Opponents whose existence is less probable do not count; our choice")
          .tunable()};

  numbers_near_ball::Near us, them;
  std::vector<numbers_near_ball::Body> robots;

  void setup(const regista::Environment& environment) {
    constexpr std::size_t opponents = 64;  // more than a world has; only memory depends on it
    us.reserve(environment->team_size);
    them.reserve(opponents);
    robots.reserve(std::max<std::size_t>(environment->team_size, opponents));
  }
  void reset(std::uint64_t) {
    us.forget();
    them.forget();
  }
  // A ball that nobody knows has nobody near it that one could count.
  bool holds(const regista::Frame& frame) {
    const regista::World world = frame.world();
    if (!world.ball_known()) {
      reset(0);
      return false;
    }
    const numbers_near_ball::Point ball{world.ball().position[0], world.ball().position[1]};
    robots.clear();
    for (const int number : world.active()) {
      const regista::Robot& robot = world.robot(number);
      if ((robot.flags & REGISTA_ROBOT_FALLEN) == 0) robots.push_back({number, robot.pose[0], robot.pose[1]});
    }
    const int ours = us.update(ball, robots, reach, margin);
    robots.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      if (opponent.weight >= likely) robots.push_back({opponent.label, opponent.position[0], opponent.position[1]});
    }
    const int difference = ours - them.update(ball, robots, reach, margin);
    return difference >= least && difference <= most;
  }
};

}  // namespace

REGISTA_PLUGIN(NumbersNearBall, regista::context)
