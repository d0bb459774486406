// SPDX-License-Identifier: MIT
// The state of a game as the game controller knows it: what is true, not yet what robots are told (see told.hpp).
#pragma once

#include <array>
#include <cstdint>

#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

enum class Ended { no, full_time, mercy, limit };

struct GameState {
  mind::Phase phase = mind::Phase::initial;
  mind::SetPlay set_play = mind::SetPlay::none;
  Side kicking = Side::home;  // whose set play it is, or whose last kick-off it was
  int half = 1;
  Ended ended = Ended::no;
  double phase_began = 0.0;                  // match time when the phase or set play began
  bool clock_runs = false;                   // from a half's first kick-off on
  double clock = 0.0;                        // s played of this half
  std::array<int, 2> goals{};                // by side; those that count
  std::array<bool, 2> sanctioned{};          // broke the budget or sent an over-long packet
  std::array<int, 2> packets{};              // charged, by side
  std::array<int, 2> packets_left{};         // of the budget, never below 0
  std::array<std::uint32_t, 2> penalised{};  // by side: bit n - 1 is robot n
  Vector spot;                               // where the ball was placed last

  bool in_play() const { return phase == mind::Phase::playing && set_play == mind::SetPlay::none; }
  int score(Side side) const { return goals[index(side)]; }
  bool is_penalised(Side side, int number) const { return (penalised[index(side)] >> (number - 1) & 1u) != 0; }
};

// Why a robot is penalised. RoboCup SPL rule book 2023, section 4.
enum class Offence : std::uint8_t {
  none,
  illegal_position,
  illegal_position_in_set,
  motion_in_set,
  fallen,
  inactive,
  local_game_stuck,
  ball_holding,
  pushing,
  leaving_the_field,
};
inline constexpr std::size_t offence_count = 10;

enum class EventKind : std::uint8_t {
  half_begins,
  ready,
  set,
  kick_off,
  goal,
  goal_not_counted,
  kick_in,
  goal_kick,
  corner_kick,
  pushing_free_kick,
  penalty_kick,  // awarded
  whistle,       // it may be taken
  ball_free,
  game_stuck,
  penalty,
  returned,
  put_back,
  too_many_packets,
  packet_too_long,
  half_ends,
  finished,
  opening,  // a game from an opening begins; last, for the hash of a match counts the kinds
};

// `side`: whom it concerns: who kicks, scored, was penalised. number: of the robot, 0 where there is none. offence: of
// a penalty.
struct Event {
  EventKind kind;
  Side side = Side::home;
  int number = 0;
  Offence offence = Offence::none;
};

const char* name(EventKind kind);
const char* name(Offence offence);

}  // namespace regista::match
