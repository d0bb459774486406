// SPDX-License-Identifier: MIT
// play() plays one match to the end. The match begins before the first half or with an opening. The result depends only
// on the setup and the minds (one mind::Think for each robot). A mind receives only percepts and packets.
//
// Each physics step (50 Hz) has four parts: some robots decide, the bodies move, the physics world steps, the referee
// judges. Each robot decides once in each decision period, in the physics step that its side and number determine.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/disturbance.hpp"
#include "config/opening.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/digest.hpp"
#include "match/game_state.hpp"
#include "match/metrics.hpp"
#include "match/physics_world.hpp"
#include "mind/action.hpp"
#include "mind/extensions/plugin_log.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// Everything that determines a match, besides the minds. Arrays are by side (index(Side)).
struct Setup {
  config::Rules rules;
  std::array<config::Robot, 2> robots;
  std::array<config::Disturbance, 2> disturbances;
  std::array<std::vector<Role>, 2> roles;  // by side: the table of roles; Outcome::role is a row of the table
  // By side: the team's reasons to send packets; Outcome::send_reason is an index. Empty: the events of abi.h.
  std::array<std::vector<std::string>, 2> reasons;
  // By side: the metrics that the team's plugins declare; MetricReport::metric is an index of this list.
  std::array<std::vector<mind::TeamMetric>, 2> plugin_metrics;
  std::uint64_t seed = 1;
  std::optional<double> limit;  // the match ends after this simulated time at the latest, s
  // If set, the match begins with this scene in play, without kick-off. The opening's length replaces an empty `limit`.
  std::optional<config::Opening> opening;
};

struct Result {
  std::array<int, 2> score{};
  Ended ended = Ended::no;
  double simulated_seconds = 0.0;
  std::array<int, 2> packets{};  // by side: number of packets charged to the budget
  MatchMetrics metrics;
  std::uint64_t hash = 0;  // value of Digest at the end of the match
};

// Returns the simulated time at which the match ends at the latest, s; nothing if only the rules end the match.
std::optional<double> limit_of(const Setup& setup);

// Returns an upper bound of the goal difference. The mercy rule and the time for Ready after each goal limit the goals.
int most_goal_difference(const Setup& setup);

// The truth after a physics step, in the world frame. The match owns the memory, which is valid during the callback.
struct Snapshot {
  double time;
  const GameState& state;
  std::span<const BodyState> bodies;  // robots by id (home 1..n, away 1..n), then the ball
  RobotSet fallen, kicking;
  RobotSet chasing;  // robots that go for the ball in Playing, as metrics_play.hpp defines it
  RobotSet crashed;  // robots crashed by a disturbance; a crashed robot does not decide and holds no role
};

struct Decision {  // one decision of one robot
  double time;
  Side side;
  int number;
  const mind::Percepts& percepts;
  std::span<const mind::HeardPacket> heard;
  const mind::Outcome& outcome;
  // Whether the outcome has a packet that was charged to the budget. False if the robot is penalised, its radio is
  // silent, or the phase is not Ready, Set or Playing. A packet that is too long is charged, but no robot receives it.
  bool packet_charged;
};

// Callbacks that watch a match. A callback cannot change the match. An empty function is not called.
struct Observer {
  std::function<void(double time, const GameState&)> second;  // called once in each second of match time
  std::function<void(double time, const Event&, const GameState&)> event;
  PlayTeller play;  // called for each shot, meant pass, clearance and duel, when its outcome is known
  std::function<void(const Snapshot&)> step;      // called after each physics step
  std::function<void(const Decision&)> decision;  // called after each decision
  PhysicsLog* physics_log =
      nullptr;  // receives the operations on the bodies, for PhysicsWorld::replay(); null: no recording
  // Whether minds that teams.hpp creates keep segments and drawings for AfterDecision (see mind::MindOptions).
  bool segments = false, drawings = false;
  bool outcomes_alone = false;  // true: minds compute only frame parts that plugins read, not those for AfterDecision
  mind::LogSink log;            // receives each log line of these minds' plugins when the plugin writes it
};

// home, away: one mind for each robot; robot n is at n - 1. beliefs: reads what a mind believes; if empty, the result
// has no metrics of beliefs. Throws std::invalid_argument for a setup that cannot be played. Throws std::runtime_error,
// which names the robot, if unsound() finds a fault in an outcome. play() does not catch exceptions of minds.
Result play(const Setup& setup, std::span<const mind::Think> home, std::span<const mind::Think> away,
            const Observer* observer = nullptr, const Beliefs& beliefs = {});

}  // namespace regista::match
