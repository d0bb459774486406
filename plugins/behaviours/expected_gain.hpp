// SPDX-License-Identifier: MIT
// Which kick to play, by what it can be expected to gain. Each option is a kick in a direction; the ball leaves it by a
// law of error, and for each of five directions of that law it is asked whether the ball goes in, who of the opponents
// gets in its way, where it stops or leaves the field, and which team is there first. A place is worth what it is to
// hold the ball there: from -1 in the own goal to 1 in the opponent's.
//
// Expected values of kicks are compared in this way by several teams of the 2D Simulation and Standard Platform
// Leagues; the model and its numbers here are ours.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "kick_choice.hpp"
#include "situation.hpp"

namespace behaviours {

struct GainSettings {
  double pull = 3.0;               // m from a goal at which the worth of a place has fallen to 1 / e
  double possession = 0.25;        // worth of holding the ball rather than the opponents
  double goal = 1.5;               // worth of a goal
  double race = 1.2;               // s: so much sooner at the ball, a team holds it with probability 0.73
  double reaction = 0.8;           // s in which an opponent does not move yet
  double edge = 0.15;              // m over which an opponent's reach fades out
  double walk_around = 1.9;        // s per rad that the robot has to walk around the ball
  double hurry = 0.01;             // worth of each second until the kick
  double patience = 4.0;           // s at a ball that lies, after which each second of hurry costs more
  double impatience = 0.05;        // worth of each second until the kick, for each second beyond that
  double constancy = 0.05;         // worth of keeping to the last choice
  double receiver_age = 4.0;       // s: no pass to a teammate whose news are older
  double into_space = 0.4;         // m in front of the teammate at which passes are aimed
  double considered_within = 2.0;  // m: from farther away the kick is not chosen yet
  double shortest_pass = 1.0;      // m
};

// What besides the scene bears on a kick. Made by ExpectedGain::scene().
struct GainScene {
  const KickScene& kick;
  const Situation& situation;
  double direction_error = 0.0;    // standard deviation, rad
  double hurry = 0.0;              // worth of each second until the kick
  double opponents_at_ball = 0.0;  // s until the first of them can be there
  double worth_of_ball = 0.0;      // of the place where it lies
};

class ExpectedGain {
 public:
  ExpectedGain() = default;
  explicit ExpectedGain(const GainSettings& settings) : settings_(settings) {}

  // direction_error: of the robot's kicks; waited: s that it has been at the ball, and nobody has moved it. Two robots
  // that want to get around each other may stand there for long; the longer, the better is a kick from where it stands.
  // The scene refers to its first two arguments.
  GainScene scene(const KickScene& kick, const Situation& situation, double direction_error, double waited) const {
    GainScene out{kick, situation, direction_error};
    out.hurry = settings_.hurry + settings_.impatience * std::max(0.0, waited - settings_.patience);
    out.opponents_at_ball = time_of_opponents(out, kick.ball);
    out.worth_of_ball = worth(kick.field, kick.ball);
    return out;
  }

  // What it is worth that the ball is at this place, whoever has it.
  double worth(const Field& field, const Vector2d& place) const {
    const Vector2d goal(field.length / 2.0, 0.0);
    return std::exp(-(place - goal).norm() / settings_.pull) - std::exp(-(place + goal).norm() / settings_.pull);
  }

  // Of a kick in `direction` (unit, field frame) after which the ball would roll `distance`: the mean over five equally
  // likely directions of the normal law.
  double value(const GainScene& scene, const Vector2d& direction, double distance) const {
    constexpr std::array quantiles{-0.5244, 0.5244, -1.2816, 1.2816};
    double sum = roll(scene, direction, distance);
    for (const double quantile : quantiles) {
      const double angle = quantile * scene.direction_error;
      sum += roll(scene, turned(direction, std::cos(angle), std::sin(angle)), distance);
    }
    return in_time(scene, direction, sum / (quantiles.size() + 1));
  }

  // The kick of the greatest value, among those that would be best if kicks had no error.
  KickPlan choose(const GainScene& scene) const {
    Options options = tried(scene);
    const auto finalists = options.best(most_finalists);
    KickPlan best;
    double best_value = 0.0;
    for (const Option& option : finalists) {
      double worth = value(scene, option.plan.direction, option.plan.distance);
      if (is_last(scene, option.plan)) worth += settings_.constancy;
      if (best.kind != KickPlan::no_kind && worth <= best_value) continue;
      best = option.plan;
      best_value = worth;
    }
    if (best.kind != KickPlan::no_kind) best.receiver = receiver(scene, best);
    return best;
  }

