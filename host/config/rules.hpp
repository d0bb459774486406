// SPDX-License-Identifier: MIT
// The rules profile: field, ball, durations, budget of a game (RoboCup SPL rule book 2023 by default). Lengths in
// metres between line centres, time in seconds. Every number that a rule book fixes is data here, none is code.
#pragma once

#include <string>

namespace regista::config {

struct FieldSize {
  double length = 9.0, width = 6.0;
  double border_strip = 0.7;
  double line_width = 0.05;
  double goal_width = 1.5;  // inner
  double goal_depth = 0.5;
  double post_diameter = 0.1;
  double goal_area_length = 0.6, goal_area_width = 2.2;
  double penalty_area_length = 1.65, penalty_area_width = 4.0;
  double penalty_mark_distance = 1.3;  // from the goal line
  double centre_circle_diameter = 1.5;
};

struct BallSize {
  double diameter = 0.10;
  double mass = 0.044;                 // kg
  double rolling_deceleration = 0.32;  // m/s^2
  double restitution = 0.5;            // with bodies and posts
};

struct Durations {
  static constexpr double initial = 1.0;  // s, before each half; of no rule book: every robot decides there once

  double half = 600.0;
  int halves = 2;
  double ready = 45.0;
  double set = 5.0;                   // from Set to the whistle
  double kick_off_free_after = 10.0;  // ball free without a touch
  double set_play = 30.0;             // kick-in, goal kick, corner kick, pushing free kick
  double penalty_kick_ready = 30.0;   // robots walk to their places for a penalty kick
  double penalty_kick = 30.0;         // in which it must be taken
  double state_delay = 15.0;          // Goal -> Ready and Set -> Playing reach robots late, except by whistle
  double game_stuck = 30.0;           // the ball has not moved
};

// How many packets a game has that is shorter than a match: one from an opening, or with a limit.
enum class ShortGames { whole, share };

struct Messages {
  int budget = 1200;  // packets per team and match
  int size = 128;     // bytes
  ShortGames short_games = ShortGames::whole;
  // What of a match this game is; follows from its length and beginning, see packet_share.hpp.
  double share = 1.0;                 // of the budget
  double earlier = 0.0, later = 0.0;  // s in which a team may send in a match, but not in this game
};

// What offences cost, in seconds of Ready and Playing.
struct Penalties {
  double removal = 45.0, removal_growth = 10.0;  // growth: for each earlier offence of the team that counts
  double illegal_position_in_set = 15.0;         // off the field; does not count
  double motion_in_set = 15.0;                   // on the spot; does not count
};

// When something is an offence. Seconds and metres.
struct Offences {
  int most_in_own_goal_area = 3;       // players of a team
  double leave_after_pushed_in = 5.0;  // an own goal area into which an opponent pushed
  double leave_free_kick = 10.0;       // who stood near the ball when a free kick was called
  double fallen = 15.0;                // lies longer
  double inactive = 10.0;              // does nothing longer
  double hold_ball = 3.0, goalkeeper_holds_ball = 10.0;
  double walk_into_goal = 5.0;     // or into the border
  double notice_set = 1.0;         // to come to rest in Set
  double pushing_speed = 0.1;      // m/s of the walk against an opponent
  double pushing_lasts = 1.0;      // s of it
  double pushing_near_ball = 0.5;  // m: nearer to the ball it costs a free kick or a penalty kick
  double stuck_near_ball = 0.5;    // m: who stands so near is why the game is stuck
};

struct Rules {
  std::string name = "spl2023";
  int team_size = 7;
  FieldSize field;
  BallSize ball;
  Durations durations;
  Messages messages;
  Penalties penalties;
  Offences offences;
  double set_play_distance = 0.75;  // defenders keep away
  int mercy_difference = 10;        // goals
};

}  // namespace regista::config
