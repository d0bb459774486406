// SPDX-License-Identifier: MIT
// The time in which a team may still send, over a whole match as it is told.
#include "mind/percepts.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "config/rules.hpp"

namespace regista::mind {
namespace {

struct HeardGame {
  double sending;  // s since the match began in which a team may send
  GameTold game;
};

// A match by the second, without set plays.
std::vector<HeardGame> told_match(const config::Durations& durations) {
  std::vector<HeardGame> out;
  double sending = 0.0;
  const auto pass = [&](int half, Phase phase, double lasts, double played) {
    for (double phase_time = 0.0; phase_time <= lasts; phase_time += 1.0) {
      GameTold game;
      game.half = half;
      game.phase = phase;
      game.phase_time = phase_time;
      game.half_time_left = durations.half - (phase == Phase::playing ? phase_time : played);
      game.match_time_left = game.half_time_left + (durations.halves - half) * durations.half;
      out.push_back({sending + (phase == Phase::initial ? 0.0 : phase_time), game});
    }
    if (phase != Phase::initial) sending += lasts;
  };
  for (int half = 1; half <= durations.halves; ++half) {
    pass(half, Phase::initial, 1.0, 0.0);
    pass(half, Phase::ready, durations.ready, 0.0);
    pass(half, Phase::set, durations.set, 0.0);
    pass(half, Phase::playing, durations.half, 0.0);
  }
  return out;
}

// So the even share falls from the whole budget to nothing, without a jump at a kick-off or between the halves.
TEST(SendingTime, IsWhatIsLeftOfReadySetAndPlay) {
  config::Durations league, no_set = league, one_half = league, none = league;
  no_set.set = 0.0;
  one_half.halves = 1;
  none.ready = none.set = 0.0;
  for (const config::Durations& durations : {league, no_set, one_half, none}) {
    config::Rules rules;
    rules.durations = durations;
    double line = rules.messages.budget;
    const std::vector<HeardGame> match = told_match(durations);
    for (const HeardGame& each : match) {
      const double left = sending_time_left(durations, each.game);
      EXPECT_EQ(left, config::sending_time(durations) - each.sending) << each.sending;
      const double now = config::packet_line(rules, left);
      EXPECT_LE(now, line);
      EXPECT_LE(line - now, rules.messages.budget / config::sending_time(durations) + 1e-9);
      line = now;
    }
    EXPECT_EQ(config::packet_line(rules, sending_time_left(durations, match.front().game)), rules.messages.budget);
    EXPECT_EQ(line, 0.0);
  }
}

TEST(SendingTime, AReadyAfterAGoalTakesNoneBesides) {
  const config::Durations durations;
  GameTold game;
  game.phase = Phase::ready;
  game.half = 2;
  game.half_time_left = game.match_time_left = 100.0;
  for (const Phase phase : {Phase::ready, Phase::set, Phase::playing}) {
    game.phase = phase;
    EXPECT_EQ(sending_time_left(durations, game), 100.0);
  }
}

// Who missed the whistle still believes in Set, with a clock that stands.
TEST(SendingTime, ALateKickOffTakesNoMoreThanItsTime) {
  const config::Durations durations;
  GameTold game;
  game.phase = Phase::set;
  game.half_time_left = 600.0;
  game.match_time_left = 1200.0;
  for (const auto& [phase_time, left] : {std::pair{0.0, 1255.0}, {5.0, 1250.0}, {15.0, 1250.0}}) {
    game.phase_time = phase_time;
    EXPECT_EQ(sending_time_left(durations, game), left);
  }
  game.phase = Phase::ready;
  game.phase_time = 50.0;
  EXPECT_EQ(sending_time_left(durations, game), 1255.0);
}

}  // namespace
}  // namespace regista::mind