  // The teammate that is first where the ball stops, if it is sooner there than the robot itself and all opponents: the
  // kick is a pass to it. 0: it is none.
  int receiver(const GainScene& scene, const KickPlan& plan) const {
    if (plan.distance < settings_.shortest_pass) return 0;
    const Vector2d stop = scene.kick.ball + plan.direction * plan.distance;
    const Field& field = scene.kick.field;
    if (std::abs(stop.x()) > field.length / 2.0 || std::abs(stop.y()) > field.width / 2.0) return 0;
    double soonest = std::min(time_of_robot(scene, stop, plan.distance), time_of_opponents(scene, stop));
    int out = 0;
    for (const Teammate& mate : scene.kick.teammates) {
      const double time = time_of_teammate(scene, mate, stop);
      if (mate.age > settings_.receiver_age || time >= soonest) continue;
      soonest = time;
      out = mate.number;
    }
    return out;
  }

 private:
  struct Option {
    KickPlan plan;
    double value = 0.0;  // without errors
  };

  class Options {
   public:
    void add(const Option& option) {
      if (count_ < list_.size()) list_[count_++] = option;
    }
    // The first ones by value; of equals, those that were added first.
    std::span<const Option> best(std::size_t most) {
      const std::size_t wanted = std::min(most, count_);
      for (std::size_t i = 0; i < wanted; ++i) {
        std::size_t first = i;
        for (std::size_t j = i + 1; j < count_; ++j) {
          if (list_[j].value > list_[first].value) first = j;
        }
        std::swap(list_[i], list_[first]);
      }
      return {list_.data(), wanted};
    }

   private:
    std::array<Option, 96> list_;
    std::size_t count_ = 0;
  };

  static constexpr std::size_t most_finalists = 8;

  static bool is_last(const GainScene& scene, const KickPlan& plan) {
    constexpr double same_direction = 0.97;  // cosine
    const std::optional<KickPlan>& last = scene.kick.last;
    return last && last->kind == plan.kind && last->direction.dot(plan.direction) > same_direction;
  }

  // Shots, passes to everybody, kicks to all sides of the goal, and such as need no walk around the ball.
  Options tried(const GainScene& scene) const {
    const KickScene& kicks = scene.kick;
    Options out;
    const auto add = [&](const Vector2d& way, double distance) {
      const double length = way.norm();
      if (length < 1e-6) return;
      Option option{kick_in_direction(kicks.kinds, way / length, distance), 0.0};
      if (option.plan.kind == KickPlan::no_kind) return;
      option.value = in_time(scene, option.plan.direction, roll(scene, option.plan.direction, option.plan.distance));
      if (is_last(scene, option.plan)) option.value += settings_.constancy;
      out.add(option);
    };
    const Vector2d goal(kicks.field.length / 2.0, 0.0);
    for (const double share : {0.0, -0.5, 0.5}) {
      constexpr double into_net = 1.0;  // m
      const Vector2d way = goal + Vector2d(0.0, share * kicks.field.goal_width / 2.0) - kicks.ball;
      add(way, way.norm() + into_net);
    }
    for (const Teammate& mate : kicks.teammates) {
      if (mate.age > settings_.receiver_age) continue;
      for (const double ahead : {0.0, settings_.into_space}) {
        const Vector2d way = mate.position + Vector2d(ahead, 0.0) - kicks.ball;
        if (way.norm() > settings_.shortest_pass) add(way, way.norm());
      }
    }
    const Vector2d to_goal = goal - kicks.ball, straight = kicks.ball - scene.situation.frame.origin();
    for (const double angle : {0.0, -0.35, 0.35, -0.7, 0.7, -1.1, 1.1, -1.6, 1.6}) {
      const Vector2d way = turned(to_goal, std::cos(angle), std::sin(angle));
      for (const double distance : {0.5, 1.0, 2.0, 3.5, 5.4}) add(way, distance);
    }
    for (const double distance : {0.5, 1.0, 2.0, 3.5, 5.4}) add(straight, distance);
    return out;
  }

  // What a kick is worth that may come too late, if it is worth `kicked` in time.
  double in_time(const GainScene& scene, const Vector2d& direction, double kicked) const {
    const double delay = time_until_kick(scene.situation, direction);
    const double first = share(scene.opponents_at_ball - delay + settings_.reaction);
    const double lost = scene.worth_of_ball - settings_.possession;
    return first * kicked + (1.0 - first) * lost - scene.hurry * delay;
  }

  double share(double sooner) const { return 1.0 / (1.0 + std::exp(-sooner / settings_.race)); }

  static double time_of_opponents(const GainScene& scene, const Vector2d& place) {
    const Facts& facts = scene.situation.facts;
    double soonest = 60.0;
    for (const Blocker& opponent : scene.kick.opponents) {
      const double way = std::max(0.0, (opponent.position - place).norm() - facts.robot_radius - facts.ball_radius);
      soonest = std::min(soonest, way / facts.walk_forward + 4.0 * (1.0 - opponent.weight));
    }
    return soonest;
  }

  // The robot itself, after the kick.
  static double time_of_robot(const GainScene& scene, const Vector2d& place, double distance) {
    constexpr double in_walking = 1.2;                      // m: shorter kicks do not stop the walk
    const double busy = distance > in_walking ? 1.0 : 0.3;  // s
    return busy + (scene.situation.frame.origin() - place).norm() / scene.situation.facts.walk_forward;
  }

