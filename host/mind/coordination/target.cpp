// SPDX-License-Identifier: MIT
#include "mind/coordination/target.hpp"

#include <algorithm>
#include <cmath>

namespace regista::mind {
namespace {

// The point on the segment from-to that is `distance` from `to`, or `from` when the segment is shorter.
Vector2d on_line(const Vector2d& from, const Vector2d& to, double distance) {
  const Vector2d back = from - to;
  const double length = back.norm();
  return length <= distance ? from : Vector2d(to + back * (distance / length));
}

// Where the way from `from` to `towards` first meets the circle. When it does not, the circle's point nearest to
// `from`; from inside, the circle's point on the side of both, so that rules which differ in `towards` do not meet.
Vector2d on_circle(const Vector2d& from, const Vector2d& towards, const Vector2d& centre, double radius) {
  const Vector2d out = from - centre;
  const double distance = out.norm();
  const Vector2d fallback = distance > 0.0 ? Vector2d(centre + out * (radius / distance)) : from;
  if (distance <= radius) {
    const Vector2d side = out + (towards - centre);
    return side.norm() > 0.0 ? Vector2d(centre + side.normalized() * radius) : fallback;
  }
  const Vector2d along = towards - from;
  const double a = along.squaredNorm(), b = out.dot(along), c = out.squaredNorm() - radius * radius;
  const double discriminant = b * b - a * c;
  if (a == 0.0 || discriminant < 0.0) return fallback;
  const double t = (-b - std::sqrt(discriminant)) / a;
  return t >= 0.0 ? Vector2d(from + t * along) : fallback;
}

}  // namespace

Anchors::Anchors(const config::FieldSize& field, double rolling_deceleration, const DistributedWorldModel& world)
    : field_(&field), ball_known_(world.ball_known()), ball_(world.ball()), ball_rest_(ball_) {
  const Vector2d velocity = world.ball_velocity();
  ball_rest_ += velocity * (velocity.norm() / (2.0 * rolling_deceleration));
  // A ball that leaves the field comes back to its line.
  const Vector2d corner(field.length / 2.0, field.width / 2.0);
  ball_rest_ = ball_rest_.cwiseMin(corner).cwiseMax(-corner);
}

Vector2d Anchors::at(const config::Place& place) const {
  using enum config::Anchor;
  const double goal = field_->length / 2.0, mark = goal - field_->penalty_mark_distance,
               post = field_->goal_width / 2.0;
  switch (place.anchor) {
    case ball:
      return ball_;
    case ball_rest:
      return ball_rest_;
    case own_goal:
      return {-goal, 0.0};
    case opponent_goal:
      return {goal, 0.0};
    case own_left_post:
      return {-goal, post};
    case own_right_post:
      return {-goal, -post};
    case centre:
      return {0.0, 0.0};
    case own_penalty_mark:
      return {-mark, 0.0};
    case opponent_penalty_mark:
      return {mark, 0.0};
    case point:
      return {place.point[0], place.point[1]};
  }
  return {0.0, 0.0};
}

Vector2d target_of(const config::TargetRule& rule, const Anchors& anchors) {
  if (!anchors.ball_known() && rule.without_ball) return anchors.at(*rule.without_ball);
  Vector2d point;
  if (rule.on_line) {
    point = on_line(anchors.at(rule.on_line->from), anchors.at(rule.on_line->to), rule.on_line->distance_from_to);
  } else if (rule.on_circle) {
    const auto& circle = *rule.on_circle;
    const Vector2d from = anchors.at(circle.from), centre = anchors.at(circle.centre);
    const double span = circle.largest_distance - circle.least_distance;
    const double share =
        span > 0.0 ? std::clamp(((from - centre).norm() - circle.least_distance) / span, 0.0, 1.0) : 0.0;
    point = on_circle(from, anchors.at(circle.towards), centre,
                      circle.least_radius + share * (circle.largest_radius - circle.least_radius));
  } else {
    point = anchors.at(rule.at.value_or(config::Place{}));
  }
  point += Vector2d(rule.shift[0], rule.shift[1]);
  if (rule.across) {
    const double ball_y = anchors.at({config::Anchor::ball, {}}).y();
    point.y() = ball_y >= 0.0 ? -*rule.across : *rule.across;
  }
  if (rule.within) {
    const auto& [x_min, x_max, y_min, y_max] = *rule.within;
    point.x() = std::clamp(point.x(), x_min, x_max);
    point.y() = std::clamp(point.y(), y_min, y_max);
  }
  return point;
}

}  // namespace regista::mind
