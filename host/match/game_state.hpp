// SPDX-License-Identifier: MIT
// GameState is the state of a game in the game controller. GameControllerFeed sends this state to the robots. Event is
// a call of the referee. PlayEvent is a shot, pass, clearance or duel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "config/rules.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// no: the game goes on. full_time: all halves are over. mercy: the mercy rule applied. limit: Setup::limit was reached.
enum class Ended { no, full_time, mercy, limit };

struct GameState {
  mind::Phase phase = mind::Phase::initial;
  mind::SetPlay set_play = mind::SetPlay::none;
  Side kicking = Side::home;  // the side that takes the current set play; in open play: that took the last set play
  int half = 1;
  Ended ended = Ended::no;
  double phase_began = 0.0;                  // match time at which the phase or set play began, s
  bool clock_runs = false;                   // false before the first kick-off of a half
  double clock = 0.0;                        // time played in this half, s
  std::array<int, 2> goals{};                // by side: goals that count
  std::array<bool, 2> sanctioned{};          // by side: the side sent too many packets or a too long packet
  std::array<int, 2> packets{};              // by side: number of packets charged to the budget
  std::array<int, 2> packets_left{};         // by side: number of packets left in the budget
  std::array<std::uint32_t, 2> penalised{};  // by side: bit n - 1 is 1 while robot n is penalised
  Vector spot;                               // place where the referee last put the ball; world frame

  bool in_play() const { return phase == mind::Phase::playing && set_play == mind::SetPlay::none; }
  int score(Side side) const { return goals[index(side)]; }
  bool is_penalised(Side side, int number) const { return (penalised[index(side)] >> (number - 1) & 1u) != 0; }
  RobotSet all_penalised(Roster roster) const { return penalised[0] | RobotSet{penalised[1]} << roster.team_size; }
};

// The offence for which a robot is penalised. RoboCup SPL rule book 2023, section 4.
enum class Offence : std::uint8_t {
  none,
  illegal_position,
  illegal_position_in_set,
  motion_in_set,  // the robot walked or turned in Set
  fallen,
  inactive,          // the robot made no decision for too long
  local_game_stuck,  // the ball did not move, and the robot was the nearest one
  ball_holding,
  pushing,
  leaving_the_field
};
inline constexpr std::size_t offence_count = 10;

enum class EventKind : std::uint8_t {
  half_begins,  // robots are put on their start poses
  ready,
  set,
  kick_off,  // the referee whistles for a kick-off
  goal,
  goal_not_counted,
  kick_in,
  goal_kick,
  corner_kick,
  pushing_free_kick,
  penalty_kick,  // the referee awards a penalty kick; robots get ready
  whistle,       // the referee whistles, and the penalty kick may then be taken
  ball_free,     // the set play is over, and both sides may play the ball
  game_stuck,    // the ball did not move, so one side gets a kick-off
  penalty,
  returned,  // a penalised robot may play again
  put_back,  // the goalkeeper is put on its line before a penalty kick
  too_many_packets,
  packet_too_long,
  half_ends,
  finished,
  opening,  // a game begins from an opening; stays last, because the match hash contains these enum values
};

// side: the side that kicks, scored or is penalised. number: shirt number; 0 = no robot. offence: only of a penalty.
struct Event {
  EventKind kind;
  Side side = Side::home;
  int number = 0;
  Offence offence = Offence::none;
};

// The plays that the metrics count; metrics_play.hpp defines them. A play is reported as soon as its outcome is known.
enum class PlayKind { shot, pass, clearance, duel };

// Of a shot: goal, saved, missed. A pass: arrived, intercepted, lost. A duel: won, lost, undecided for its side.
enum class PlayOutcome { none, goal, saved, missed, arrived, intercepted, lost, won, undecided };

struct PlayEvent {
  PlayKind kind = PlayKind::shot;
  Side side = Side::home;
  int number = 0;
  double began = 0.0;  // s of match time
  Vector at;           // position of the ball when the play began; world frame
  PlayOutcome outcome = PlayOutcome::none;
  int receiver = 0;       // of a pass: shirt number of the intended receiver
  int opponent = 0;       // of a duel: shirt number of the other side's robot
  double duration = 0.0;  // of a duel, s
};

// Receives each play. time: match time at which the outcome became known, s.
using PlayTeller = std::function<void(double time, const PlayEvent&)>;

// These functions return names for logs, recordings and reports: lower case, words joined by underscores.
const char* name(Ended ended);  // "full_time", "mercy", "limit"
std::string_view name(mind::Phase phase);
std::string_view name(mind::SetPlay set_play);
std::string_view name(PlayKind kind);
std::string_view name(PlayOutcome outcome);

// name() returns a name for people, such as "kick-off". word() returns one word, such as "kick_off".
const char* name(EventKind kind);
const char* name(Offence offence);
std::string word(EventKind kind);
std::string word(Offence offence);

// --- What robots learn of the game, and when. RoboCup SPL rule book 2023: the game controller announces goals (Goal ->
// Ready) and kick-offs (Set -> Playing) late, and all other changes at once. The referee's whistle sounds before a late
// announcement, but some robots may not hear the whistle.
//
// A robot that hears a whistle in Set plays at once. A robot that hears a whistle in Playing assumes a goal and enters
// Ready. The announcement later tells which side scored and kicks off. A robot knows its own penalty at once.

class GameControllerFeed {
 public:
  explicit GameControllerFeed(const config::Rules& rules);

  // The game controller sends `state` at `time`. The message arrives `delay` s later. follows: the message has no
  // delay, but reaches only robots that know the previous announcement (example: the ball of a kick-off is free).
  void announce(const GameState& state, double time, double delay, bool follows);

  void whistle(int id, double time);  // The caller calls this when robot `id` has heard the referee's whistle.

  // Fills `out` with what robot `id` knows of the game at `time`. Penalties and packet budget come from `state`, the
  // true state. The clock is the clock of the robot's latest announcement plus the time since this announcement.
  void tell(int id, const GameState& state, double time, mind::GameTold& out);

 private:
  struct Announcement {
    GameState state;  // the game state at the time of sending
    double sent = 0.0, arrives = 0.0;
    bool follows = false;
  };
  struct Robot {
    std::uint64_t known = 0;        // number of the latest announcement that the robot knows
    bool ready_by_whistle = false;  // the robot heard a whistle in Playing and entered Ready
    double ready_since = 0.0;       // match time of that whistle, s
  };
  // Number of latest announcements that are stored. Older announcements have reached all robots.
  static constexpr std::uint64_t kept = 64;
  const Announcement& at(std::uint64_t i) const { return announcements_[static_cast<std::size_t>(i % kept)]; }
  void catch_up(Robot& robot, double time) const;

  config::Durations durations_;
  Roster roster_;
  std::array<Announcement, kept> announcements_;
  std::uint64_t last_ = 0;  // number of the latest announcement, counted from 1; 0 = no announcement yet
  std::vector<Robot> robots_;
};

}  // namespace regista::match