  static double time_of_teammate(const GainScene& scene, const Teammate& mate, const Vector2d& place) {
    constexpr double doubt = 0.2;  // s per s without news
    return (mate.position - place).norm() / scene.situation.facts.walk_forward + doubt * mate.age;
  }

  static double time_of_team(const GainScene& scene, const Vector2d& place, double distance) {
    double soonest = time_of_robot(scene, place, distance);
    for (const Teammate& mate : scene.kick.teammates) soonest = std::min(soonest, time_of_teammate(scene, mate, place));
    return soonest;
  }

  double time_until_kick(const Situation& situation, const Vector2d& direction) const {
    const Facts& facts = situation.facts;
    const Vector2d way = situation.ball - situation.frame.origin();
    const double distance = way.norm();
    const double around = distance < 1e-6 ? 0.0 : std::abs(wrap(angle_of(direction) - angle_of(way)));
    const double turn = std::abs(wrap(angle_of(direction) - situation.pose.heading));
    return std::max(0.0, distance - facts.reach) / facts.walk_forward +
           std::max(settings_.walk_around * std::max(0.0, around - 0.4), std::max(0.0, turn - 0.3) / 1.2);
  }

  // One way of the ball.
  double roll(const GainScene& scene, const Vector2d& direction, double distance) const {
    const KickScene& kick = scene.kick;
    const Facts& facts = scene.situation.facts;
    const Field& field = kick.field;
    // Where it leaves the field.
    const double half_length = field.length / 2.0, half_width = field.width / 2.0;
    double way = distance;
    enum { stays, side, end } leaves = stays;
    if (std::abs(direction.y()) > 1e-9) {
      const double to_side = (std::copysign(half_width, direction.y()) - kick.ball.y()) / direction.y();
      if (to_side < way) way = std::max(0.0, to_side), leaves = side;
    }
    if (std::abs(direction.x()) > 1e-9) {
      const double to_end = (std::copysign(half_length, direction.x()) - kick.ball.x()) / direction.x();
      if (to_end < way) way = std::max(0.0, to_end), leaves = end;
    }
    const Vector2d stop = kick.ball + direction * way;
    const double speed = std::sqrt(2.0 * facts.ball_deceleration * distance);
    // Opponents in the way.
    const double touching = facts.robot_radius + facts.ball_radius;
    double through = 1.0, sum = 0.0;
    for (const Blocker& opponent : kick.opponents) {
      const Vector2d offset = opponent.position - kick.ball;
      const double along = offset.dot(direction);
      if (along <= 0.0 || along > way + touching) continue;
      const double across = std::abs(offset.x() * direction.y() - offset.y() * direction.x());
      const double at = std::min(along, way);
      const double time = (speed - std::sqrt(std::max(0.0, speed * speed - 2.0 * facts.ball_deceleration * at))) /
                          facts.ball_deceleration;
      const double reach = touching + facts.walk_forward * std::max(0.0, time - settings_.reaction);
      const double stopped = opponent.weight * std::clamp((reach - across) / settings_.edge + 0.5, 0.0, 1.0);
      if (stopped <= 0.0) continue;
      sum += through * stopped * (worth(field, kick.ball + direction * at) - 0.5 * settings_.possession);
      through *= 1.0 - stopped;
    }
    if (through <= 0.0) return sum;
    return sum + through * stopped_at(scene, stop, leaves == side, leaves == end, distance, speed);
  }

  double stopped_at(const GainScene& scene, const Vector2d& stop, bool over_side, bool over_end, double distance,
                    double speed) const {
    const Field& field = scene.kick.field;
    const bool in_goal = std::abs(stop.y()) < field.goal_width / 2.0 - scene.situation.facts.ball_radius;
    if (over_end && in_goal && !is_indirect(scene.situation)) {
      return stop.x() > 0.0 ? settings_.goal : -settings_.goal;
    }
    // A kick-in, goal kick or corner of the opponents.
    if (over_end) {
      const double x = stop.x() > 0.0 ? field.length / 2.0 - field.goal_area_length : -field.length / 2.0;
      const double y = std::copysign(stop.x() > 0.0 ? field.goal_area_width / 2.0 : field.width / 2.0, stop.y());
      return worth(field, {x, y}) - settings_.possession;
    }
    if (over_side) return worth(field, stop) - settings_.possession;
    const double rolls = speed / scene.situation.facts.ball_deceleration;
    const double team = std::max(rolls, time_of_team(scene, stop, distance));
    const double opponents = std::max(rolls, time_of_opponents(scene, stop));
    const double ours = share(opponents - team);
    return worth(field, stop) + settings_.possession * (2.0 * ours - 1.0);
  }

  GainSettings settings_;
};

}  // namespace behaviours
