// SPDX-License-Identifier: MIT
// Body turns the commands of one robot into motion, kicks and falls. PhysicsWorld then moves the robot and the ball.
//
// Walk: a walk command takes effect at the robot's next footstep. One ellipsoid limits walking and turning speed.
// Kick: a kick begins at once if the ball is in reach. After `impact` seconds the foot hits the ball if the ball is
// still in reach. The robot stands still until the kick is over. The relative noise of the rolling distance has a
// triangular law. The noise of the direction has a normal law.
// Fall: contact with robots causes falls at a rate per second of contact. Walking causes falls at a rate per minute.
// Body draws the walking time until the next fall in advance. Each attempt of the robot to get up may fail.
#pragma once

#include <cstdint>
#include <optional>

#include "config/robot.hpp"
#include "match/plane.hpp"
#include "match/side.hpp"
#include "mind/action.hpp"

namespace regista::match {

// Scales `wanted` down onto the ellipsoid of speeds that a robot with these limits can reach.
mind::Walk within_limits(const mind::Walk& wanted, const config::Walk& limits);

// Initial speed (m/s) of a ball that rolls `distance` metres before it stops.
double speed_for_distance(double distance, double rolling_deceleration);

class Body {
 public:
  // The caller owns `profile`, which must outlive the body. rolling_deceleration: of the rolling ball, m/s^2.
  Body(const config::Robot& profile, double rolling_deceleration, std::uint64_t seed, Side side, int number);

  // Gives the body a new command. All values must be finite. ball_distance: m between the centres of robot and ball.
  void command(const mind::Command& command, double time, double ball_distance);

  // The motion that the body makes in the coming physics step, unless PhysicsWorld hinders the body.
  struct Motion {
    mind::Walk walk;                      // robot frame
    std::optional<Vector> ball_velocity;  // robot frame; set only in the step in which the foot hits the ball
  };
  Motion move(double time, std::uint32_t tick, double ball_distance);

  // Must be called when the robot has touched another robot in the last physics step. The robot may then fall.
  void jostled(double time, std::uint32_t tick);

  void put_down();  // A person puts the robot down: the robot stands, and its walk, kick or fall is cancelled.

  // From now on the robot walks at `factor` times the commanded speed.
  void set_speed(double factor) { speed_ = factor; }

  // freeze(): the robot stands still from now on; a robot that lies or falls stays down until thaw(). The caller must
  // not call command() for a frozen robot. thaw(): ends freeze(); a lying robot begins to get up.
  void freeze(double time);
  void thaw(double time);

  bool fallen(double time) const { return time < up_at_; }
  // Seconds until the end of the robot's current attempt to get up. The robot does not know whether the attempt fails.
  double time_until_up(double time) const;
  bool kicking() const { return kick_.has_value(); }
  // Shirt number of the teammate that the current kick is meant for; 0 = nobody.
  int receiver() const { return kick_ ? kick_->request.receiver : 0; }
  int falls() const { return falls_; }

 private:
  struct Kick {
    mind::KickRequest request;
    double began;
    bool hit = false;  // the moment of impact has passed, whether or not the foot hit the ball
  };
  void fall(double time);
  void lie(double time);  // the robot begins to get up at `time`
  void draw_walk();       // draws walk_left_
  Vector launch(const mind::KickRequest& request, std::uint32_t tick) const;

  const config::Robot& profile_;
  double rolling_deceleration_;
  std::uint64_t seed_;
  Side side_;
  int number_;
  mind::Walk commanded_, walk_;  // walk_: the command in force since the last footstep; commanded_: the latest command
  double speed_ = 1.0;
  bool frozen_ = false;
  double next_step_ = 0.0;  // match time of the robot's next footstep, s
  std::optional<Kick> kick_;
  double up_at_ = -1.0;     // match time at which the fallen robot stands again, s
  double walk_left_ = 0.0;  // s of walking until the next fall caused by walking
  int falls_ = 0;
};

}  // namespace regista::match
