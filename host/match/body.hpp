// SPDX-License-Identifier: MIT
// One robot's body: what becomes of a command. It walks in steps within its limits, kicks with delay and noise, falls
// when it is jostled and gets up again. It decides what the body wants; the arena decides what becomes of that.
//
// Walk: a command takes effect at the next step. Speeds ahead, sideways and of turning share one ellipsoid of limits.
// Kick: begins at once if the ball is in reach, hits `impact` later if it is in reach then, and the robot stands until
// it is over. The ball rolls a distance with triangular relative noise, in a direction with normal noise.
// Fall: a rate per second of contact with other robots, and one per minute of walking. When it will fall by itself is
// drawn ahead, as seconds of walking. Each attempt to get up may fail.
#pragma once

#include <cstdint>
#include <optional>

#include "config/robot.hpp"
#include "match/geometry.hpp"
#include "match/side.hpp"
#include "mind/command.hpp"

namespace regista::match {

// `wanted` scaled back onto the ellipsoid of what the profile's robot can do.
mind::Walk within_limits(const mind::Walk& wanted, const config::Walk& limits);

// Speed with which a ball must leave to roll so far, m/s.
double speed_for_distance(double distance, double rolling_deceleration);

class Body {
 public:
  // Profile and names are the caller's and must live as long. rolling_deceleration: of the ball, m/s^2.
  Body(const config::Robot& profile, double rolling_deceleration, std::uint64_t seed, Side side, int number);

  // A new command, checked to be finite. ball_distance: between the centres.
  void command(const mind::Command& command, double time, double ball_distance);

  // What the body wants in the coming physics step.
  struct Motion {
    mind::Walk walk;                      // robot frame
    std::optional<Vector> ball_velocity;  // robot frame: the moment of a kick
  };
  Motion move(double time, std::uint32_t tick, double ball_distance);

  // It touched another robot during the last physics step.
  void jostled(double time, std::uint32_t tick);

  // Put down by hand: it stands, and nothing is under way.
  void put_down();

  // From now on it moves with this part of the speed it means to have.
  void set_speed(double factor) { speed_ = factor; }

  // Frozen, it stands, or lies as it falls, and nothing is under way; commands are not given to it. Thawed, it gets up.
  void freeze(double time);
  void thaw(double time);

  bool fallen(double time) const { return time < up_at_; }
  // As far as it knows: that the present attempt to get up will fail, it does not.
  double time_until_up(double time) const;
  bool kicking() const { return kick_.has_value(); }
  // The teammate that the kick under way is meant for, 0 = nobody.
  int receiver() const { return kick_ ? kick_->request.receiver : 0; }
  int falls() const { return falls_; }

 private:
  struct Kick {
    mind::KickRequest request;
    double began;
    bool hit = false;  // the moment of impact is over
  };
  void fall(double time);
  void lie(double time);
  void draw_walk();
  Vector launch(const mind::KickRequest& request, std::uint32_t tick) const;

  const config::Robot& profile_;
  double rolling_deceleration_;
  std::uint64_t seed_;
  Side side_;
  int number_;
  mind::Walk commanded_, walk_;
  double speed_ = 1.0;
  bool frozen_ = false;
  double next_step_ = 0.0;
  std::optional<Kick> kick_;
  double up_at_ = -1.0;
  double walk_left_ = 0.0;  // s of walking until it falls by itself
  int falls_ = 0;
};

}  // namespace regista::match
