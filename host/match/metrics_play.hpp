// SPDX-License-Identifier: MIT
// Computes the soccer numbers of a match in the phase Playing from ball motion, touches and calls of the referee.
// metric_table.cpp defines each number; `a` in its texts is the deceleration of the rolling ball.
//
// PlayMeasures reports each shot, meant pass, clearance and duel when its outcome is known or the match ends.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/physics_world.hpp"
#include "match/side.hpp"

namespace regista::match {

struct Begun {   // a play that has begun
  int robot;     // id
  double began;  // match time, s
  Vector at;     // position of the ball at that time
  int receiver = 0;
};

constexpr double cleared_way = 2.0;  // m towards the opponents' goal; assumption: a dribble pushes the ball less far

// Detects clearances: kicks out of the team's own third of the field (an assumption, see metric_table.cpp).
class Clearances {
 public:
  explicit Clearances(const config::FieldSize& field) : length_(field.length) {}

  // Robot `id` has kicked the ball, which may become a clearance: the pending kick. direction of attack: +1 or -1.
  void kicked(int id, Vector ball, double direction, double time);
  void touched(int id) {
    if (kick_ && kick_->robot != id) kick_.reset();
  }
  void drop() { kick_.reset(); }  // forgets the pending kick, as it was a pass or a shot, or as the ball is dead

  // Must be called with each new ball position. Returns the pending kick if the position makes it a clearance.
  std::optional<Begun> rolled(Vector ball);

 private:
  double to_goal(Vector ball) const { return length(direction_ * ball + Vector{length_ / 2.0, 0.0}); }

  double length_, direction_ = 1.0;  // direction_: attack direction of the kicking side
  std::optional<Begun> kick_;        // pending kick: may become a clearance; empty: no such kick
};

constexpr double duel_reach = 0.5;     // m from the ball; assumption: two steps of a robot
constexpr double shortest_duel = 1.0;  // s; assumption: two robots that only pass each other need less time

// Detects duels. The condition of a duel: able robots of both teams are within duel_reach of the ball. The duel is
// between the robot of each team that was nearest to the ball when the condition became true. The first touch after the
// condition has become false decides the duel. If the condition is true again before a touch, the same duel goes on. A
// duel is undecided if the ball is dead before the deciding touch. A duel shorter than shortest_duel does not count.
class Duels {
 public:
  explicit Duels(int team_size) : roster_{team_size} {}

  struct Duel {
    std::array<int, 2> robots{};  // by side: id of the robot in the duel
    Side nearer = Side::home;     // side whose robot was nearer to the ball at the beginning
    double began = 0.0;           // match time, s
    Vector at;                    // position of the ball at the beginning
    int samples = 0;              // number of samples in which the condition was true
    std::optional<Side> won;      // side that won; nothing: undecided
  };

  // Must be called ten times a second while the ball is in play. able: active robots that stand and have not crashed.
  void sample(std::span<const BodyState> bodies, RobotSet able, double time);
  // The next three functions return the duel that the event ends; nothing if no duel ends.
  std::optional<Duel> touched(Side side) { return holds_ ? std::nullopt : ended(side); }
  std::optional<Duel> scored(Side side) { return ended(side); }
  std::optional<Duel> dead() { return ended(std::nullopt); }  // the ball is dead or the match has ended

 private:
  std::optional<Duel> ended(std::optional<Side> won);

  Roster roster_;
  std::optional<Duel> duel_;
  bool holds_ = false;  // the condition was true in the last sample
};

constexpr double shortest_pass = 0.5;  // m; assumption: a dribbling robot keeps the ball within half of this

struct PlayMetrics {
  int shots = 0, shots_scored = 0, shots_saved = 0;
  int passes = 0, interceptions = 0;
  int meant_passes = 0, meant_passes_arrived = 0, meant_passes_intercepted = 0;
  int clearances = 0, duels_won = 0;
  std::optional<double> possession_share;     // possession_seconds / the sum of both teams' values
  double possession_seconds = 0.0;            // time in play after a touch by this team
  std::optional<double> ball_x_metres;        // mean x of the ball, towards the opponents' goal; nothing: never in play
  std::optional<double> opponent_half_share;  // share of the time in play with the ball in the opponents' half
  double goal_empty_seconds = 0.0;            // time in play without an able robot in the own penalty area
  double distance_walked_metres = 0.0;        // sum over all robots
  std::vector<double> robot_distance_metres;  // by robot (n - 1)
};

class PlayMeasures {
 public:
  explicit PlayMeasures(const config::Rules& rules);

  void tell(PlayTeller tell) { tell_ = std::move(tell); }
  void now(double time) { now_ = time; }  // match time of the following calls, s

  // The caller calls this after each physics step in Playing, before the referee judges the step. touched_by: id of the
  // robot that touched the ball; -1: nobody. half: half of the match, from 1.
  void step(const BodyState& ball, int touched_by, int half);

  // Robot `id` has kicked the ball, before the step that moves it. receiver: of a meant pass, shirt number; else 0.
  void kicked(int id, int receiver);
  void scored(Side side);  // a goal that counts
  void ball_placed();      // a person puts the ball down, which ends all present plays

