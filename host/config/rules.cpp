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

}  // namespace regista::config
