// SPDX-License-Identifier: MIT
// Which kick to play: at goal, to a teammate, or ahead (a dribble, or a clearance). Every option is a straight line
// that the ball would roll; it is worth what it gains towards the opponent's goal, in metres, less what opponents near
// the line may cost.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "situation.hpp"

namespace behaviours {

// A kind of kick that the robot can do: how far the ball rolls, m.
struct KickKind {
  double minimum_distance = 0.0, maximum_distance = 0.0;
};

struct KickPlan {
  static constexpr int no_kind = -1;
  Vector2d direction{1, 0};  // unit, field frame
  double distance = 0.0;     // that the ball shall roll, m
  int kind = no_kind;        // index into the kinds of kick; no_kind when no kick leads anywhere
  int receiver = 0;          // the teammate that a pass is meant for
};

// Field frame. Owns nothing.
struct KickScene {
  Field field;
  Vector2d ball{0, 0};
  std::span<const KickKind> kinds;
  std::span<const Teammate> teammates;
  std::span<const Blocker> opponents;
  std::optional<KickPlan> last;  // that of the last decision
};

// With the kind of kick whose range comes nearest to the wanted distance, the first of equals.
inline KickPlan kick_in_direction(std::span<const KickKind> kinds, const Vector2d& direction, double distance) {
  KickPlan plan{direction, 0.0, KickPlan::no_kind, 0};
  double least_miss = 0.0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const double reached = std::clamp(distance, kinds[i].minimum_distance, kinds[i].maximum_distance);
    const double miss = std::abs(reached - distance);
    if (plan.kind != KickPlan::no_kind && !(miss < least_miss)) continue;
    plan.kind = static_cast<int>(i);
    plan.distance = reached;
    least_miss = miss;
  }
  return plan;
}

struct KickSettings {
  // At goal.
  double goal_bonus = 4.0;       // m: a shot that can go in is worth this much of ground
  double along_goal_line = 0.9;  // share of half the goal that is aimed at
  double beside_keeper = 0.6;    // share of that by which shots beside the middle are aimed off it
  double into_net = 1.0;         // m behind the line that a shot would roll
  double over_line = 0.2;        // m behind the line that it must roll at least
  double shot_cost = 0.3;        // m per m to the goal: far shots miss
  // To a teammate.
  double pass_bonus = 0.5;             // m: the ball arrives at somebody
  double teammate_news_at_most = 6.0;  // s
  double pass_ahead = 0.3;             // m in front of the teammate
  double shortest_pass = 1.0;          // m
  double pass_miss = 0.7;              // m that a kick may end short of the aim or beyond it
  // Ahead: straight towards the goal, and turned from it to either side.
  double slight_turn = 0.4, half_turn = 0.8, wide_turn = 1.2;  // rad
  double dribble_distance = 0.8, clear_distance = 3.0;         // m
  // For all of them.
  double blocked_cost = 3.0;      // m: an opponent right in the way
  double corridor = 0.35;         // m to either side of the line in which an opponent is in the way
  double corridor_growth = 0.15;  // m per m that the ball has rolled
  double behind_end = 0.5;        // m beyond the end of the way in which an opponent counts
  double out_cost = 4.0;          // m: the ball leaves the field
  double constancy = 0.6;         // m: bonus of the last choice
  double same_direction = 0.97;   // cosine of the angle up to which a kick is still the last choice
};

class KickChoice {
 public:
  KickChoice() : KickChoice(KickSettings{}) {}
  explicit KickChoice(const KickSettings& settings) : settings_(settings) {
    const std::array<double, 7> angles{0.0,
                                       -settings.slight_turn,
                                       settings.slight_turn,
                                       -settings.half_turn,
                                       settings.half_turn,
                                       -settings.wide_turn,
                                       settings.wide_turn};
    for (std::size_t i = 0; i < angles.size(); ++i) turned_[i] = {std::cos(angles[i]), std::sin(angles[i])};
  }

  // The best option from where the ball lies.
  KickPlan choose(const KickScene& scene) const {
    Options options(scene, settings_);
    const double post = settings_.along_goal_line * scene.field.goal_width / 2.0;
    const double beside = settings_.beside_keeper * post;
    for (const double y : {0.0, -beside, beside}) options.try_goal(y);
    for (const Teammate& mate : scene.teammates) {
      if (mate.age < settings_.teammate_news_at_most) options.try_pass(mate);
    }
    for (const Vector2d& direction : turned_) {
      for (const double distance : {settings_.dribble_distance, settings_.clear_distance}) {
        options.try_ahead(direction, distance);
      }
    }
    return options.best();
  }

