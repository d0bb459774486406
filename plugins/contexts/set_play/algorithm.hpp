// SPDX-License-Identifier: MIT
// A set play is on, or has just been: kick-off, kick-in, goal kick, corner kick, pushing free kick or penalty kick of
// the SPL rule book 2023. The SPQR team's released code (2022 to 2024) has contexts for the set plays of both teams.
// That the context may end before the set play does, or outlive it, is ours: the rules give a kick-in 30 s, but who
// stood well for it should not scatter at the first touch. So is the choice between two patterns: it follows from what
// the game controller tells everybody, so that a team plays one pattern and its opponents do not foresee which.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

namespace set_play {

enum class Whose { either, own, opponent };
enum class Pattern { any, first, second };

// Sets of kinds and of phases: bit k stands for the kind or phase k of abi.h.
using Set = std::uint32_t;
constexpr Set one(int kind) { return kind >= 0 && kind < 32 ? Set{1} << kind : Set{0}; }

inline constexpr int none = 0;  // no set play
inline constexpr int kick_off = 1;
inline constexpr int playing = 3;

struct Rule {
  Set kinds = ~Set{0};
  Set phases = ~Set{0};
  Whose whose = Whose::either;
  Pattern pattern = Pattern::any;
  double at_most = std::numeric_limits<double>::infinity();  // s from its beginning, or that of its phase
  double hold_seconds = 0.0;                                 // s after it has ended
};

struct Game {
  int kind = none;
  int phase = playing;
  bool own = false;         // whose it is
  double phase_time = 0.0;  // s since the phase or the set play began
  int half = 1, goals = 0;  // of both sides
};

// Which of two patterns a set play has. A kick-off lasts through three phases, and who hears the whistle begins one of
// them on its own: there goals and half decide. Of all others the second in which it began does. time: of the match.
inline Pattern pattern_of(const Game& game, double time) {
  constexpr double between_steps = 0.01;  // s: no set play begins there, so rounding does not matter
  const bool odd = game.kind == kick_off ? (game.goals + game.half) % 2 == 0
                                         : std::fmod(std::floor(time - game.phase_time + between_steps), 2.0) != 0.0;
  return odd ? Pattern::second : Pattern::first;
}

class Memory {
 public:
  // time: s, never runs back. Returns whether the context holds. Call once per decision.
  bool update(const Rule& rule, double time, const Game& game) {
    const bool over = game.kind == none && game.phase == playing;
    if (over) return time - last_ <= rule.hold_seconds;
    const bool meant =
        game.kind != none && (rule.kinds & one(game.kind)) != 0 && (rule.phases & one(game.phase)) != 0 &&
        (rule.whose == Whose::either || (rule.whose == Whose::own) == game.own) &&
        (rule.pattern == Pattern::any || rule.pattern == pattern_of(game, time)) && game.phase_time <= rule.at_most;
    last_ = meant ? time : never;
    return meant;
  }
  void forget() { *this = Memory(); }

 private:
  static constexpr double never = -std::numeric_limits<double>::infinity();
  double last_ = never;  // decision at which it was on
};

}  // namespace set_play
