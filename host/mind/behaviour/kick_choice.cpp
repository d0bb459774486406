// SPDX-License-Identifier: MIT
#include "mind/behaviour/kick_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace regista::mind {
namespace {

constexpr double goal_bonus = 4.0;             // m: a shot that can go in is worth this much of ground
constexpr double pass_bonus = 0.5;             // m: the ball arrives at somebody
constexpr double blocked_cost = 3.0;           // m: an opponent right in the way
constexpr double out_cost = 4.0;               // m: the ball leaves the field
constexpr double constancy = 0.6;              // m: bonus of the last choice
constexpr double teammate_news_at_most = 6.0;  // s
constexpr double along_goal_line = 0.9;        // share of half the goal that is aimed at

class Choice {
 public:
  Choice(const Situation& situation, const std::optional<KickPlan>& last)
      : situation_(situation),
        last_(last),
        goal_(situation.rules.field.length / 2.0, 0.0),
        here_((goal_ - situation.ball).norm()) {}

  void try_goal(double y) {
    const Vector2d aim(goal_.x(), y);
    const double distance = (aim - situation_.ball).norm();
    // So fast that it would roll a metre into the net.
    if (const auto plan = plan_towards(aim, distance + 1.0); plan && plan->distance >= distance + 0.2) {
      const double blocked = risk(plan->direction, distance);
      const double open = std::max(0.0, 1.0 - blocked / blocked_cost);
      consider(*plan, here_ + open * goal_bonus - blocked - 0.3 * distance);
    }
  }

  void try_pass(const regista_robot& mate) {
    const Vector2d aim(mate.pose[0] + 0.3, mate.pose[1]);
    const double distance = (aim - situation_.ball).norm();
    if (distance < 1.0) return;
    if (const auto plan = plan_towards(aim, distance); plan && std::abs(plan->distance - distance) < 0.7) {
      consider(*plan, gain(*plan) + pass_bonus - risk(plan->direction, plan->distance));
    }
  }

  // `turned`: direction relative to that of the goal, unit.
  void try_ahead(const Vector2d& turned, double distance) {
    const Vector2d to_goal = (goal_ - situation_.ball).normalized();
    const Vector2d direction(turned.x() * to_goal.x() - turned.y() * to_goal.y(),
                             turned.y() * to_goal.x() + turned.x() * to_goal.y());
    if (const auto plan = plan_towards(situation_.ball + direction * distance, distance)) {
      consider(*plan, gain(*plan) - risk(plan->direction, plan->distance));
    }
  }

  const KickPlan& best() const { return best_; }

 private:
  // The kind whose range comes nearest to the wanted distance; the weaker of equals.
  std::optional<KickPlan> plan_towards(const Vector2d& aim, double distance) const {
    const Vector2d way = aim - situation_.ball;
    const double length = way.norm();
    if (length < 1e-6) return std::nullopt;
    KickPlan plan{way / length, 0.0, -1};
    double least_miss = 0.0;
    const auto& kicks = situation_.robot.kicks;
    for (std::size_t i = 0; i < kicks.size(); ++i) {
      const double reached = std::clamp(distance, kicks[i].minimum_distance, kicks[i].maximum_distance);
      const double miss = std::abs(reached - distance);
      if (plan.kind < 0 || miss < least_miss) {
        plan.kind = static_cast<int>(i);
        plan.distance = reached;
        least_miss = miss;
      }
    }
    return plan;
  }

  double gain(const KickPlan& plan) const {
    const Vector2d end = situation_.ball + plan.direction * plan.distance;
    const auto& field = situation_.rules.field;
    const bool out = std::abs(end.y()) > field.width / 2.0 || std::abs(end.x()) > field.length / 2.0;
    return here_ - (goal_ - end).norm() - (out ? out_cost : 0.0);
  }

  double risk(const Vector2d& direction, double distance) const {
    double cost = 0.0;
    for (const regista_opponent& opponent : situation_.world.opponents) {
      const Vector2d offset(opponent.position[0] - situation_.ball.x(), opponent.position[1] - situation_.ball.y());
      const double along = offset.dot(direction);
      if (along < 0.0 || along > distance + 0.5) continue;
      // The farther the ball has rolled, the more time there was to step in its way, and the wider it has spread.
      const double corridor = 0.35 + 0.15 * along;
      const double across = std::abs(offset.x() * direction.y() - offset.y() * direction.x());
      if (across < corridor) cost += blocked_cost * (1.0 - across / corridor) * opponent.weight;
    }
    return cost;
  }

  void consider(const KickPlan& plan, double value) {
    if (last_ && plan.kind == last_->kind && plan.direction.dot(last_->direction) > 0.97) value += constancy;
    if (best_.kind < 0 || value > best_value_) {
      best_ = plan;
      best_value_ = value;
    }
  }

  const Situation& situation_;
  const std::optional<KickPlan>& last_;
  Vector2d goal_;
  double here_;  // m from the ball to the goal
  KickPlan best_{{1, 0}, 0.0, -1};
  double best_value_ = 0.0;
};

}  // namespace

KickPlan choose_kick(const Situation& situation, const std::optional<KickPlan>& last) {
  Choice choice(situation, last);
  const double post = along_goal_line * situation.rules.field.goal_width / 2.0;
  for (const double y : {0.0, -0.6 * post, 0.6 * post}) choice.try_goal(y);
  for (const regista_robot& robot : situation.world.robots) {
    const bool reachable = (robot.flags & REGISTA_ROBOT_ACTIVE) != 0 && (robot.flags & REGISTA_ROBOT_FALLEN) == 0 &&
                           robot.number != situation.own_number && robot.age < teammate_news_at_most;
    if (reachable) choice.try_pass(robot);
  }
  static const std::array<Vector2d, 7> directions = [] {
    std::array<Vector2d, 7> out;
    const std::array<double, 7> angles{0.0, -0.4, 0.4, -0.8, 0.8, -1.2, 1.2};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = {std::cos(angles[i]), std::sin(angles[i])};
    return out;
  }();
  for (const Vector2d& direction : directions) {
    for (const double distance : {0.8, 3.0}) choice.try_ahead(direction, distance);
  }
  return choice.best();
}

}  // namespace regista::mind
