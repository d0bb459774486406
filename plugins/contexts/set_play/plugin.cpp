// SPDX-License-Identifier: MIT
// Context plugin around algorithm.hpp: the game as this robot was told.
#include <regista/context.hpp>

#include "algorithm.hpp"

namespace {

static_assert(set_play::none == REGISTA_SET_PLAY_NONE && set_play::kick_off == REGISTA_SET_PLAY_KICK_OFF &&
              set_play::playing == REGISTA_PHASE_PLAYING);

struct SetPlay {
  static constexpr auto id = "set_play", version = "1.0.0", summary = "A set play is on, or has just been";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  bool kick_off = false, kick_in = false, goal_kick = false, corner_kick = false, pushing_free_kick = false,
       penalty_kick = false;
  bool ready = false, set = false, playing = false;
  set_play::Rule rule{.at_most = 600.0};
  static constexpr std::array<const char*, 3> sides{"either", "own", "opponent"};
  static constexpr std::array<const char*, 3> patterns{"any", "first", "second"};
  static constexpr std::tuple parameters{
      regista::boolean("kick_off", &SetPlay::kick_off,
                       "The kick-off counts; when none of the six set plays is chosen, all of them count"),
      regista::boolean("kick_in", &SetPlay::kick_in, "The kick-in counts"),
      regista::boolean("goal_kick", &SetPlay::goal_kick, "The goal kick counts"),
      regista::boolean("corner_kick", &SetPlay::corner_kick, "The corner kick counts"),
      regista::boolean("pushing_free_kick", &SetPlay::pushing_free_kick, "The pushing free kick counts"),
      regista::boolean("penalty_kick", &SetPlay::penalty_kick, "The penalty kick counts"),
      regista::within(&SetPlay::rule, regista::choice("whose", &set_play::Rule::whose, sides,
                                                      "The side that kicks; SPQR's code has contexts for either")),
      regista::within(
          &SetPlay::rule,
          regista::choice("pattern", &set_play::Rule::pattern, patterns,
                          "first and second share the set plays between them: kick-offs by goals and half, others by "
                          "the second in which they began; our choice: any, all of them")),
      regista::boolean("ready", &SetPlay::ready,
                       "Holds in the phase Ready; when none of the three phases is chosen, it holds in all of them"),
      regista::boolean("set", &SetPlay::set, "Holds in the phase Set"),
      regista::boolean("playing", &SetPlay::playing, "Holds in the phase Playing"),
      regista::within(
          &SetPlay::rule,
          regista::real(
              "at_most", &set_play::Rule::at_most, {0.0, 600.0}, "s",
              "Holds no longer than this after the set play, or its phase, began; rule book: a kick-in lasts 30; "
              "our choice: 600, until it ends")
              .tunable(),
          regista::real("hold_seconds", &set_play::Rule::hold_seconds, {0.0, 60.0}, "s",
                        "Holds so long after the ball came free, unless another set play begins; our choice: 0")
              .tunable())};

  set_play::Memory memory;

  void setup(const regista::Environment&) {
    using namespace set_play;
    const auto if_chosen = [](bool chosen, int kind) { return chosen ? one(kind) : Set{0}; };
    rule.kinds = if_chosen(kick_off, REGISTA_SET_PLAY_KICK_OFF) | if_chosen(kick_in, REGISTA_SET_PLAY_KICK_IN) |
                 if_chosen(goal_kick, REGISTA_SET_PLAY_GOAL_KICK) |
                 if_chosen(corner_kick, REGISTA_SET_PLAY_CORNER_KICK) |
                 if_chosen(pushing_free_kick, REGISTA_SET_PLAY_PUSHING_FREE_KICK) |
                 if_chosen(penalty_kick, REGISTA_SET_PLAY_PENALTY_KICK);
    rule.phases = if_chosen(ready, REGISTA_PHASE_READY) | if_chosen(set, REGISTA_PHASE_SET) |
                  if_chosen(playing, REGISTA_PHASE_PLAYING);
    if (rule.kinds == 0) rule.kinds = ~Set{0};
    if (rule.phases == 0) rule.phases = one(REGISTA_PHASE_READY) | one(REGISTA_PHASE_SET) | one(REGISTA_PHASE_PLAYING);
  }
  void reset(std::uint64_t) { memory.forget(); }
  bool holds(const regista::Frame& frame) {
    const regista::World world = frame.world();
    const regista::Game& game = world.game();
    return memory.update(rule, frame.time(),
                         {game.set_play, game.phase, game.own_kick == 1, game.phase_time, game.half,
                          game.own_score + game.opponent_score});
  }
};

}  // namespace

REGISTA_PLUGIN(SetPlay, regista::context)
