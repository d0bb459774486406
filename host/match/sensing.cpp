// SPDX-License-Identifier: MIT
#include "match/sensing.hpp"

#include <regista/abi.h>

#include <algorithm>
#include <cmath>

namespace regista::match {
namespace {

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

Eigen::Vector2d to_eigen(Vector v) { return {v.x, v.y}; }

}  // namespace

Sensing::Sensing(const config::Robot& profile, const config::Disturbance& disturbance, std::span<const Mark> marks,
                 Roster roster, int id, std::uint64_t seed, double robot_radius)
    : profile_(profile),
      disturbance_(disturbance),
      marks_(marks),
      roster_(roster),
      id_(id),
      seed_(seed),
      side_(roster.side(id)),
      number_(roster.number(id)),
      robot_radius_(robot_radius),
      cosine_half_angle_(std::cos(profile.camera.half_angle)) {
  const config::Camera& camera = profile.camera;
  largest_range_ = std::max({camera.ball_range, camera.robot_range, camera.landmark_range, camera.line_range});
  Chance chance(seed_, Purpose::odometry_scale, side_, number_, 0, 0);
  scale_ = 1.0 + profile.odometry.scale_bias * chance.normal();
  neighbours_.reserve(static_cast<std::size_t>(roster.count()));
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
  const BodyState& own = truth.states[static_cast<std::size_t>(id_)];
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

  axis_ = {std::cos(head_), std::sin(head_)};
  neighbours_.clear();
  const double most = largest_range_ * largest_range_;
  for (int id = 0; id < roster_.count(); ++id) {
    if (id == id_ || (truth.out_of_play >> id & 1u) != 0) continue;
    const BodyState& other = truth.states[static_cast<std::size_t>(id)];
    const Vector apart{static_cast<double>(other.x) - own.x, static_cast<double>(other.y) - own.y};
    const double squared = squared_length(apart);
    if (squared > most) continue;
    const Vector relative = turned(apart, own.cosine, -own.sine);
    // What is behind the camera's plane by more than a body neither is seen nor hides anything.
    if (cosine_half_angle_ > 0.0 && dot(relative, axis_) < -robot_radius_) continue;
    neighbours_.push_back({{relative, squared}, id});
  }
  see_ball(truth, tick, out);
  see_robots(tick, out);
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
  head_ += std::clamp(wanted_head_ - head_, -most, most);
  head_time_ = time;
}

// Without a square root: ahead >= cos(half angle) * distance.
bool Sensing::in_sector(const Candidate& candidate, double range) const {
  if (candidate.squared_distance > range * range) return false;
  const double ahead = dot(candidate.relative, axis_);
  const double edge = cosine_half_angle_ * cosine_half_angle_ * candidate.squared_distance;
  if (cosine_half_angle_ >= 0.0) return ahead >= 0.0 && ahead * ahead >= edge;
  return ahead >= 0.0 || ahead * ahead <= edge;
}

// Another robot stands on the line of sight, nearer than the object.
bool Sensing::hidden(const Candidate& object) const {
  const double radius = robot_radius_ * robot_radius_;
  for (const Neighbour& neighbour : neighbours_) {
    const Candidate& other = neighbour.candidate;
    if (other.squared_distance >= object.squared_distance) continue;
    if (dot(other.relative, object.relative) <= 0.0) continue;
    const double beside = cross(other.relative, object.relative);
    if (beside * beside < radius * object.squared_distance) return true;
  }
  return false;
}

Sensing::Sighting Sensing::measured(const Candidate& candidate, Chance& chance) const {
  const config::Camera& camera = profile_.camera;
  const double stretch = 1.0 + camera.distance_noise * chance.normal();
  const double bearing = camera.bearing_noise * chance.normal();
  const Vector position = stretch * turned(candidate.relative, std::cos(bearing), std::sin(bearing));
  const double distance = std::sqrt(candidate.squared_distance);
  return {position, camera.distance_noise * distance, camera.bearing_noise * distance};
}

void Sensing::see_ball(const Truth& truth, std::uint32_t tick, mind::Percepts& out) const {
  const config::Camera& camera = profile_.camera;
  const BodyState& own = truth.states[static_cast<std::size_t>(id_)];
  const BodyState& ball = truth.states.back();
  const Vector apart{static_cast<double>(ball.x) - own.x, static_cast<double>(ball.y) - own.y};
  const Candidate candidate{turned(apart, own.cosine, -own.sine), squared_length(apart)};
  if (in_sector(candidate, camera.ball_range) && !hidden(candidate)) {
    Chance chance(seed_, Purpose::ball, side_, number_, 0, tick);
    bool seen = chance.bernoulli(camera.ball_probability);
    if (seen && disturbance_.ball_blindness > 0.0) {
      Chance blindness(seed_, Purpose::ball_blindness, side_, number_, 0, tick);
      seen = !blindness.bernoulli(disturbance_.ball_blindness);
    }
    if (seen) {
      const Sighting sighting = measured(candidate, chance);
      out.balls.push_back({to_eigen(sighting.position), sighting.along, sighting.across});
    }
  }
  if (camera.false_balls_per_frame <= 0.0) return;
  Chance chance(seed_, Purpose::false_ball, side_, number_, 0, tick);
  if (!chance.bernoulli(camera.false_balls_per_frame)) return;
  // Anywhere in the sector with equal density.
  const double distance = camera.ball_range * std::sqrt(chance.uniform());
  const double bearing = head_ + camera.half_angle * (2.0 * chance.uniform() - 1.0);
  const Vector position{distance * std::cos(bearing), distance * std::sin(bearing)};
  insert_by_distance(out.balls, mind::BallSighting{to_eigen(position), camera.distance_noise * distance,
                                                   camera.bearing_noise * distance});
}

void Sensing::see_robots(std::uint32_t tick, mind::Percepts& out) const {
  const config::Camera& camera = profile_.camera;
  for (const Neighbour& neighbour : neighbours_) {
    if (!in_sector(neighbour.candidate, camera.robot_range) || hidden(neighbour.candidate)) continue;
    Chance chance(seed_, Purpose::robot, side_, number_, neighbour.id, tick);
    if (!chance.bernoulli(camera.robot_probability)) continue;
    const Sighting sighting = measured(neighbour.candidate, chance);
    insert_by_distance(out.robots, mind::RobotSighting{to_eigen(sighting.position), sighting.along, sighting.across,
                                                       roster_.side(neighbour.id) == side_});
  }
}

void Sensing::see_landmarks(const BodyState& own, std::uint32_t tick, mind::Percepts& out) const {
  const config::Camera& camera = profile_.camera;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const Mark& mark = marks_[i];
    const bool post = mark.kind == REGISTA_LANDMARK_GOAL_POST;
    const double range = post ? camera.landmark_range : camera.line_range;
    const Vector apart{mark.position.x - own.x, mark.position.y - own.y};
    const double squared = squared_length(apart);
    if (squared > range * range) continue;
    const Candidate candidate{turned(apart, own.cosine, -own.sine), squared};
    if (!in_sector(candidate, range) || hidden(candidate)) continue;
    Chance chance(seed_, Purpose::landmark, side_, number_, static_cast<int>(i), tick);
    if (!chance.bernoulli(post ? camera.landmark_probability : camera.line_probability)) continue;
    const Sighting sighting = measured(candidate, chance);
    insert_by_distance(out.landmarks,
                       mind::LandmarkSighting{mark.kind, to_eigen(sighting.position), sighting.along, sighting.across});
  }
}

}  // namespace regista::match
