// SPDX-License-Identifier: MIT
#include "match/body.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "match/chance.hpp"
#include "match/physics_world.hpp"

namespace regista::match {

constexpr double never = std::numeric_limits<double>::infinity();

mind::Walk within_limits(const mind::Walk& wanted, const config::Walk& limits) {
  const auto share = [](double value, double limit) { return limit > 0.0 ? value / limit : 0.0; };
  const double along = wanted.forward >= 0.0 ? limits.forward : limits.backward;
  const double x = share(wanted.forward, along);
  const double y = share(wanted.sideways, limits.sideways);
  const double z = share(wanted.turn, limits.turn);
  const double size = x * x + y * y + z * z;
  const double scale = size > 1.0 ? 1.0 / std::sqrt(size) : 1.0;
  const auto scaled = [scale](double value, double limit) { return limit > 0.0 ? scale * value : 0.0; };
  return {scaled(wanted.forward, along), scaled(wanted.sideways, limits.sideways), scaled(wanted.turn, limits.turn)};
}

double speed_for_distance(double distance, double rolling_deceleration) {
  return std::sqrt(2.0 * rolling_deceleration * distance);
}

Body::Body(const config::Robot& profile, double rolling_deceleration, std::uint64_t seed, Side side, int number)
    : profile_(profile), rolling_deceleration_(rolling_deceleration), seed_(seed), side_(side), number_(number) {
  draw_walk();
}

void Body::command(const mind::Command& command, double time, double ball_distance) {
  if (kick_ || fallen(time)) return;
  commanded_ = command.walk;
  if (command.kick && ball_distance <= profile_.body.reach) kick_ = Kick{*command.kick, time};
}

Body::Motion Body::move(double time, std::uint32_t tick, double ball_distance) {
  Motion motion;
  const bool at_step = time >= next_step_ - instant;
  if (at_step) next_step_ = time + profile_.walk.step_period;
  if (fallen(time)) return motion;
  if (kick_) {
    const config::Kick& kind = profile_.kicks[static_cast<std::size_t>(kick_->request.kind)];
    const double since = time - kick_->began;
    if (!kick_->hit && since >= kind.impact - instant) {
      kick_->hit = true;
      if (ball_distance <= profile_.body.reach) motion.ball_velocity = launch(kick_->request, tick);
    }
    if (since < kind.duration - instant) return motion;
    kick_.reset();
    commanded_ = {};
    walk_ = {};
  }
  if (at_step) walk_ = within_limits(commanded_, profile_.walk);
  if (walk_.forward == 0.0 && walk_.sideways == 0.0 && walk_.turn == 0.0) return motion;
  walk_left_ -= physics_step;
  if (walk_left_ <= 0.0) {
    fall(time);
    return motion;
  }
  motion.walk = {speed_ * walk_.forward, speed_ * walk_.sideways, speed_ * walk_.turn};
  return motion;
}

Vector Body::launch(const mind::KickRequest& request, std::uint32_t tick) const {
  const config::Kick& kind = profile_.kicks[static_cast<std::size_t>(request.kind)];
  Chance chance(seed_, Purpose::kick, side_, number_, 0, tick);
  const double relative = 1.0 + kind.distance_noise * chance.triangular();
  const double direction = request.direction + kind.direction_noise * chance.normal();
  const double distance = std::clamp(request.distance, kind.minimum_distance, kind.maximum_distance) * relative;
  const double speed = speed_for_distance(std::max(distance, 0.0), rolling_deceleration_);
  return {speed * std::cos(direction), speed * std::sin(direction)};
}

void Body::jostled(double time, std::uint32_t tick) {
  if (fallen(time)) return;
  Chance chance(seed_, Purpose::fall, side_, number_, 0, tick);
  if (chance.bernoulli(profile_.body.falls_per_contact_second * physics_step)) fall(time);
}

void Body::fall(double time) {
  put_down();
  ++falls_;
  draw_walk();
  if (frozen_) {
    up_at_ = never;
  } else {
    lie(time);
  }
}

void Body::lie(double time) {
  Chance chance(seed_, Purpose::get_up, side_, number_, 0, static_cast<std::uint32_t>(falls_));
  up_at_ = time + profile_.body.get_up;
  while (chance.bernoulli(profile_.body.get_up_failure)) up_at_ += profile_.body.get_up;
}

// The walking time until a fall has an exponential law, because a fall is equally likely in each second of walking.
void Body::draw_walk() {
  walk_left_ = never;
  const double rate = profile_.body.falls_per_walking_minute / 60.0;
  if (rate <= 0.0) return;
  Chance chance(seed_, Purpose::stumble, side_, number_, 0, static_cast<std::uint32_t>(falls_));
  walk_left_ = -std::log(1.0 - chance.uniform()) / rate;
}

double Body::time_until_up(double time) const {
  if (!fallen(time)) return 0.0;
  const double left = std::fmod(up_at_ - time, profile_.body.get_up);
  return left > 0.0 ? left : profile_.body.get_up;
}

void Body::freeze(double time) {
  const bool lies = fallen(time);
  put_down();
  frozen_ = true;
  if (lies) up_at_ = never;
}

void Body::thaw(double time) {
  frozen_ = false;
  if (up_at_ == never) lie(time);
}

void Body::put_down() {
  commanded_ = {};
  walk_ = {};
  kick_.reset();
  up_at_ = -1.0;
}

}  // namespace regista::match
