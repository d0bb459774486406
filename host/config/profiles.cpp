// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "config/read.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"

namespace regista::config {
static Map declare(FieldSize& field) {
  return {{
      real("length", field.length, {0.5, 200}, "m", "goal line to goal line"),
      real("width", field.width, {0.5, 200}, "m", "touch line to touch line"),
      real("border_strip", field.border_strip, {0, 10}, "m", "carpet outside of the lines"),
      real("line_width", field.line_width, {0.01, 0.5}, "m", "of every line"),
      real("goal_width", field.goal_width, {0.1, 50}, "m", "between the posts"),
      real("goal_depth", field.goal_depth, {0.05, 10}, "m", "goal line to net"),
      real("post_diameter", field.post_diameter, {0.01, 1}, "m", "of a goal post"),
      real("goal_area_length", field.goal_area_length, {0, 100}, "m", "from the goal line"),
      real("goal_area_width", field.goal_area_width, {0, 200}, "m", "along the goal line"),
      real("penalty_area_length", field.penalty_area_length, {0, 100}, "m", "from the goal line"),
      real("penalty_area_width", field.penalty_area_width, {0, 200}, "m", "along the goal line"),
      real("penalty_mark_distance", field.penalty_mark_distance, {0, 100}, "m", "from the goal line"),
      real("centre_circle_diameter", field.centre_circle_diameter, {0, 100}, "m", "of the centre circle"),
  }};
}

static Map declare(BallSize& ball) {
  return {{
      real("diameter", ball.diameter, {0.02, 0.5}, "m", "of the ball"),
      real("mass", ball.mass, {0.005, 2}, "kg", "of the ball"),
      real("rolling_deceleration", ball.rolling_deceleration, {0.01, 10}, "m/s^2", "while it rolls on the carpet"),
      real("restitution", ball.restitution, {0, 1}, "1", "speed kept when it bounces off a body or post"),
  }};
}

static Map declare(Durations& durations) {
  return {{
      real("half", durations.half, {1, 7200}, "s", "one half"),
      integer("halves", durations.halves, {1, 2}, "1", "halves of a match"),
      real("ready", durations.ready, {0, 600}, "s", "robots walk to their kick-off positions"),
      real("set", durations.set, {0, 600}, "s", "from Set to the whistle"),
      real("kick_off_free_after", durations.kick_off_free_after, {0, 600}, "s", "ball free although nobody touched it"),
      real("set_play", durations.set_play, {0, 600}, "s", "kick-in, goal kick, corner kick, pushing free kick"),
      real("penalty_kick_ready", durations.penalty_kick_ready, {0, 600}, "s", "robots walk to their places for it"),
      real("penalty_kick", durations.penalty_kick, {0, 600}, "s", "in which it must be taken"),
      real("state_delay", durations.state_delay, {0, 600}, "s", "Goal and Playing reach robots late over the network"),
      real("game_stuck", durations.game_stuck, {1, 3600}, "s", "the ball has not moved"),
  }};
}

static Map declare(Messages& messages) {
  return {{
      integer("budget", messages.budget, {0, 1000000}, "packets", "of a team in a match"),
      integer("size", messages.size, {64, 1024}, "bytes", "largest packet"),
      choice("short_games", messages.short_games, {"whole", "share"},
             "packets of a game shorter than a match (an opening, a limit): the whole budget, or the length's share"),
  }};
}

static Map declare(Penalties& penalties) {
  return {{
      real("removal", penalties.removal, {0, 3600}, "s", "off the field, first offence of the team"),
      real("removal_growth", penalties.removal_growth, {0, 3600}, "s", "more for each earlier offence of the team"),
      real("illegal_position_in_set", penalties.illegal_position_in_set, {0, 3600}, "s", "off the field"),
      real("motion_in_set", penalties.motion_in_set, {0, 3600}, "s", "still, on the spot"),
  }};
}

static Map declare(Offences& offences) {
  return {{
      integer("most_in_own_goal_area", offences.most_in_own_goal_area, {1, 22}, "robots", "of the team"),
      real("leave_after_pushed_in", offences.leave_after_pushed_in, {0, 600}, "s",
           "to leave the own goal area into which an opponent pushed"),
      real("leave_free_kick", offences.leave_free_kick, {0, 600}, "s", "to leave the circle when it is called"),
      real("fallen", offences.fallen, {0, 600}, "s", "lies longer"),
      real("inactive", offences.inactive, {0.2, 600}, "s", "does nothing longer"),
      real("hold_ball", offences.hold_ball, {0.1, 600}, "s", "keeps the ball at its feet longer"),
      real("goalkeeper_holds_ball", offences.goalkeeper_holds_ball, {0.1, 600}, "s", "the same in the penalty area"),
      real("walk_into_goal", offences.walk_into_goal, {0, 600}, "s", "walks into post, net or border longer"),
      real("notice_set", offences.notice_set, {0, 600}, "s", "to come to rest in Set"),
      real("pushing_speed", offences.pushing_speed, {0, 10}, "m/s", "of the walk against an opponent"),
      real("pushing_lasts", offences.pushing_lasts, {0, 600}, "s", "pushes longer"),
      real("pushing_near_ball", offences.pushing_near_ball, {0, 100}, "m", "costs a free kick or penalty kick"),
      real("stuck_near_ball", offences.stuck_near_ball, {0, 100}, "m", "is why the game is stuck"),
  }};
}

Map declare(Rules& rules) {
  return {{
      required(name("rules", rules.name, "name of these rules")),
      integer("team_size", rules.team_size, {1, 22}, "robots", "of each team"),
      section("field", rules.field, "lengths between the centres of lines"),
      section("ball", rules.ball, "the ball"),
      section("durations", rules.durations, "of the phases of the game"),
      section("messages", rules.messages, "between the robots of a team"),
      section("penalties", rules.penalties, "what offences cost, in seconds of Ready and Playing"),
      section("offences", rules.offences, "when something is an offence"),
      real("set_play_distance", rules.set_play_distance, {0, 20}, "m", "defenders keep away from the ball"),
      integer("mercy_difference", rules.mercy_difference, {1, 1000}, "goals", "difference that ends the match"),
  }};
}

static Map declare(Body& body) {
  return {{
      real("radius", body.radius, {0.02, 2}, "m", "torso against torso"),
      real("mass", body.mass, {0.1, 500}, "kg", "of the robot"),
      real("reach", body.reach, {0.02, 3}, "m", "centre of the robot to centre of the ball, to kick it"),
      degrees("reach_angle_deg", body.reach_angle, {1, 180}, "deg", "to either side of the heading, to kick the ball"),
      real("get_up", body.get_up, {0, 120}, "s", "an attempt to get up from the ground"),
      real("get_up_failure", body.get_up_failure, {0, 0.95}, "1", "probability that an attempt fails; another follows"),
      real("contact_felt", body.contact_felt, {0, 1}, "1", "probability per decision that it feels a robot in contact"),
      real("falls_per_contact_second", body.falls_per_contact_second, {0, 10}, "1/s", "rate while pushed"),
      real("falls_per_walking_minute", body.falls_per_walking_minute, {0, 60}, "1/min",
           "rate while walking, without anybody's help"),
  }};
}

static Map declare(Walk& walk) {
  return {{
      real("forward", walk.forward, {0.01, 10}, "m/s", "fastest"),
      real("sideways", walk.sideways, {0, 10}, "m/s", "fastest"),
      real("backward", walk.backward, {0, 10}, "m/s", "fastest"),
      degrees("turn_deg", walk.turn, {1, 3600}, "deg/s", "fastest"),
      real("acceleration", walk.acceleration, {0.01, 100}, "m/s^2", "largest"),
      degrees("turn_acceleration_deg", walk.turn_acceleration, {1, 100000}, "deg/s^2", "largest"),
      real("step_period", walk.step_period, {0.02, 5}, "s", "a new command takes effect at the next step"),
  }};
}

static Map declare(Kick& kick) {
  return {{
      required(name("name", kick.name, "of the kick")),
      real("minimum_distance", kick.minimum_distance, {0.01, 100}, "m", "that the ball rolls"),
      real("maximum_distance", kick.maximum_distance, {0.01, 100}, "m", "that the ball rolls"),
      real("duration", kick.duration, {0, 30}, "s", "the robot stands"),
      real("impact", kick.impact, {0, 30}, "s", "from the beginning until the ball leaves"),
      real("distance_noise", kick.distance_noise, {0, 1}, "1", "half width of a triangular law, relative"),
      degrees("direction_noise_deg", kick.direction_noise, {0, 180}, "deg", "standard deviation"),
  }};
}

static Map declare(Camera& camera) {
  return {{
      degrees("half_angle_deg", camera.half_angle, {1, 180}, "deg", "half of the horizontal field of view"),
      degrees("head_yaw_deg", camera.head_yaw, {0, 180}, "deg", "the head turns up to this to either side"),
      degrees("head_speed_deg", camera.head_speed, {0, 3600}, "deg/s", "of the head"),
      real("ball_range", camera.ball_range, {0, 200}, "m", "farthest ball that is seen"),
      real("ball_probability", camera.ball_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("robot_range", camera.robot_range, {0, 200}, "m", "farthest robot that is seen"),
      real("robot_probability", camera.robot_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("landmark_range", camera.landmark_range, {0, 200}, "m", "farthest goal post that is seen"),
      real("landmark_probability", camera.landmark_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("line_range", camera.line_range, {0, 200}, "m", "farthest line that is seen"),
      real("line_probability", camera.line_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("false_balls_per_frame", camera.false_balls_per_frame, {0, 1}, "1", "balls that are not there"),
      real("distance_noise", camera.distance_noise, {0, 1}, "1", "standard deviation, relative to the distance"),
      degrees("bearing_noise_deg", camera.bearing_noise, {0, 180}, "deg", "standard deviation"),
  }};
}

static Map declare(Odometry& odometry) {
  return {{
      real("distance_noise", odometry.distance_noise, {0, 1}, "1", "relative, of the way walked between decisions"),
      real("turn_noise", odometry.turn_noise, {0, 1}, "1", "relative, of the angle turned between decisions"),
      real("scale_bias", odometry.scale_bias, {0, 1}, "1", "of a scale error drawn once per robot and match"),
      real("placing_noise", odometry.placing_noise, {0, 10}, "m", "how well it knows where it was put down"),
      degrees("placing_turn_noise_deg", odometry.placing_turn_noise, {0, 180}, "deg", "the same for its direction"),
  }};
}

static Map declare(Radio& radio) {
  return {{
      real("delay", radio.delay, {0, 60}, "s", "least delay of a packet"),
      real("jitter", radio.jitter, {0, 60}, "s", "width of a uniform law on top"),
      real("loss", radio.loss, {0, 1}, "1", "probability per packet and receiver"),
  }};
}

static Map declare(Hearing& hearing) {
  return {{
      real("whistle_probability", hearing.whistle_probability, {0, 1}, "1", "per robot and whistle"),
  }};
}

Map declare(Robot& robot) {
  return {{
      required(name("robot", robot.name, "name of this type of robot")),
      section("body", robot.body, "what bumps into others"),
      section("walk", robot.walk, "how it moves"),
      list("kicks", robot.kicks, 1, 16, "kinds of kick it can choose from"),
      section("camera", robot.camera, "what it sees"),
      section("odometry", robot.odometry, "how well it knows its own way; standard deviations"),
      section("radio", robot.radio, "how packets travel"),
      section("hearing", robot.hearing, "what it hears"),
      real("decision_period", robot.decision_period, {0.02, 2}, "s", "between two decisions of a robot"),
  }};
}

void check(const Rules& rules, const Node& document, Mistakes& mistakes) {
  const Refusals wrong(document, mistakes);
  const FieldSize& field = rules.field;
  const auto at_most = [&](std::string_view what, double value, std::string_view against, double limit) {
    if (value > limit) wrong({what, against}, "{} ({} m) is more than {} ({} m)", what, value, against, limit);
  };
  const double goal = field.goal_width + 2.0 * field.post_diameter;
  if (goal > field.width) {
    wrong({"field.goal_width", "field.post_diameter", "field.width"},
          "the goal with its posts ({} m) is wider than the field ({} m)", goal, field.width);
  }
  if (rules.ball.diameter >= field.goal_width) {
    wrong({"ball.diameter", "field.goal_width"}, "the ball does not fit into the goal");
  }
  for (const auto& [area, length, width] : {std::tuple{"goal", field.goal_area_length, field.goal_area_width},
                                            {"penalty", field.penalty_area_length, field.penalty_area_width}}) {
    if (2.0 * length > field.length) {
      wrong({fmt::format("field.{}_area_length", area), "field.length"},
            "the {} area ({} m long) reaches beyond the halfway line ({} m from the goal line)", area, length,
            field.length / 2);
    }
    if (width > field.width) {
      wrong({fmt::format("field.{}_area_width", area), "field.width"},
            "the {} area ({} m) is wider than the field ({} m)", area, width, field.width);
    }
  }
  if (2.0 * field.penalty_mark_distance > field.length) {
    wrong({"field.penalty_mark_distance", "field.length"},
          "the penalty mark ({} m from the goal line) lies beyond the halfway line ({} m)", field.penalty_mark_distance,
          field.length / 2);
  }
  at_most("field.centre_circle_diameter", field.centre_circle_diameter, "field.width", field.width);
  at_most("field.centre_circle_diameter", field.centre_circle_diameter, "field.length", field.length);
  at_most("set_play_distance", rules.set_play_distance, "field.width", field.width);
}

void check(const Robot& robot, const Node& document, Mistakes& mistakes) {
  const Refusals wrong(document, mistakes);
  for (std::size_t i = 0; i < robot.kicks.size(); ++i) {
    const Kick& kick = robot.kicks[i];
    const auto path = [&](std::string_view key) { return fmt::format("kicks.{}.{}", i, key); };
    if (kick.minimum_distance > kick.maximum_distance) {
      wrong({path("minimum_distance"), path("maximum_distance")},
            "kick {}: the least distance ({} m) is more than the largest ({} m)", kick.name, kick.minimum_distance,
            kick.maximum_distance);
    }
    if (kick.impact > kick.duration) {
      wrong({path("impact"), path("duration")},
            "kick {}: the ball is hit {} s after the beginning, but the kick is over after {} s", kick.name,
            kick.impact, kick.duration);
    }
  }
  const double steps = robot.decision_period / physics_step;
  if (std::abs(steps - std::round(steps)) > 1e-9) {
    wrong({"decision_period"}, "decision_period: {} s is not a whole number of physics steps of {} s",
          robot.decision_period, physics_step);
  }
  if (robot.body.reach <= robot.body.radius) {
    wrong({"body.reach", "body.radius"}, "body.reach ({} m from the centre) ends inside the body (radius {} m)",
          robot.body.reach, robot.body.radius);
  }
}

void check(const Robot& robot, const Rules& rules, const Node& document) {
  Mistakes first(Mistakes::After::stop);
  const Refusals wrong(document, first);
  const double touching = robot.body.radius + rules.ball.diameter / 2.0;
  if (robot.body.reach < touching) {
    wrong({"body.reach", "body.radius"},
          "body.reach ({} m from the centre) ends before the ball of the rules '{}': torso and ball touch at {} m, so "
          "it could never be kicked; --robot names another robot, such as --robot humanoid",
          robot.body.reach, rules.name, touching);
  }
  const FieldSize& field = rules.field;
  if (field.border_strip < 2.0 * robot.body.radius) {
    wrong({"body.radius"},
          "body.radius: a robot of {} m does not fit on the border strip of the rules '{}' ({} m), beside the lines on "
          "which it begins",
          2.0 * robot.body.radius, rules.name, field.border_strip);
  }
  // All robots together may cover at most half of the field.
  const double taken = 2.0 * rules.team_size * 4.0 * robot.body.radius * robot.body.radius;
  if (taken > field.length * field.width / 2.0) {
    wrong({"body.radius"}, "body.radius: {} robots of {} m have no room on the field of the rules '{}' ({} m x {} m)",
          2 * rules.team_size, 2.0 * robot.body.radius, rules.name, field.length, field.width);
  }
}

}  // namespace regista::config
