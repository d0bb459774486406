// SPDX-License-Identifier: MIT
#include "match/sensing.hpp"

#include <regista/abi.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "mind/landmarks.hpp"

namespace regista::match {
namespace {

float squared(double value) { return static_cast<float>(value * value); }

// Keeps `list` sorted by distance while it grows; lists are short.
template <class List, class Item>
void insert_by_distance(List& list, const Item& item) {
  list.push_back(item);
  const double distance = item.position.squaredNorm();
  std::size_t place = list.size() - 1;
  while (place > 0 && list[place - 1].position.squaredNorm() > distance) {
    list[place] = list[place - 1];
    --place;
  }
  list[place] = item;
}

// `v` turned by `angle`: a true rotation by 2 atan(t), where t is tan(angle / 2) but for terms of the fifth order.
Vector turned_little(Vector v, double angle) {
  const double t = angle / 2.0 * (1.0 + angle * angle / 12.0), scale = 1.0 / (1.0 + t * t);
  return turned(v, (1.0 - t * t) * scale, 2.0 * t * scale);
}

}  // namespace

Marks::Marks(const config::FieldSize& field, const config::Camera& camera) : kind{}, squared_range{}, probability{} {
  for (const regista_landmark& landmark : mind::landmarks(field)) {
    const bool post = landmark.kind == REGISTA_LANDMARK_GOAL_POST;
    const std::size_t i = points.count++;
    points.x[i] = static_cast<float>(landmark.x);
    points.y[i] = static_cast<float>(landmark.y);
    kind[i] = landmark.kind;
    squared_range[i] = squared(post ? camera.landmark_range : camera.line_range);
    probability[i] = post ? camera.landmark_probability : camera.line_probability;
  }
}

Sensing::Sensing(const config::Robot& profile, const config::Disturbance& disturbance, const Marks& marks,
                 Roster roster, int id, std::uint64_t seed, double robot_radius)
    : profile_(profile),
      disturbance_(disturbance),
      marks_(marks),
      roster_(roster),
      id_(id),
      seed_(seed),
      side_(roster.side(id)),
      number_(roster.number(id)),
      squared_radius_(squared(robot_radius)),
      squared_ball_range_(squared(profile.camera.ball_range)),
      sector_{0.0f, 0.0f, 1.0f, 0.0f, static_cast<float>(std::cos(profile.camera.half_angle))} {
  squared_robot_range_.fill(squared(profile.camera.robot_range));
  squared_robot_range_[static_cast<std::size_t>(id)] = -1.0f;  // never itself
  Chance chance(seed_, Purpose::odometry_scale, side_, number_, 0, 0);
  scale_ = 1.0 + profile.odometry.scale_bias * chance.normal();
}

void Sensing::put_down(const mind::Pose& world, double direction, std::uint32_t tick) {
  const config::Odometry& odometry = profile_.odometry;
  Chance chance(seed_, Purpose::placing, side_, number_, 0, tick);
  mind::Pose pose = in_field_frame(world, direction);
  pose.x += odometry.placing_noise * chance.normal();
  pose.y += odometry.placing_noise * chance.normal();
  pose.heading = wrapped(pose.heading + odometry.placing_turn_noise * chance.normal());
  placed_ = mind::PlacedPose{pose, odometry.placing_noise, odometry.placing_turn_noise};
  lifted_ = true;
}

void Sensing::look(double yaw) { wanted_head_ = std::clamp(yaw, -profile_.camera.head_yaw, profile_.camera.head_yaw); }

void Sensing::sense(const Truth& truth, double time, std::uint32_t tick, bool able, mind::Percepts& out) {
  const BodyState& own = truth.own;
  out.placed.reset();
  placed_.swap(out.placed);
  measure_motion(own, tick, out);
  turn_head(time);
  out.balls.clear();
  out.robots.clear();
  out.landmarks.clear();
  out.camera = able;
  out.view = {head_, profile_.camera.half_angle, profile_.camera.ball_range, profile_.camera.robot_range};
  if (!able) return;

  const Vector axis = turned({own.cosine, own.sine}, head_cosine_, head_sine_);
  sector_ = {own.x, own.y, static_cast<float>(axis.x), static_cast<float>(axis.y), sector_.cosine};
  offsets(truth.robots, sector_, robots_);
  see_ball(truth, tick, out);
  see_robots(own, tick, out);
  see_landmarks(own, tick, out);
}

// Motion since the last decision in the frame of then. Standing costs no chance, and no error.
void Sensing::measure_motion(const BodyState& own, std::uint32_t tick, mind::Percepts& out) {
  out.odometry = {};
  const Vector position{own.x, own.y};
  if (!lifted_) {
    const Vector moved = turned(position - last_position_, last_cosine_, -last_sine_);
    const double rotated = own.heading - last_heading_;
    if (moved.x != 0.0 || moved.y != 0.0 || rotated != 0.0) {
      Chance chance(seed_, Purpose::odometry, side_, number_, 0, tick);
      const double stretch = scale_ * (1.0 + profile_.odometry.distance_noise * chance.normal());
      const double turn_stretch = 1.0 + profile_.odometry.turn_noise * chance.normal();
      out.odometry = {stretch * moved.x, stretch * moved.y, turn_stretch * rotated};
    }
  }
  lifted_ = false;
  last_position_ = position;
  last_heading_ = own.heading;
  last_cosine_ = own.cosine;
  last_sine_ = own.sine;
}

void Sensing::turn_head(double time) {
  const double most = profile_.camera.head_speed * (time - head_time_);
  head_time_ = time;
  if (head_ == wanted_head_) return;
  head_ += std::clamp(wanted_head_ - head_, -most, most);
  head_cosine_ = std::cos(head_);
  head_sine_ = std::sin(head_);
}

// Noise on a true offset (world frame, with its squared length), given in the robot frame.
Sensing::Sighting Sensing::measured(const BodyState& own, float x, float y, float squared, Chance& chance) const {
  const config::Camera& camera = profile_.camera;
  const double stretch = 1.0 + camera.distance_noise * chance.normal();
  const double bearing = camera.bearing_noise * chance.normal();
  const Vector position = stretch * turned_little(turned({x, y}, own.cosine, -own.sine), bearing);
  const double distance = std::sqrt(static_cast<double>(squared));
  return {{position.x, position.y}, camera.distance_noise * distance, camera.bearing_noise * distance};
}

void Sensing::see_ball(const Truth& truth, std::uint32_t tick, mind::Percepts& out) const {
  const config::Camera& camera = profile_.camera;
  const float x = static_cast<float>(truth.ball.x) - sector_.x, y = static_cast<float>(truth.ball.y) - sector_.y;
  const float distance_squared = x * x + y * y, ahead = x * sector_.axis_x + y * sector_.axis_y;
  if (distance_squared <= squared_ball_range_ &&
      signed_square(ahead) >= signed_square(sector_.cosine) * distance_squared &&
      !hidden(x, y, robots_, squared_radius_)) {
    Chance chance(seed_, Purpose::ball, side_, number_, 0, tick);
    bool seen = chance.bernoulli(camera.ball_probability);
    if (seen && disturbance_.ball_blindness > 0.0) {
      Chance blindness(seed_, Purpose::ball_blindness, side_, number_, 0, tick);
      seen = !blindness.bernoulli(disturbance_.ball_blindness);
    }
    if (seen) {
      const Sighting sighting = measured(truth.own, x, y, distance_squared, chance);
      out.balls.push_back({sighting.position, sighting.along, sighting.across});
    }
  }
  if (camera.false_balls_per_frame <= 0.0) return;
  Chance chance(seed_, Purpose::false_ball, side_, number_, 0, tick);
  if (!chance.bernoulli(camera.false_balls_per_frame)) return;
  // Anywhere in the sector with equal density.
  const double distance = camera.ball_range * std::sqrt(chance.uniform());
  const double bearing = head_ + camera.half_angle * (2.0 * chance.uniform() - 1.0);
  insert_by_distance(out.balls, mind::BallSighting{{distance * std::cos(bearing), distance * std::sin(bearing)},
                                                   camera.distance_noise * distance,
                                                   camera.bearing_noise * distance});
}

void Sensing::see_robots(const BodyState& own, std::uint32_t tick, mind::Percepts& out) const {
  for (std::uint32_t set = inside(robots_, sector_, squared_robot_range_); set != 0; set &= set - 1) {
    const std::size_t i = static_cast<std::size_t>(std::countr_zero(set));
    const int id = static_cast<int>(i);
    Chance chance(seed_, Purpose::robot, side_, number_, id, tick);
    if (!chance.bernoulli(profile_.camera.robot_probability)) continue;
    if (hidden(robots_.x[i], robots_.y[i], robots_, squared_radius_)) continue;
    const Sighting sighting = measured(own, robots_.x[i], robots_.y[i], robots_.squared[i], chance);
    insert_by_distance(
        out.robots, mind::RobotSighting{sighting.position, sighting.along, sighting.across, roster_.side(id) == side_});
  }
}

void Sensing::see_landmarks(const BodyState& own, std::uint32_t tick, mind::Percepts& out) const {
  Offsets marks;
  offsets(marks_.points, sector_, marks);
  for (std::uint32_t set = inside(marks, sector_, marks_.squared_range); set != 0; set &= set - 1) {
    const std::size_t i = static_cast<std::size_t>(std::countr_zero(set));
    if (hidden(marks.x[i], marks.y[i], robots_, squared_radius_)) continue;
    Chance chance(seed_, Purpose::landmark, side_, number_, static_cast<int>(i), tick);
    if (!chance.bernoulli(marks_.probability[i])) continue;
    const Sighting sighting = measured(own, marks.x[i], marks.y[i], marks.squared[i], chance);
    insert_by_distance(out.landmarks,
                       mind::LandmarkSighting{marks_.kind[i], sighting.position, sighting.along, sighting.across});
  }
}

}  // namespace regista::match