  // Must be called ten times a second in Playing. bodies: robots by id, then the ball. last_touch: side of the last
  // touch; nothing before a touch. able: robots that stand and have not crashed; penalised robots are ignored.
  void sample(const GameState& state, std::span<const BodyState> bodies, std::optional<Side> last_touch, RobotSet able);

  void finish();  // the match has ended

  PlayMetrics result(Side side) const;
  int duels() const { return duel_count_; }

 private:
  struct Team {
    PlayMetrics counts;                                        // numbers of shots, passes, ...
    int possession = 0, in_opponent_half = 0, goal_empty = 0;  // numbers of samples
    double ball_x = 0.0;                                       // sum over samples in play
  };
  struct Ball {
    Vector position, velocity;
  };
  struct Touch {
    int robot;  // id
    Vector ball;
  };
  void touched(int robot, const Ball& ball, int half);
  void end(std::optional<Begun>& play, PlayOutcome outcome);  // play: shot_ or pass_
  void pass_met_by(int robot);  // ends the meant pass if another robot touches or kicks the ball
  void end_duel(const std::optional<Duels::Duel>& duel);
  void tell(PlayKind kind, const Begun& begun, PlayOutcome outcome) const;
  bool on_target(Side side, const Ball& ball, int half) const;
  PlayMetrics& counts(Side side) { return teams_[index(side)].counts; }

  Roster roster_;
  config::FieldSize field_;
  // goal_line_: |x| of the ball's centre at which the whole ball is behind the goal line, m. half_goal_: half the
  // goal's width, m. deceleration_: of the rolling ball, m/s^2.
  double goal_line_, half_goal_, deceleration_;
  std::array<Team, 2> teams_;
  std::vector<double> walked_;  // by id, m
  int in_play_ = 0;             // number of samples in play
  int duel_count_ = 0;
  PlayTeller tell_;
  double now_ = 0.0;
  int half_ = 1;  // half of the last step
  Ball ball_;     // state after the last step
  std::optional<Touch> last_;
  std::optional<Begun> shot_, pass_;  // pass_: a meant pass that no other robot has touched
  Clearances clearances_;
  Duels duels_;
};

// --- BallMeasures measures how robots chase the ball and how long they neglect the ball, while the ball is in play. It
// uses true positions and the last decisions of the robots. metric_table.cpp defines each number.
//
// An able robot is active, stands, and has not crashed. A robot goes for the ball if its role plays the ball, its
// target lies within 0.3 m of the ball, or it asks for a kick. If the robot's behaviour announces a target, the role
// does not count, and the announced target replaces the role's target.
//
// The ball rests if it is slower than 0.05 m/s and an able robot of either team could touch it within 3 s by walking
// straight at full forward speed. A rest lasts until this condition ends. A set play between two samples ends no rest.

constexpr double near_ball = 1.0;     // m; a robot within this distance of the ball is near the ball
constexpr double for_the_ball = 0.3;  // m; assumption: a robot goes to the ball if its target is within this distance
constexpr double at_rest = 0.05;      // m/s; assumption: a slower ball stops within half a centimetre
constexpr double soon = 3.0;          // s; assumption: a robot that needs more time to the ball does not neglect it
constexpr int crowd = 5;              // number of robots near the ball that make a crowd
constexpr double long_rest = 15.0;    // s; assumption: a rest is long if it lasts more than this time

struct BallMetrics {
  std::optional<double> nearest_plays_share;  // the nearest able robot goes for the ball; nothing: no robot was able
  std::optional<double> robots_near;          // mean number near the ball; nothing: the ball was never in play
  double chased_by_several_seconds = 0.0;
};

struct BallRests {
  double seconds = 0.0;          // sum of all rests
  int count = 0, long_ones = 0;  // long_ones: number of rests over 15 s
  double longest_seconds = 0.0;
};

class BallMeasures {
 public:
  BallMeasures(int team_size, const std::array<config::Robot, 2>& robots);

  // The caller calls this after each decision. plays: the robot's role plays the ball, and the behaviour announces no
  // target. kicks: the robot asks for a kick. target: in the field frame of the robot's side.
  void decided(int id, bool plays, bool kicks, std::optional<Vector> target) {
    decisions_[at(id)] = {plays, kicks, target};
  }

  // Must be called ten times a second while the ball is in play. bodies, able: as in PlayMeasures::sample().
  void sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able);

  // Returns the robots of `able` that go for the ball, by their last decisions. able: as in sample().
  RobotSet chasing(const GameState& state, const BodyState& ball, RobotSet able) const;

  BallMetrics result(Side side) const;
  BallRests rests() const;
  double crowd_seconds() const;

 private:
  struct Decision {
    bool plays = false, kicks = false;
    std::optional<Vector> target;
  };
  struct Team {
    int near = 0;                                     // sum over samples of the number of robots near the ball
    int nearest = 0, nearest_plays = 0, several = 0;  // numbers of samples
  };
  Roster roster_;
  std::array<double, 2> within_reach_;  // by side: distance from which a robot can touch the ball within 3 s, m
  std::vector<Decision> decisions_;     // by id
  std::array<Team, 2> teams_;
  int samples_ = 0, crowd_ = 0;
  int rest_ = 0, rests_ = 0, long_rests_ = 0, longest_rest_ = 0;
  int resting_ = 0;  // number of samples of the current rest
};

}  // namespace regista::match
