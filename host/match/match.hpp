// SPDX-License-Identifier: MIT
// One match from the first half's placement, or from an opening, to the end: a pure function of its setup and of the
// minds that play. Minds are known as mind::Think only, one for each robot; all that reaches them are percepts and
// packets.
//
// In each physics step (50 Hz): the robots whose turn it is decide, bodies move, the arena steps, the referee judges.
// A robot decides once in a decision period; side and number spread the robots over the steps of a period.
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
#include "match/arena.hpp"
#include "match/digest.hpp"
#include "match/game_state.hpp"
#include "match/metrics.hpp"
#include "match/physics_log.hpp"
#include "match/play_event.hpp"
#include "mind/command.hpp"
#include "mind/extensions/log_line.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// Arrays are by side (index(Side)).
struct Setup {
  config::Rules rules;
  std::array<config::Robot, 2> robots;
  std::array<config::Disturbance, 2> disturbances;
  std::array<std::vector<Role>, 2> roles;  // the teams' tables of roles; Outcome::role is a row of it
  // What their packets are sent for; Outcome::send_reason is one of them. Empty: the events of abi.h.
  std::array<std::vector<std::string>, 2> reasons;
  // The numbers that their plugins declare; Outcome::metrics are of them.
  std::array<std::vector<mind::TeamMetric>, 2> plugin_metrics;
  std::uint64_t seed = 1;
  std::optional<double> limit;  // s of simulated time after which the match ends
  // The scene that it starts from, in play, instead of a kick-off; without a limit its length is one.
  std::optional<config::Opening> opening;
};

struct Result {
  std::array<int, 2> score{};
  Ended ended = Ended::no;
  double simulated_seconds = 0.0;
  std::array<int, 2> packets{};  // charged
  MatchMetrics metrics;
  std::uint64_t hash = 0;  // over the course of the match
};

// s of simulated time after which it ends, if anything ends it before its rules do.
std::optional<double> limit_of(const Setup& setup);

// No match of this setup ends with a larger one: the mercy rule ends it, and after each goal the robots go back to
// their places before play goes on.
int most_goal_difference(const Setup& setup);

const char* name(Ended ended);  // "full_time", "mercy", "limit"

// The truth after a physics step. Memory is the match's, for the time of the call. World frame.
struct Snapshot {
  double time;
  const GameState& state;
  std::span<const BodyState> bodies;  // robots by id (home 1..n, away 1..n), then the ball
  RobotSet fallen, kicking;
  RobotSet chasing;  // go for the ball, in Playing: see metrics_ball.hpp
  RobotSet crashed;  // by a disturbance: decide nothing, and hold no role
};

struct Decision {
  double time;
  Side side;
  int number;
  const mind::Percepts& percepts;
  std::span<const mind::HeardPacket> heard;
  const mind::Outcome& outcome;
  // The packet of the outcome has left the robot and counts as sent: nobody's that may not send, whose radio is silent,
  // or outside of Ready, Set and Playing. One that is too long is charged, and heard by nobody.
  bool packet_charged;
};

// Whoever wants to watch. It cannot change the match. Empty functions are not called.
struct Observer {
  std::function<void(double time, const GameState&)> second;  // each second of match time
  std::function<void(double time, const Event&, const GameState&)> event;
  PlayTeller play;  // each shot, meant pass, clearance and duel, once it is decided
  std::function<void(const Snapshot&)> step;
  std::function<void(const Decision&)> decision;
  PhysicsLog* physics_log = nullptr;  // of what is done to the bodies, for Replay
  // Minds that this match creates (teams.hpp) keep these for AfterDecision: see mind::Telling.
  bool segments = false, drawings = false;
  bool outcomes_alone = false;  // AfterDecision reads no frames: parts that no plugin reads need not be made for it
  // Told each line that a plugin of such a mind writes, at once.
  mind::LogSink log;
};

// Plays. home, away: a mind for each robot, number n at n - 1. Throws std::invalid_argument when the setup cannot be
// played, std::runtime_error naming the robot when an outcome is not sound (not finite, no such kick or role or
// reason); what a mind throws passes through. beliefs: asks the minds what they believe, for the metrics; without it
// these say nothing of it.
Result play(const Setup& setup, std::span<const mind::Think> home, std::span<const mind::Think> away,
            const Observer* observer = nullptr, const Beliefs& beliefs = {});

}  // namespace regista::match
