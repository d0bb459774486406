// SPDX-License-Identifier: MIT
// The rules profile: field, ball, durations, packet budget. The defaults come from the RoboCup SPL rule book 2023.
// Lengths in metres between line centres, time in seconds. All numbers of a rule book are values here, not code.
#pragma once

#include <optional>
#include <string>

#include "config/declaration.hpp"

namespace regista::config {

struct FieldSize {
  double length = 9.0, width = 6.0;
  double border_strip = 0.7;
  double line_width = 0.05;
  double goal_width = 1.5;  // between the posts
  double goal_depth = 0.5;
  double post_diameter = 0.1;
  double goal_area_length = 0.6, goal_area_width = 2.2;
  double penalty_area_length = 1.65, penalty_area_width = 4.0;
  double penalty_mark_distance = 1.3;  // distance from the goal line
  double centre_circle_diameter = 1.5;
};

struct BallSize {
  double diameter = 0.10;
  double mass = 0.044;                 // kg
  double rolling_deceleration = 0.32;  // m/s^2
  double restitution = 0.5;            // share of its speed that the ball keeps in a collision with a body or post
};

struct Durations {
  static constexpr double initial = 1.0;  // s before each half, for one decision of every robot; not in a rule book

  double half = 600.0;
  int halves = 2;
  double ready = 45.0;
  double set = 5.0;                   // from the beginning of Set to the whistle
  double kick_off_free_after = 10.0;  // if no robot touches the ball for this time, both teams may play it
  double set_play = 30.0;             // time for a kick-in, goal kick, corner kick or pushing free kick
  double penalty_kick_ready = 30.0;   // time for the walk to the places of a penalty kick
  double penalty_kick = 30.0;         // time limit for the penalty kick
  double state_delay = 15.0;          // delay of the news of Goal -> Ready and Set -> Playing; a whistle has no delay
  double game_stuck = 30.0;           // time without ball motion after which a game counts as stuck
};

// The packet budget of a game that is shorter than a match, because the game starts from an opening or has a limit.
// whole: the budget of a whole match. share: the part of this budget that fits the length of the game.
enum class ShortGames { whole, share };

struct Messages {
  int budget = 1200;  // packets per team and match
  int size = 128;     // largest packet, bytes
  ShortGames short_games = ShortGames::whole;
  // The part of a match that the game to be played covers. fit_packets() sets these values from its length and
  // beginning; until then they are those of a whole match.
  double share = 1.0;                 // share of the budget
  double earlier = 0.0, later = 0.0;  // sending time of a match before and after the game, s
};

// The penalties of offences, s. The time of a penalty passes only in the states Ready and Playing.
struct Penalties {
  // Time off the field for the first offence of a team, and the additional time for each earlier offence of the team.
  double removal = 45.0, removal_growth = 10.0;
  double illegal_position_in_set = 15.0;  // time off the field; this offence does not increase later penalties
  double motion_in_set = 15.0;            // time without motion at the same place; does not increase later penalties
};

// The limits beyond which an action is an offence. Times in seconds, distances in metres.
struct Offences {
  int most_in_own_goal_area = 3;                         // largest number of players of the same team
  double leave_after_pushed_in = 5.0;                    // time to leave its own goal area after an opponent's push
  double leave_free_kick = 10.0;                         // time to move away from the ball after a free kick was called
  double fallen = 15.0;                                  // longest time on the ground
  double inactive = 10.0;                                // longest time without action
  double hold_ball = 3.0, goalkeeper_holds_ball = 10.0;  // longest time with the ball at the feet
  double walk_into_goal = 5.0;                           // longest time of walking against a post, a net or the border
  double notice_set = 1.0;                               // time to stop walking in Set
  double pushing_speed = 0.1;                            // least walking speed against an opponent, m/s
  double pushing_lasts = 1.0;                            // least duration of pushing, s
  double pushing_near_ball = 0.5;  // m: pushing within this distance from the ball costs a free kick or a penalty kick
  double stuck_near_ball = 0.5;    // m: robots within this distance from the ball cause a stuck game
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
  double set_play_distance = 0.75;  // defenders must keep this distance from the ball
  int mercy_difference = 10;        // goal difference that ends the match
};

Map declare(Rules& rules);

// Reports values of the document that contradict each other, with the reason.
void check(const Rules& rules, const Node& document, Mistakes& mistakes);

// --- The packets of a game, and the packet line. A game is a match or, with an opening or a time limit, a part of a
// match. A team may send in play. It may also send in Ready and Set before each half, although the clock stands still
// then; a game from an opening has no Ready and Set before its first half. These times together are the sending time.
// The packet line is the number of packets that a team would have left if it spent them evenly over the sending time.
// messages.short_games decides about a game that is shorter than a match. share: it has its share of the packets, and
// its packet line reaches 0 at its end. whole: it has all packets of a match, and its packet line reaches 0 only where
// a whole match would end.

// Returns the share of the packet budget for a game of at most `seconds`, in (0, 1]. The share is 1 if the rules give
// every game the whole budget, or if `seconds` is missing.
double packet_share(const Rules& rules, std::optional<double> seconds);

// Sets the values in rules.messages that depend on the game. The game lasts at most `seconds` of simulated time. It
// begins in play, or with Ready before a kick-off.
void fit_packets(Rules& rules, std::optional<double> seconds, bool begins_in_play);

// Returns the number of packets that a team may send in the game for which fit_packets() was called, rounded down.
int packets(const Messages& messages);

// Returns the time in which a team may send during a whole match, s.
double sending_time(const Durations& durations);

// Returns the sending time (defined above) over which a team must spread its remaining packets, s: with
// ShortGames::share the time until the end of the game, with ShortGames::whole the time until a whole match would end.
// sending_time_left: remaining sending time of a whole match, s.
double packet_time_left(const Rules& rules, double sending_time_left);

// Returns the value of the packet line: all packets of the game at its beginning; 0 where packet_time_left() is 0.
double packet_line(const Rules& rules, double sending_time_left);

}  // namespace regista::config
