// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the game as this robot was told.
#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

struct Score {
  static constexpr auto id = "score", version = "1.0.0", summary = "The difference of goals lies in a range";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  score_context::Rule rule;
  static constexpr std::tuple parameters{regista::within(
      &Score::rule,
      regista::integer("least", &score_context::Rule::least, {-100, 100}, "1",
                       "Own goals minus the opponent's, at least; SPQR planned -2 to 2; above `most`: never holds"),
      regista::integer("most", &score_context::Rule::most, {-100, 100}, "1", "Own goals minus the opponent's, at most"),
      regista::real("in_last", &score_context::Rule::in_last, {0.0, 3600.0}, "s",
                    "Holds only so long before the end of the second half; 0, our choice: at any time"))};

  bool holds(const regista::Frame& frame) {
    const regista::World world = frame.world();
    const regista::Game& game = world.game();
    return score_context::holds(rule, {game.own_score, game.opponent_score, game.half, game.time_left});
  }
};

}  // namespace

REGISTA_PLUGIN(Score, regista::context)