 private:
  class Options {
   public:
    Options(const KickScene& scene, const KickSettings& settings)
        : scene_(scene),
          settings_(settings),
          goal_(scene.field.length / 2.0, 0.0),
          here_((goal_ - scene.ball).norm()) {}

    void try_goal(double y) {
      const Vector2d aim(goal_.x(), y);
      const double distance = (aim - scene_.ball).norm();
      const auto plan = plan_towards(aim, distance + settings_.into_net);
      if (!plan || plan->distance < distance + settings_.over_line) return;
      const double blocked = risk(plan->direction, distance);
      const double open = std::max(0.0, 1.0 - blocked / settings_.blocked_cost);
      consider(*plan, here_ + open * settings_.goal_bonus - blocked - settings_.shot_cost * distance);
    }

    void try_pass(const Teammate& mate) {
      const Vector2d aim(mate.position.x() + settings_.pass_ahead, mate.position.y());
      const double distance = (aim - scene_.ball).norm();
      if (distance < settings_.shortest_pass) return;
      auto plan = plan_towards(aim, distance);
      if (!plan || !(std::abs(plan->distance - distance) < settings_.pass_miss)) return;
      plan->receiver = mate.number;
      consider(*plan, gain(*plan) + settings_.pass_bonus - risk(plan->direction, plan->distance));
    }

    // `turn`: direction relative to that of the goal, unit.
    void try_ahead(const Vector2d& turn, double distance) {
      const Vector2d to_goal = (goal_ - scene_.ball).normalized();
      const Vector2d direction = turned(to_goal, turn.x(), turn.y());
      if (const auto plan = plan_towards(scene_.ball + direction * distance, distance)) {
        consider(*plan, gain(*plan) - risk(plan->direction, plan->distance));
      }
    }

    const KickPlan& best() const { return best_; }

   private:
    std::optional<KickPlan> plan_towards(const Vector2d& aim, double distance) const {
      const Vector2d way = aim - scene_.ball;
      const double length = way.norm();
      if (length < 1e-6 || scene_.kinds.empty()) return std::nullopt;
      return kick_in_direction(scene_.kinds, way / length, distance);
    }

    double gain(const KickPlan& plan) const {
      const Vector2d end = scene_.ball + plan.direction * plan.distance;
      const Field& field = scene_.field;
      const bool out = std::abs(end.y()) > field.width / 2.0 || std::abs(end.x()) > field.length / 2.0;
      return here_ - (goal_ - end).norm() - (out ? settings_.out_cost : 0.0);
    }

    double risk(const Vector2d& direction, double distance) const {
      double cost = 0.0;
      for (const Blocker& opponent : scene_.opponents) {
        const Vector2d offset = opponent.position - scene_.ball;
        const double along = offset.dot(direction);
        if (along < 0.0 || along > distance + settings_.behind_end) continue;
        // The farther the ball has rolled, the more time there was to step in its way, and the wider it has spread.
        const double corridor = settings_.corridor + settings_.corridor_growth * along;
        const double across = std::abs(offset.x() * direction.y() - offset.y() * direction.x());
        if (across < corridor) cost += settings_.blocked_cost * (1.0 - across / corridor) * opponent.weight;
      }
      return cost;
    }

    void consider(const KickPlan& plan, double value) {
      const std::optional<KickPlan>& last = scene_.last;
      if (last && plan.kind == last->kind && plan.direction.dot(last->direction) > settings_.same_direction) {
        value += settings_.constancy;
      }
      if (best_.kind == KickPlan::no_kind || value > best_value_) {
        best_ = plan;
        best_value_ = value;
      }
    }

    const KickScene& scene_;
    const KickSettings& settings_;
    Vector2d goal_;
    double here_;  // m from the ball to the goal
    KickPlan best_;
    double best_value_ = 0.0;
  };

  KickSettings settings_;
  std::array<Vector2d, 7> turned_;  // directions ahead, relative to that of the goal
};

}  // namespace behaviours
