// SPDX-License-Identifier: MIT
// All numbers about one match, a function of its course alone: how well the teams were coordinated (metrics_roles.hpp),
// on what they agreed (metrics_agreement.hpp), how long they held their roles (metrics_tenure.hpp), how far apart they
// wanted to be (metrics_targets.hpp), who went for the ball (metrics_ball.hpp), how well they knew the world
// (metrics_world.hpp), what they sent, and their soccer (metrics_play.hpp). Fed with plain values as the match goes on;
// it keeps sums, not the course. docs/metrics.md lists every number.
//
// Sampled at 10 Hz in the phase Playing, each sample counting 0.1 s; beliefs once a second.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/arena.hpp"
#include "match/belief.hpp"
#include "match/game_state.hpp"
#include "match/metrics_agreement.hpp"
#include "match/metrics_ball.hpp"
#include "match/metrics_play.hpp"
#include "match/metrics_plugins.hpp"
#include "match/metrics_roles.hpp"
#include "match/metrics_targets.hpp"
#include "match/metrics_tenure.hpp"
#include "match/metrics_world.hpp"
#include "mind/command.hpp"

namespace regista::match {

// What became of the segments of a team's mailboxes; see mind/world/segment_counts.hpp.
struct SegmentMetrics {
  std::int64_t offered = 0, refused = 0, sent = 0, dropped = 0, heard = 0, bytes = 0;
};

struct TeamMetrics {
  TeamMetrics();
  CoordinationMetrics coordination;
  AgreementMetrics agreement;
  TenureMetrics tenure;
  TargetMetrics targets;
  BallMetrics ball;
  WorldModelMetrics world_model;
  PlayMetrics play;
  int packets = 0;                     // sent, charged or not delivered as too long
  std::int64_t packet_bytes = 0;       // of those
  std::vector<std::string> reasons;    // names; those of abi.h first
  std::vector<int> packets_by_reason;  // in that order
  std::vector<int> budget_curve;       // packets left when the clock of the match shows 1, 2, ... minutes
  SegmentMetrics segments;
  PluginMetrics plugins;
  int falls = 0, penalties = 0, kicks = 0, touches = 0;
};

struct MatchMetrics {
  std::array<TeamMetrics, 2> teams;  // by side
  double playing_seconds = 0.0;      // phase Playing
  double in_play_seconds = 0.0;      // without set plays
  BallRests ball_rests;              // in play, though somebody could soon be there
  double ball_crowd_seconds = 0.0;   // in play, with five robots or more at the ball
  int duels = 0;
};

class Metrics {
 public:
  // Arrays are by side.
  Metrics(const config::Rules& rules, const std::array<config::Robot, 2>& robots,
          const std::array<std::vector<Role>, 2>& roles, const std::array<std::vector<std::string>, 2>& reasons = {},
          const std::array<std::vector<mind::TeamMetric>, 2>& plugin_metrics = {});

  // Who is told of each shot, meant pass, clearance and duel that is counted.
  void tell_play(PlayTeller tell) { play_.tell(std::move(tell)); }
  void now(double time) { play_.now(time); }  // s of match time; to be called before what happens then is told

  // Robot `number` has decided. sees_ball: in the image it decided on. time: s of match time.
  void decided(Side side, int number, const mind::Outcome& outcome, bool sees_ball, double time,
               const GameState& state);
  // From now on it decides nothing, and holds no role.
  void crashed(Side side, int number, const GameState& state);

  // What it believes after this decision. Bodies: the truth at that instant, robots by id, then the ball.
  void believes(Side side, int number, const Belief& belief, std::span<const BodyState> bodies, const GameState& state);

  std::size_t reasons(Side side) const { return result_.teams[index(side)].reasons.size(); }
  std::size_t plugin_metrics(Side side) const { return plugins_[index(side)].count(); }
  void sent(Side side, int reason, std::size_t bytes, double time);  // s since the start of the match
  void fell(Side side) { ++result_.teams[index(side)].falls; }
  // A kick has reached the ball. receiver: shirt number of the teammate that it is meant for, 0 = nobody.
  void kicked(int id, int receiver) {
    ++result_.teams[index(roster_.side(id))].kicks;
    play_.kicked(id, receiver);
  }
  void penalised(Side side) { ++result_.teams[index(side)].penalties; }
  void scored(Side side) { play_.scored(side); }  // a goal that counts
  void ball_placed() { play_.ball_placed(); }     // by hand
  // After each physics step, before the referee judges it. touched_by: who touched the ball (id; -1: nobody).
  void stepped(const BodyState& ball, int touched_by, const GameState& state);

  // To be called ten times in a second of match time. able: who stands and has not crashed; what it says of penalised
  // robots is not looked at.
  void sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able);

  // Which of the able robots (see above) go for the ball while the phase is Playing; see metrics_ball.hpp.
  RobotSet chasing(const GameState& state, const BodyState& ball, RobotSet able) const;

  void finish() { play_.finish(); }  // the match has ended; before the result

  // At the end of the match: its state, and its length in seconds.
  MatchMetrics result(const GameState& state, double end) const;

 private:
  std::uint32_t active(Side side, const GameState& state) const;
  // What it decided, for all measures but the tenures.
  void took(Side side, int number, const mind::Outcome& outcome, bool sees_ball, const GameState& state);
  // Of minutes that have passed and are not in the curve yet.
  void add_minutes(const GameState& state, std::array<std::vector<int>*, 2> curves) const;

  Roster roster_;
  double half_;  // s
  std::array<std::vector<Role>, 2> table_;
  std::array<RoleMeasures, 2> roles_;
  std::array<AgreementMeasures, 2> agreements_;
  std::array<TenureMeasures, 2> tenures_;
  std::array<TargetMeasures, 2> targets_;
  BallMeasures ball_;
  std::array<WorldMeasures, 2> worlds_;
  std::array<PluginMeasures, 2> plugins_;
  PlayMeasures play_;
  MatchMetrics result_;
  int samples_ = 0, in_play_ = 0;
  std::optional<Side> last_touch_;
  std::vector<Vector> own_, opponents_;  // the truth of a comparison
};

}  // namespace regista::match
