// SPDX-License-Identifier: MIT
#include "match/sensing.hpp"

#include <regista/abi.h>

#include <algorithm>
#include <cmath>

#include "mind/team_plan.hpp"

namespace regista::match {
namespace {

float squared(double value) { return static_cast<float>(value * value); }

// Inserts an item into `list`, which is sorted by distance. Lists are short, so a linear search is fast enough.
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

// Returns `v` rotated by a small angle: by 2 atan(t), where t equals tan(angle / 2) up to an error of fifth order.
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

Sensing::Sensing(const config::Robot& profile, const Disturbances& trouble, const Marks& marks, Roster roster, int id,
                 std::uint64_t seed, double robot_radius)
    : profile_(profile),
      trouble_(trouble),
      marks_(marks),
      roster_(roster),
      seed_(seed),
      side_(roster.side(id)),
      number_(roster.number(id)),
      squared_radius_(squared(robot_radius)),
      squared_ball_range_(squared(profile.camera.ball_range)),
      sector_{0.0f, 0.0f, 1.0f, 0.0f, static_cast<float>(std::cos(profile.camera.half_angle))} {
  squared_robot_range_.fill(squared(profile.camera.robot_range));
  squared_robot_range_[at(id)] = -1.0f;  // the robot never sees itself
  Chance chance(seed_, Purpose::odometry_scale, side_, number_, 0, 0);
  scale_ = 1.0 + profile.odometry.scale_bias * chance.normal();
}

void Sensing::put_down(const mind::Pose& world, double direction, std::uint32_t tick) {
  direction_ = direction;
  mirrored_ = false;
  tell_pose(world, Purpose::placing, tick);
  lifted_ = true;
}

// Sets the pose that the next percepts contain, because a person has put the robot down or a disturbance has changed.
void Sensing::tell_pose(const mind::Pose& world, Purpose purpose, std::uint32_t tick) {
  const config::Odometry& odometry = profile_.odometry;
  Chance chance(seed_, purpose, side_, number_, 0, tick);
  mind::Pose pose = in_field_frame(world, mirrored_ ? -direction_ : direction_);
  const double sign = mirrored_ ? -1.0 : 1.0;
  pose.x += sign * bias_.x + odometry.placing_noise * chance.normal();
  pose.y += sign * bias_.y + odometry.placing_noise * chance.normal();
  pose.heading = mind::wrap(pose.heading + bias_.heading + odometry.placing_turn_noise * chance.normal());
  placed_ = mind::PlacedPose{pose, odometry.placing_noise, odometry.placing_turn_noise};
}

// Updates the effects of pose bias and mirror flips on the robot.
void Sensing::be_misled(const BodyState& own, std::uint32_t tick) {
  const Affliction& now = trouble_.of(number_);
  const bool bias_changes = now.bias.x != bias_.x || now.bias.y != bias_.y || now.bias.heading != bias_.heading;
  const bool mirrored = now.flipped && (mirrored_ || now.flips != flips_);
  flips_ = now.flips;
  if (!bias_changes && mirrored == mirrored_) return;
  bias_ = now.bias;
  biased_ = bias_.x != 0.0 || bias_.y != 0.0 || bias_.heading != 0.0;
  mirrored_ = mirrored;
  tell_pose({own.x, own.y, own.heading}, Purpose::misplacing, tick);
}

// Returns moved landmarks: the robot sees them as it would see the true landmarks from its biased pose.
const Points& Sensing::landmarks(const BodyState& own) {
  if (!biased_) return marks_.points;
  const Vector here{own.x, own.y}, believed = here + direction_ * Vector{bias_.x, bias_.y};
  const double cosine = std::cos(bias_.heading), sine = std::sin(bias_.heading);
  misplaced_marks_.count = marks_.points.count;
  for (std::size_t i = 0; i < marks_.points.count; ++i) {
    const Vector mark{marks_.points.x[i], marks_.points.y[i]};
    const Vector seen = here + turned(mark - believed, cosine, -sine);
    misplaced_marks_.x[i] = static_cast<float>(seen.x);
    misplaced_marks_.y[i] = static_cast<float>(seen.y);
  }
  return misplaced_marks_;
}

void Sensing::look(double yaw) { wanted_head_ = std::clamp(yaw, -profile_.camera.head_yaw, profile_.camera.head_yaw); }

void Sensing::sense(const Truth& truth, double time, std::uint32_t tick, bool able, mind::Percepts& out) {
  const BodyState& own = truth.own;
  be_misled(own, tick);
  out.placed.reset();
  placed_.swap(out.placed);
  measure_motion(own, tick, out);
  turn_head(time);
  out.balls.clear();
  out.robots.clear();
  out.landmarks.clear();
  out.camera = able;
  out.view = {head_, profile_.camera.half_angle, profile_.camera.ball_range, profile_.camera.robot_range};
  if (!able || trouble_.of(number_).blind) return;

  const Vector axis = turned({own.cosine, own.sine}, head_cosine_, head_sine_);
  sector_ = {own.x, own.y, static_cast<float>(axis.x), static_cast<float>(axis.y), sector_.cosine};
  offsets(truth.robots, sector_, robots_);
  see(truth, tick, out);
  imagine_ball(tick, out);
}

// Sets the odometry: the motion since the last decision, in its robot frame. A robot at rest has no error, and no draw.
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
  const float head = static_cast<float>(head_);
  head_cosine_ = std::cos(head);
  head_sine_ = std::sin(head);
}

void Sensing::Candidates::add(Purpose purpose, std::size_t object, float offset_x, float offset_y, double seen) {
  draws[count] = {purpose, static_cast<int>(object)};
  x[count] = offset_x;
  y[count] = offset_y;
  probability[count] = seen;
  ++count;
}

void Sensing::see_ball(Purpose purpose, std::size_t object, Vector ball) {
  const float x = static_cast<float>(ball.x) - sector_.x, y = static_cast<float>(ball.y) - sector_.y;
  const float squared = x * x + y * y, ahead = x * sector_.axis_x + y * sector_.axis_y;
  if (squared <= squared_ball_range_ && signed_square(ahead) >= signed_square(sector_.cosine) * squared &&
      !hidden(x, y, robots_, squared_radius_)) {
    candidates_.add(purpose, object, x, y, profile_.camera.ball_probability);
  }
}

void Sensing::find_candidates(const Truth& truth) {
  const config::Camera& camera = profile_.camera;
  candidates_.count = 0;
  see_ball(Purpose::ball, 0, truth.ball);
  for (const int robot : Members(inside(robots_, sector_, squared_robot_range_))) {
    const auto i = at(robot);
    if (hidden(robots_.x[i], robots_.y[i], robots_, squared_radius_)) continue;
    candidates_.add(Purpose::robot, i, robots_.x[i], robots_.y[i], camera.robot_probability);
  }
  const Affliction& trouble = trouble_.of(number_);
  for (std::size_t i = 0; i < trouble.ghost_count; ++i)
    see_ball(Purpose::ghost_ball, i, direction_ * trouble.ghosts[i]);
  Offsets marks;
  offsets(landmarks(truth.own), sector_, marks);
  for (const int mark : Members(inside(marks, sector_, marks_.squared_range))) {
    const auto i = at(mark);
    if (hidden(marks.x[i], marks.y[i], robots_, squared_radius_)) continue;
    candidates_.add(Purpose::landmark, i, marks.x[i], marks.y[i], marks_.probability[i]);
  }
}

void Sensing::see(const Truth& truth, std::uint32_t tick, mind::Percepts& out) {
  find_candidates(truth);
  if (candidates_.count == 0) return;
  const config::Camera& camera = profile_.camera;
  Draws draws;
  draw(seed_, side_, number_, tick, std::span(candidates_.draws).first(candidates_.count), draws);
  for (std::size_t i = 0; i < candidates_.count; ++i) {
    if (!(draws.uniform[i] < candidates_.probability[i])) continue;
    const double stretch = 1.0 + camera.distance_noise * draws.first[i];
    const double bearing = camera.bearing_noise * draws.second[i];
    const Vector apart{candidates_.x[i], candidates_.y[i]};
    const double distance = length(apart);
    const Vector seen_at = stretch * turned_little(turned(apart, truth.own.cosine, -truth.own.sine), bearing);
    const Eigen::Vector2d position{seen_at.x, seen_at.y};
    const double along = camera.distance_noise * distance, across = camera.bearing_noise * distance;
    const int object = candidates_.draws[i].object;
    switch (candidates_.draws[i].purpose) {
      case Purpose::ball:
        if (!blinded(tick)) out.balls.push_back({position, along, across});
        break;
      case Purpose::ghost_ball:
        if (!blinded(tick)) insert_by_distance(out.balls, mind::BallSighting{position, along, across});
        break;
      case Purpose::robot:
        insert_by_distance(out.robots, mind::RobotSighting{position, along, across, roster_.side(object) == side_});
        break;
      default:
        insert_by_distance(out.landmarks, mind::LandmarkSighting{marks_.kind[static_cast<std::size_t>(object)],
                                                                 position, along, across});
    }
  }
}

bool Sensing::blinded(std::uint32_t tick) const {
  const double probability = trouble_.disturbance().camera.ball_blindness;
  if (probability <= 0.0) return false;
  Chance chance(seed_, Purpose::ball_blindness, side_, number_, 0, tick);
  return chance.bernoulli(probability);
}

// With the profile's probability, adds a false ball at a random place with uniform density over the camera's sector.
void Sensing::imagine_ball(std::uint32_t tick, mind::Percepts& out) const {
  const config::Camera& camera = profile_.camera;
  const double probability =
      camera.false_balls_per_frame + trouble_.disturbance().camera.ghost_balls * profile_.decision_period;
  if (probability <= 0.0) return;
  Chance chance(seed_, Purpose::false_ball, side_, number_, 0, tick);
  if (!chance.bernoulli(probability)) return;
  const double distance = camera.ball_range * std::sqrt(chance.uniform());
  const double bearing = head_ + camera.half_angle * (2.0 * chance.uniform() - 1.0);
  insert_by_distance(out.balls, mind::BallSighting{{distance * std::cos(bearing), distance * std::sin(bearing)},
                                                   camera.distance_noise * distance,
                                                   camera.bearing_noise * distance});
}

}  // namespace regista::match
