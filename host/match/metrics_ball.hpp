// SPDX-License-Identifier: MIT
// Who is at the ball, who goes there, and whether anybody does: while the ball is in play, of truth and of what robots
// decided last. docs/metrics.md has the definitions.
//
// Able: active, stands, and has not crashed.
// A robot goes for the ball when its role plays the ball, or its target lies within 0.3 m of the ball, or it asks for a
// kick. One whose behaviour announces a target of its own does so by that target or a kick alone.
// - nearest plays: of the able robots of a team, the one nearest to the ball (the first of equals) goes for it.
// - near: active robots within 1 m of the ball. Crowd: five or more of both teams.
// - chased by several: two or more able robots of a team go for the ball.
// - rest: the ball is slower than 0.05 m/s, and some able robot of either team could touch it within 3 s: at full
//   forward speed, straight, until its body is there. One rest lasts as long as that holds without a break; set plays
//   between two samples do not end it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "match/arena.hpp"
#include "match/game_state.hpp"
#include "match/geometry.hpp"
#include "match/side.hpp"

namespace regista::match {

constexpr double near_ball = 1.0;     // m
constexpr double for_the_ball = 0.3;  // m; assumption: a target so near to the ball is the ball
constexpr double at_rest = 0.05;      // m/s; assumption: it stops within half a centimetre
constexpr double soon = 3.0;          // s; assumption: who needs longer has not neglected the ball
constexpr int crowd = 5;              // robots
constexpr double long_rest = 15.0;    // s; assumption

struct BallMetrics {
  std::optional<double> nearest_plays_share;  // nothing where no robot was ever able
  std::optional<double> robots_near;          // mean; nothing where the ball was never in play
  double chased_by_several_seconds = 0.0;
};

struct BallRests {
  double seconds = 0.0;          // all of them
  int count = 0, long_ones = 0;  // long: over 15 s
  double longest_seconds = 0.0;
};

class BallMeasures {
 public:
  BallMeasures(int team_size, const std::array<config::Robot, 2>& robots);

  // A robot has decided. plays: its role plays the ball, and it announces no target; kicks: it asks for a kick; target:
  // in the field frame of its side.
  void decided(int id, bool plays, bool kicks, std::optional<Vector> target) {
    decisions_[static_cast<std::size_t>(id)] = {plays, kicks, target};
  }

  // Ten times in a second while the ball is in play. Bodies: robots by id, then the ball. able: of the robots that are
  // not penalised, too.
  void sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able);

  // Which of the able robots go for the ball, by their last decisions. able: as above.
  RobotSet chasing(const GameState& state, const BodyState& ball, RobotSet able) const;

  BallMetrics result(Side side) const;
  BallRests rests() const;
  double crowd_seconds() const;

 private:
  struct Decision {
    bool plays = false, kicks = false;
    std::optional<Vector> target;
    bool goes_for(const Vector& ball) const;
  };
  struct Team {
    int near = 0;                                     // robots, summed over samples
    int nearest = 0, nearest_plays = 0, several = 0;  // samples
  };
  Roster roster_;
  std::array<double, 2> within_reach_;  // m, by side: from there a robot is at the ball soon
  std::vector<Decision> decisions_;     // by id
  std::array<Team, 2> teams_;
  int samples_ = 0, crowd_ = 0;
  int rest_ = 0, rests_ = 0, long_rests_ = 0, longest_rest_ = 0;
  int resting_ = 0;  // samples of the rest that lasts
};

}  // namespace regista::match
