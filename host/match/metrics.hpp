// SPDX-License-Identifier: MIT
// Computes all metrics of a match: coordination of the teams (metrics_coordination.hpp), knowledge of the world
// (metrics_world.hpp), chases of the ball and soccer (metrics_play.hpp), packets, and reports of plugins. The metrics
// depend only on what happens in the match. Metrics stores sums, not single events. docs/metrics.md lists every number.
//
// Metrics takes samples at 10 Hz in the phase Playing; each sample counts 0.1 s. Beliefs are sampled once a second.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/metrics_coordination.hpp"
#include "match/metrics_play.hpp"
#include "match/metrics_world.hpp"
#include "match/physics_world.hpp"
#include "mind/action.hpp"
#include "mind/extensions/plugin_log.hpp"

namespace regista::match {

constexpr int samples_per_second = 10;  // of the metrics
constexpr std::uint32_t steps_per_sample = physics_steps_per_second / samples_per_second;

constexpr double seconds(int samples) { return static_cast<double>(samples) / samples_per_second; }

// Return sum / count and part / whole; nothing if the divisor is 0.
constexpr std::optional<double> mean(double sum, int count) {
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}
constexpr std::optional<double> share(int part, int whole) { return mean(part, whole); }

// The numbers that the plugins of one team report about a match. A plugin declares how the reports of all robots are
// combined (see <regista/extensions/metric.h>). Names have the form "<plugin>.<metric>".
struct PluginMetrics {
  std::vector<std::string> total_names, value_names;
  std::vector<double> totals;                 // metrics that are sums, in the order of total_names
  std::vector<std::optional<double>> values;  // other metrics, in the order of value_names; nothing: never reported
};

class PluginMeasures {  // computes PluginMetrics
 public:
  PluginMeasures(std::vector<mind::TeamMetric> metrics, int team_size);

  std::size_t count() const { return metrics_.size(); }
  // The caller calls this after each decision of robot `number`. The reports must be without fault (see unsound()).
  void decided(int number, std::span<const mind::MetricReport> reports);
  // The caller calls this when robot `number` has crashed. The robot's last reports then count in no further sample.
  void crashed(int number);
  void sample();  // The caller calls this ten times a second in the phase Playing.

  PluginMetrics result() const;

 private:
  struct Told {
    std::int32_t place;  // place of the plugin's instance in the mind
    double value;
  };

  std::vector<mind::TeamMetric> metrics_;
  std::vector<mind::MetricReport> combined_;               // by metric
  std::vector<std::vector<std::vector<Told>>> last_told_;  // by metric and robot: last reports, for means over time
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
  std::int64_t packet_bytes = 0;       // bytes of the packets charged to the budget, including too long packets
  std::vector<std::string> reasons;    // names of reasons to send: first the events of abi.h
  std::vector<int> packets_by_reason;  // in the order of `reasons`
  std::vector<int> budget_curve;       // packets left in the budget after 1, 2, ... minutes of play
  mind::SegmentCounts segments;
  PluginMetrics plugins;
  int falls = 0;  // set at the end of play()
  int penalties = 0, kicks = 0, touches = 0;
};

struct MatchMetrics {
  std::array<TeamMetrics, 2> teams;  // by side
  double playing_seconds = 0.0;      // time in the phase Playing
  double in_play_seconds = 0.0;      // playing_seconds without set plays
  BallRests ball_rests;              // times in play when the ball rests although a robot could reach it within 3 s
  double ball_crowd_seconds = 0.0;   // time in play with at least five robots within 1 m of the ball
  int duels = 0;
};

class Metrics {
 public:
  // Arrays are indexed by side.
  Metrics(const config::Rules& rules, const std::array<config::Robot, 2>& robots,
          const std::array<std::vector<Role>, 2>& roles, const std::array<std::vector<std::string>, 2>& reasons = {},
          const std::array<std::vector<mind::TeamMetric>, 2>& plugin_metrics = {});

  void tell_play(PlayTeller tell) { play_.tell(std::move(tell)); }
  void now(double time) { play_.now(time); }  // match time of the following calls, s

  // The caller calls this after each decision. sees_ball: the decision's image showed the ball. time: match time, s.
  void decided(Side side, int number, const mind::Outcome& outcome, bool sees_ball, double time,
               const GameState& state);
  // The caller calls this when robot `number` has crashed. The robot has no role until its next decision.
  void crashed(Side side, int number, const GameState& state);

  // Compares the belief of robot `number` with the truth at its decision. bodies: robots by id, then the ball.
  void believes(Side side, int number, const Belief& belief, std::span<const BodyState> bodies, const GameState& state);

  std::size_t reasons(Side side) const { return result_.teams[index(side)].reasons.size(); }
  std::size_t plugin_metrics(Side side) const { return teams_[index(side)].plugins.count(); }
  void sent(Side side, int reason, std::size_t bytes, double time);  // time: match time, s
  // The foot of robot `id` has hit the ball. receiver: shirt number of the intended teammate; 0 = nobody.
  void kicked(int id, int receiver) {
    ++result_.teams[index(roster_.side(id))].kicks;
    play_.kicked(id, receiver);
  }
  void penalised(Side side) { ++result_.teams[index(side)].penalties; }
  void scored(Side side) { play_.scored(side); }  // a goal that counts
  void ball_placed() { play_.ball_placed(); }     // a person puts the ball down
  // Call after each physics step, before Referee::update(). touched_by: id of the robot that touched the ball, or -1.
  void stepped(const BodyState& ball, int touched_by, const GameState& state);

  // Must be called ten times a second. able: robots that stand and have not crashed; penalised robots are ignored.
  void sample(const GameState& state, std::span<const BodyState> bodies, RobotSet able);

  // Returns the robots of `able` that go for the ball in the phase Playing, as metrics_play.hpp defines it.
  RobotSet chasing(const GameState& state, const BodyState& ball, RobotSet able) const;

  void finish() { play_.finish(); }  // must be called at the end of the match, before result()

  // state: the game state at the end of the match. end: length of the match, s.
  MatchMetrics result(const GameState& state, double end) const;

 private:
  std::uint32_t active(Side side, const GameState& state) const;  // robots without penalty: bit n - 1 for robot n
  // Passes a decision to all measures except TenureMeasures.
  void took(Side side, int number, const mind::Outcome& outcome, bool sees_ball, const GameState& state);
  void add_minutes(const GameState& state, MatchMetrics& out) const;

  struct TeamMeasures {
    TeamMeasures(const config::Rules& rules, const std::vector<Role>& roles,
                 const std::vector<mind::TeamMetric>& metrics);

    std::vector<Role> table;
    RoleMeasures roles;
    AgreementMeasures agreement;
    TenureMeasures tenures;
    TargetMeasures targets;
    WorldMeasures world;
    PluginMeasures plugins;
  };
  Roster roster_;
  double half_;                        // duration of a half, s
  std::array<TeamMeasures, 2> teams_;  // by side
  BallMeasures ball_;
  PlayMeasures play_;
  MatchMetrics result_;
  int samples_ = 0, in_play_ = 0;
  std::optional<Side> last_touch_;
  std::vector<Vector> own_, opponents_;  // true positions for the comparison with a belief
};

}  // namespace regista::match
