// SPDX-License-Identifier: MIT
// All numbers about one match, a function of its course alone: how well the teams were coordinated (metrics_roles.hpp),
// how well they knew the world (metrics_world.hpp), what they sent, and their soccer (metrics_play.hpp). Fed with plain
// values as the match goes on; it keeps sums, not the course. docs/metrics.md lists every number.
//
// Sampled at 10 Hz in the phase Playing, each sample counting 0.1 s; beliefs once a second.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/rules.hpp"
#include "match/arena.hpp"
#include "match/belief.hpp"
#include "match/game_state.hpp"
#include "match/metrics_play.hpp"
#include "match/metrics_roles.hpp"
#include "match/metrics_world.hpp"

namespace regista::match {

struct TeamMetrics {
  TeamMetrics();
  CoordinationMetrics coordination;
  WorldModelMetrics world_model;
  PlayMetrics play;
  int packets = 0;                     // sent, charged or not delivered as too long
  std::vector<int> packets_by_reason;  // REGISTA_EVENT_*
  std::vector<int> budget_curve;       // packets left when the clock of the match shows 1, 2, ... minutes
  int falls = 0, penalties = 0, kicks = 0, touches = 0;
};

struct MatchMetrics {
  std::array<TeamMetrics, 2> teams;  // by side
  double playing_seconds = 0.0;      // phase Playing
  double in_play_seconds = 0.0;      // without set plays
};

class Metrics {
 public:
  Metrics(const config::Rules& rules, const std::array<std::vector<Role>, 2>& roles);

  // Robot `number` has decided. role: row or -1; assignment: per robot row, -1, -2, or empty. sees_ball: in the image
  // it decided on.
  void decided(Side side, int number, int role, std::span<const int> assignment, bool sees_ball,
               const GameState& state);

  // What it believes after this decision. Bodies: the truth at that instant, robots by id, then the ball.
  void believes(Side side, int number, const Belief& belief, std::span<const BodyState> bodies, const GameState& state);

  void sent(Side side, int reason, double time);  // s since the start of the match
  void fell(Side side) { ++result_.teams[index(side)].falls; }
  void kicked(Side side) { ++result_.teams[index(side)].kicks; }
  void penalised(Side side) { ++result_.teams[index(side)].penalties; }
  void scored(Side side) { play_.scored(side); }  // a goal that counts
  void ball_placed() { play_.ball_placed(); }     // by hand
  // After each physics step, before the referee judges it. touched_by: who touched the ball (id; -1: nobody).
  void stepped(const BodyState& ball, int touched_by, const GameState& state);

  // To be called ten times in a second of match time.
  void sample(const GameState& state, std::span<const BodyState> bodies);

  // At the end of the match: its state, and its length in seconds.
  MatchMetrics result(const GameState& state, double end) const;

 private:
  std::uint32_t active(Side side, const GameState& state) const;
  // Of minutes that have passed and are not in the curve yet.
  void add_minutes(const GameState& state, std::array<std::vector<int>*, 2> curves) const;

  Roster roster_;
  double half_;  // s
  std::array<RoleMeasures, 2> roles_;
  std::array<WorldMeasures, 2> worlds_;
  PlayMeasures play_;
  MatchMetrics result_;
  int samples_ = 0, in_play_ = 0;
  std::optional<Side> last_touch_;
  std::vector<Vector> own_, opponents_;  // the truth of a comparison
};

}  // namespace regista::match
