// SPDX-License-Identifier: MIT
// The soccer of a match, out of the course of the ball, of touches and of the referee's calls, in the phase Playing.
// docs/metrics.md has the formulas.
//
// - Shot: after a touch the ball would roll, if nobody touched it again, all of it over the opponent's goal line
// between
//   the posts: the line is within the distance v^2 / (2 a) that it can roll. One shot lasts until the ball is no longer
//   on such a course, or is dead; touches that leave it there are part of it.
// - Scored: a goal that counts ended it. Saved: the touch of an opponent turned the ball away.
// - Pass: the next robot that touches the ball after one of a team is another of that team, more than 0.5 m from the
//   place of the last touch. Interception: it is one of the other team, and no shot was saved by it.
// - Meant pass: a kick of which the behaviour said that it is meant for a teammate. It arrives when the next robot but
//   the kicker to touch the ball is a teammate, and is intercepted when it is an opponent. When the kicker kicks again
//   before, or the ball is dead, it does neither.
// - Territory: where the ball is, in the field frame of the team, while it is in play.
// - Distance walked: the way of the bodies of robots that are not penalised.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "config/rules.hpp"
#include "match/arena.hpp"
#include "match/game_state.hpp"
#include "match/side.hpp"

namespace regista::match {

constexpr double shortest_pass = 0.5;  // m; assumption: twice what separates a dribbling robot from its ball

struct PlayMetrics {
  int shots = 0, shots_scored = 0, shots_saved = 0;
  int passes = 0, interceptions = 0;
  int meant_passes = 0, meant_passes_arrived = 0, meant_passes_intercepted = 0;
  std::optional<double> possession_share;     // of the time that either team had the ball
  double possession_seconds = 0.0;            // ball in play and last touched by this team
  std::optional<double> ball_x_metres;        // mean; nothing while the ball was never in play
  std::optional<double> opponent_half_share;  // of the time in play
  double distance_walked_metres = 0.0;        // of all robots
  std::vector<double> robot_distance_metres;  // by robot (n - 1)
};

class PlayMeasures {
 public:
  explicit PlayMeasures(const config::Rules& rules);

  // After each physics step in the phase Playing, before the referee judges it: the ball now, and the robot that
  // touched it (id; -1: nobody). half: see attack().
  void step(const BodyState& ball, int touched_by, int half);

  // Robot `id` has kicked the ball; before the step that moves it. receiver: 0 = nobody.
  void kicked(int id, int receiver);
  void scored(Side side);  // a goal that counts
  void ball_placed();      // somebody put it down: what went before is over

  // Ten times in a second of the phase Playing. Bodies: robots by id, then the ball. in_play: no set play.
  // last_touch: of the ball, by which side; nothing before the first.
  void sample(const GameState& state, std::span<const BodyState> bodies, std::optional<Side> last_touch);

  PlayMetrics result(Side side) const;

 private:
  struct Team {
    int shots = 0, scored = 0, saved = 0, passes = 0, interceptions = 0;
    int meant = 0, arrived = 0, intercepted = 0;  // meant passes
    int possession = 0, in_opponent_half = 0;     // samples
    double ball_x = 0.0;                          // sum over samples in play
  };
  struct Ball {
    Vector position, velocity;
  };
  struct Touch {
    int robot;  // id
    Vector ball;
  };
  void touched(int robot, const Ball& ball, int half);
  bool on_target(Side side, const Ball& ball, int half) const;
  Team& team(Side side) { return teams_[index(side)]; }

  Roster roster_;
  double goal_line_, half_goal_, deceleration_;  // all of the ball is behind the goal line: x of its centre
  std::array<Team, 2> teams_;
  std::vector<double> walked_;  // by id, m
  int in_play_ = 0;             // samples
  Ball ball_;                   // after the last step
  std::optional<Touch> last_;
  std::optional<Side> shot_;   // a shot of this side is under way
  std::optional<int> passer_;  // id of who meant to pass the ball, until somebody else has it
};

}  // namespace regista::match
