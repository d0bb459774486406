// SPDX-License-Identifier: MIT
#include "mind/world/local_model.hpp"

namespace regista::mind {
namespace {

// Covariance of a sighting with deviations along and across its line of sight, in the frame of that line's direction.
struct Spread {
  double xx, xy, yy;
  Spread(const Vector2d& line, double along, double across) {
    const double length2 = line.squaredNorm();
    const double c2 = length2 > 0.0 ? line.x() * line.x() / length2 : 1.0;
    const double cs = length2 > 0.0 ? line.x() * line.y() / length2 : 0.0;
    const double a = along * along, b = across * across;
    xx = c2 * a + (1.0 - c2) * b;
    xy = cs * (a - b);
    yy = (1.0 - c2) * a + c2 * b;
  }
};

void set_position_covariance(regista_measurement& measurement, double xx, double xy, double yy) {
  measurement.covariance[0] = xx;
  measurement.covariance[1] = xy;
  measurement.covariance[2] = yy;
}

}  // namespace

LocalModel::LocalModel(const TeamPlan& plan, plugin::Predictor self, plugin::Predictor ball,
                       plugin::Predictor opponents, plugin::Predictor teammates)
    : decision_period_(plan.robot().decision_period),
      self_model_(std::move(self)),
      ball_model_(std::move(ball)),
      opponent_model_(std::move(opponents)),
      teammate_model_(std::move(teammates)) {
  measurements_.reserve(64);
}

void LocalModel::measure_self(const Percepts& percepts) {
  measurements_.clear();
  if (percepts.placed) {
    regista_measurement& measurement = measurements_.emplace_back();
    measurement.kind = REGISTA_MEASURED_POSE;
    measurement.position[0] = percepts.placed->pose.x;
    measurement.position[1] = percepts.placed->pose.y;
    measurement.heading = percepts.placed->pose.heading;
    const double variance = percepts.placed->position_deviation * percepts.placed->position_deviation;
    set_position_covariance(measurement, variance, 0.0, variance);
    measurement.covariance[5] = percepts.placed->heading_deviation * percepts.placed->heading_deviation;
  }
  for (const LandmarkSighting& sighting : percepts.landmarks) {
    regista_measurement& measurement = measurements_.emplace_back();
    measurement.kind = REGISTA_MEASURED_LANDMARK;
    measurement.label = sighting.kind;
    measurement.position[0] = sighting.position.x();
    measurement.position[1] = sighting.position.y();
    const Spread spread(sighting.position, sighting.along, sighting.across);
    set_position_covariance(measurement, spread.xx, spread.xy, spread.yy);
  }
}

void LocalModel::add_in_field_frame(int kind, const Frame2& frame, const Vector2d& seen, double along, double across) {
  regista_measurement& measurement = measurements_.emplace_back();
  measurement.kind = kind;
  const Vector2d offset = frame.direction_to_field(seen);
  measurement.position[0] = self_.x + offset.x();
  measurement.position[1] = self_.y + offset.y();
  const Spread spread(offset, along, across);
  // A heading that is wrong by a little moves what is seen across the line of sight.
  const double turn = self_.pose.heading_variance;
  set_position_covariance(measurement, spread.xx + self_.covariance[0] + turn * offset.y() * offset.y(),
                          spread.xy + self_.covariance[1] - turn * offset.x() * offset.y(),
                          spread.yy + self_.covariance[2] + turn * offset.x() * offset.x());
}

void LocalModel::update(const Percepts& percepts, double dt, const regista_frame* last, bool ball_on_centre) {
  const regista_motion motion{percepts.odometry.x, percepts.odometry.y, percepts.odometry.heading};

  // Where the robot believed to look is not known before it believes to be somewhere: the first area is of no use to
  // the model of the own pose, which takes landmarks in the robot frame.
  regista_visible_area area{};
  area.half_angle = percepts.view.half_angle;
  area.range_ball = percepts.view.ball_range;
  area.range_robot = percepts.view.robot_range;
  if (dt > 0.0) self_model_.predict(dt, &motion, last);
  measure_self(percepts);
  if (!measurements_.empty()) self_model_.correct(measurements_, area);
  self_ = self_model_.tracks().front();

  frame_ = Frame2(pose());
  area.x = self_.x;
  area.y = self_.y;
  area.heading = wrap(self_.pose.heading + percepts.view.heading);

  if (dt > 0.0) ball_model_.predict(dt, &motion, last);
  measurements_.clear();
  for (const BallSighting& ball : percepts.balls) {
    add_in_field_frame(REGISTA_MEASURED_BALL, frame_, ball.position, ball.along, ball.across);
  }
  sighted_ = !percepts.balls.empty();
  if (ball_on_centre) {
    regista_measurement& known = measurements_.emplace_back();
    known.kind = REGISTA_MEASURED_BALL;
    set_position_covariance(known, 0.0025, 0.0, 0.0025);
  }
  if (percepts.camera || !measurements_.empty()) ball_model_.correct(measurements_, area);
  balls_ = ball_model_.tracks();

  opponents_ = update_robots(opponent_model_, percepts, false, dt, motion, last, area);
  teammates_ = update_robots(teammate_model_, percepts, true, dt, motion, last, area);
}

std::span<const regista_track> LocalModel::update_robots(plugin::Predictor& model, const Percepts& percepts,
                                                         bool own_team, double dt, const regista_motion& motion,
                                                         const regista_frame* last, const regista_visible_area& area) {
  if (dt > 0.0) model.predict(dt, &motion, last);
  if (percepts.camera) {
    measurements_.clear();
    for (const RobotSighting& robot : percepts.robots) {
      if (robot.own_team == own_team) {
        add_in_field_frame(REGISTA_MEASURED_ROBOT, frame_, robot.position, robot.along, robot.across);
      }
    }
    model.correct(measurements_, area);
  }
  return model.tracks();
}

}  // namespace regista::mind
