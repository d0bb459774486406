// SPDX-License-Identifier: MIT
#include "config/check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "config/read.hpp"
#include "config/scalar.hpp"

namespace regista::config {
namespace {

// Refuses `value` (of the path `what`) above `limit` (of the path `against`), in metres or seconds.
void at_most(const Node& document, std::string_view what, double value, std::string_view against, double limit,
             std::string_view unit, Mistakes& mistakes) {
  if (value <= limit) return;
  refuse(
      document, {what, against},
      fmt::format("{} ({} {}) is more than {} ({} {})", what, real_text(value), unit, against, real_text(limit), unit),
      mistakes);
}

}  // namespace

void check(const Rules& rules, const Node& document, Mistakes& mistakes) {
  const FieldSize& field = rules.field;
  const double goal = field.goal_width + 2.0 * field.post_diameter;
  if (goal > field.width) {
    refuse(document, {"field.goal_width", "field.post_diameter", "field.width"},
           fmt::format("the goal with its posts ({} m) is wider than the field ({} m)", real_text(goal),
                       real_text(field.width)),
           mistakes);
  }
  if (rules.ball.diameter >= field.goal_width) {
    refuse(document, {"ball.diameter", "field.goal_width"}, "the ball does not fit into the goal", mistakes);
  }
  struct Area {
    std::string_view name, length_path, width_path;
    double length, width;
  };
  for (const Area& area : {Area{"goal area", "field.goal_area_length", "field.goal_area_width", field.goal_area_length,
                                field.goal_area_width},
                           Area{"penalty area", "field.penalty_area_length", "field.penalty_area_width",
                                field.penalty_area_length, field.penalty_area_width}}) {
    if (2.0 * area.length > field.length) {
      refuse(document, {area.length_path, "field.length"},
             fmt::format("the {} ({} m long) reaches beyond the halfway line ({} m from the goal line)", area.name,
                         real_text(area.length), real_text(field.length / 2)),
             mistakes);
    }
    if (area.width > field.width) {
      refuse(document, {area.width_path, "field.width"},
             fmt::format("the {} ({} m) is wider than the field ({} m)", area.name, real_text(area.width),
                         real_text(field.width)),
             mistakes);
    }
  }
  if (2.0 * field.penalty_mark_distance > field.length) {
    refuse(document, {"field.penalty_mark_distance", "field.length"},
           fmt::format("the penalty mark ({} m from the goal line) lies beyond the halfway line ({} m)",
                       real_text(field.penalty_mark_distance), real_text(field.length / 2)),
           mistakes);
  }
  at_most(document, "field.centre_circle_diameter", field.centre_circle_diameter, "field.width", field.width, "m",
          mistakes);
  at_most(document, "field.centre_circle_diameter", field.centre_circle_diameter, "field.length", field.length, "m",
          mistakes);
  at_most(document, "set_play_distance", rules.set_play_distance, "field.width", field.width, "m", mistakes);
}

void check(const Robot& robot, const Node& document, Mistakes& mistakes) {
  for (std::size_t i = 0; i < robot.kicks.size(); ++i) {
    const Kick& kick = robot.kicks[i];
    const auto path = [&](std::string_view key) { return fmt::format("kicks.{}.{}", i, key); };
    if (kick.minimum_distance > kick.maximum_distance) {
      refuse(document, {path("minimum_distance"), path("maximum_distance")},
             fmt::format("kick {}: the least distance ({} m) is more than the largest ({} m)", kick.name,
                         real_text(kick.minimum_distance), real_text(kick.maximum_distance)),
             mistakes);
    }
    if (kick.impact > kick.duration) {
      refuse(document, {path("impact"), path("duration")},
             fmt::format("kick {}: the ball is hit {} s after the beginning, but the kick is over after {} s",
                         kick.name, real_text(kick.impact), real_text(kick.duration)),
             mistakes);
    }
  }
  const double steps = robot.decision_period / physics_step;
  if (std::abs(steps - std::round(steps)) > 1e-9) {
    refuse(document, {"decision_period"},
           fmt::format("decision_period: {} s is not a whole number of physics steps of {} s",
                       real_text(robot.decision_period), real_text(physics_step)),
           mistakes);
  }
  if (robot.body.reach <= robot.body.radius) {
    refuse(document, {"body.reach", "body.radius"},
           fmt::format("body.reach ({} m from the centre) ends inside the body (radius {} m)",
                       real_text(robot.body.reach), real_text(robot.body.radius)),
           mistakes);
  }
}

void check(const Robot& robot, const Rules& rules, const Node& document) {
  const double touching = robot.body.radius + rules.ball.diameter / 2.0;
  if (robot.body.reach < touching) {
    refuse(document, {"body.reach", "body.radius"},
           fmt::format("body.reach ({} m from the centre) ends before the ball of the rules '{}': torso and ball touch "
                       "at {} m, so it could never be kicked",
                       real_text(robot.body.reach), rules.name, real_text(touching)));
  }
  const FieldSize& field = rules.field;
  if (field.border_strip < 2.0 * robot.body.radius) {
    refuse(document, {"body.radius"},
           fmt::format(
               "body.radius: a robot of {} m does not fit on the border strip of the rules '{}' ({} m), beside the "
               "lines on which it begins",
               real_text(2.0 * robot.body.radius), rules.name, real_text(field.border_strip)));
  }
  // Half of the field at most may be robots.
  const double taken = 2.0 * rules.team_size * 4.0 * robot.body.radius * robot.body.radius;
  if (taken > field.length * field.width / 2.0) {
    refuse(document, {"body.radius"},
           fmt::format("body.radius: {} robots of {} m have no room on the field of the rules '{}' ({} m x {} m)",
                       2 * rules.team_size, real_text(2.0 * robot.body.radius), rules.name, real_text(field.length),
                       real_text(field.width)));
  }
}

}  // namespace regista::config
