// SPDX-License-Identifier: MIT
#include "config/rules.hpp"

#include "config/profiles.hpp"

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
      real("state_delay", durations.state_delay, {0, 600}, "s", "Goal and Playing reach robots late over the network"),
      real("game_stuck", durations.game_stuck, {1, 3600}, "s", "nobody touches the ball"),
  }};
}

static Map declare(Messages& messages) {
  return {{
      integer("budget", messages.budget, {0, 1000000}, "packets", "of a team in a match"),
      integer("extra_per_minute", messages.extra_per_minute, {0, 100000}, "packets", "for each minute of added time"),
      integer("size", messages.size, {64, 1024}, "bytes", "largest packet"),
  }};
}

static Map declare(Penalties& penalties) {
  return {{
      real("removal", penalties.removal, {0, 3600}, "s", "off the field, first offence of the team"),
      real("removal_growth", penalties.removal_growth, {0, 3600}, "s", "more for each earlier offence of the team"),
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
      section("penalties", rules.penalties, "what offences cost"),
      real("set_play_distance", rules.set_play_distance, {0, 20}, "m", "defenders keep away from the ball"),
      integer("mercy_difference", rules.mercy_difference, {1, 1000}, "goals", "difference that ends the match"),
  }};
}

}  // namespace regista::config
