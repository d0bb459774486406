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
//   the kicker to touch or kick the ball is a teammate, and is intercepted when it is an opponent. When the kicker
//   kicks again before, or the ball is dead, it does neither.
// - Clearance: see clearances.hpp. Duel: see duels.hpp.
// - Territory: where the ball is, in the field frame of the team, while it is in play.
// - Distance walked: the way of the bodies of robots that are not penalised.
//
// Each shot, meant pass, clearance and duel that is counted is told once it is decided what became of it; at the end of
// the match those that are under way are.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "config/rules.hpp"
#include "match/arena.hpp"
#include "match/clearances.hpp"
#include "match/duels.hpp"
#include "match/game_state.hpp"
#include "match/play_event.hpp"
#include "match/side.hpp"

namespace regista::match {

constexpr double shortest_pass = 0.5;  // m; assumption: twice what separates a dribbling robot from its ball

struct PlayMetrics {
  int shots = 0, shots_scored = 0, shots_saved = 0;
  int passes = 0, interceptions = 0;
  int meant_passes = 0, meant_passes_arrived = 0, meant_passes_intercepted = 0;
  int clearances = 0, duels_won = 0;
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

  void tell(PlayTeller tell) { tell_ = std::move(tell); }
  void now(double time) { now_ = time; }  // s of match time; what follows happens then

  // After each physics step in the phase Playing, before the referee judges it: the ball now, and the robot that
  // touched it (id; -1: nobody). half: see attack().
  void step(const BodyState& ball, int touched_by, int half);

  // Robot `id` has kicked the ball; before the step that moves it. receiver: 0 = nobody.
  void kicked(int id, int receiver);
  void scored(Side side);  // a goal that counts
  void ball_placed();      // somebody put it down: what went before is over

  // Ten times in a second of the phase Playing. Bodies: robots by id, then the ball. in_play: no set play.
  // last_touch: of the ball, by which side; nothing before the first. able: of the robots that are not penalised, too.
  void sample(const GameState& state, std::span<const BodyState> bodies, std::optional<Side> last_touch, RobotSet able);

  void finish();  // the match has ended

  PlayMetrics result(Side side) const;
  int duels() const { return duel_count_; }

 private:
  struct Team {
    int shots = 0, scored = 0, saved = 0, passes = 0, interceptions = 0;
    int meant = 0, arrived = 0, intercepted = 0;  // meant passes
    int clearances = 0, duels_won = 0;
    int possession = 0, in_opponent_half = 0;  // samples
    double ball_x = 0.0;                       // sum over samples in play
  };
  struct Ball {
    Vector position, velocity;
  };
  struct Touch {
    int robot;  // id
    Vector ball;
  };
  // What is under way: who began it, when, and where the ball was.
  struct Begun {
    int robot;  // id
    double began;
    Vector at;
    int receiver = 0;
  };
  void touched(int robot, const Ball& ball, int half);
  void end_shot(PlayOutcome outcome);
  void end_pass(PlayOutcome outcome);
  void pass_met_by(int robot);  // touches or kicks the ball
  void end_duel(const std::optional<Duels::Duel>& duel);
  void tell(PlayKind kind, const Begun& begun, PlayOutcome outcome) const;
  bool on_target(Side side, const Ball& ball, int half) const;
  Team& team(Side side) { return teams_[index(side)]; }

  Roster roster_;
  double goal_line_, half_goal_, deceleration_;  // all of the ball is behind the goal line: x of its centre
  std::array<Team, 2> teams_;
  std::vector<double> walked_;  // by id, m
  int in_play_ = 0;             // samples
  int duel_count_ = 0;
  PlayTeller tell_;
  double now_ = 0.0;
  int half_ = 1;  // of the last step
  Ball ball_;     // after the last step
  std::optional<Touch> last_;
  std::optional<Begun> shot_, pass_;  // a meant pass, until somebody else has it
  Clearances clearances_;
  Duels duels_;
};

}  // namespace regista::match
