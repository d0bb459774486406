// SPDX-License-Identifier: MIT
// Glue of the behaviours that play the ball: hands the claim of the ball and the choice of a kick what the robot
// believes, and keeps what must not flicker: the claim, the last choice, how long it has waited at the ball.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <span>
#include <vector>

#include <regista/behaviour.hpp>
#include <regista/log.hpp>

#include "claim.hpp"
#include "expected_gain.hpp"
#include "kick_choice.hpp"
#include "read_situation.hpp"
#include "situation.hpp"

namespace behaviours {

enum class KickRule { metres, expected_gain };

struct PlaySettings {
  KickRule kick_rule = KickRule::metres;
  GainSettings gain;
  ClaimSettings claim;
};

class BallPlay {
 public:
  void setup(const regista::Environment& environment, const regista::Host& host, const KickSettings& settings,
             const PlaySettings& play) {
    log_ = regista::Log(host);
    choice_ = KickChoice(settings);
    gain_ = ExpectedGain(play.gain);
    play_ = play;
    for (const regista::Kick& kick : environment.kicks()) {
      kinds_.push_back({kick.minimum_distance, kick.maximum_distance});
      direction_error_ = std::max(direction_error_, kick.direction_error);
    }
    teammates_.reserve(environment->team_size);
    claim_.reserve(environment->team_size);
    constexpr std::size_t most_opponents = 64;  // more than there are; only memory depends on it
    opponents_.reserve(most_opponents);
  }

  void forget() {
    last_.reset();
    waits_since_.reset();
    claim_.forget();
    told_ = {};
  }

  // Whether this robot goes for the ball now. `by_role`: its role does.
  bool plays_ball(const regista::Frame& frame, const Situation& situation, bool by_role) {
    if (play_.claim.nearest_plays) read_teammates(frame, situation, teammates_);
    const bool plays = claim_.update(situation, play_.claim, teammates_, by_role);
    tell(claim_.verdict());
    return plays;
  }

  // It does not go for the ball, and says so if it did.
  void withdraw() {
    claim_.forget();
    tell(claim_.verdict());
  }

  // Those that the robot believes in. Valid until the next call of this or of choose().
  std::span<const Blocker> opponents(const regista::Frame& frame) {
    read_opponents(frame, opponents_);
    return opponents_;
  }

  KickPlan choose(const regista::Frame& frame, const Situation& situation) {
    read_teammates(frame, situation, teammates_);
    read_opponents(frame, opponents_);
    const KickScene scene{situation.facts.field, situation.ball, kinds_, teammates_, opponents_, last_};
    last_ = play_.kick_rule == KickRule::metres ? choice_.choose(scene) : by_gain(scene, situation);
    return *last_;
  }

 private:
  // A line for people when the claim changes.
  void tell(const ClaimVerdict& verdict) {
    const bool same =
        verdict.kind == told_.kind && (verdict.kind != ClaimVerdict::leaves || verdict.other == told_.other);
    if (same) return;
    told_ = verdict;
    std::array<char, 96> line{};
    char* const text = line.data();
    const std::size_t room = line.size();
    const int other = verdict.other;
    int size = 0;
    if (verdict.kind == ClaimVerdict::by_role) {
      size = std::snprintf(text, room, "claim: none, the role decides");
    } else if (verdict.kind == ClaimVerdict::leaves) {
      size = std::snprintf(text, room, "claim: leaves the ball to robot %d, there in %.1f s, itself in %.1f s", other,
                           verdict.others, verdict.own);
    } else if (other != 0) {
      size = std::snprintf(text, room, "claim: takes the ball, there in %.1f s, robot %d in %.1f s", verdict.own, other,
                           verdict.others);
    } else {
      size = std::snprintf(text, room, "claim: takes the ball, there in %.1f s", verdict.own);
    }
    if (size > 0) log_.debug({text, std::min(room - 1, static_cast<std::size_t>(size))});
  }

  // From afar it is enough to come to the ball from the side of the own goal.
  KickPlan by_gain(const KickScene& scene, const Situation& situation) {
    const Vector2d to_goal = Vector2d(scene.field.length / 2.0, 0.0) - scene.ball;
    const bool far = (scene.ball - situation.frame.origin()).norm() > play_.gain.considered_within;
    if (far && to_goal.norm() > 1e-6 && !kinds_.empty()) {
      return kick_in_direction(kinds_, to_goal.normalized(), kinds_.front().maximum_distance);
    }
    return gain_.choose(gain_.scene(scene, situation, direction_error_, waited(situation)));
  }

  // s that the robot has been at the ball, and the ball lay.
  double waited(const Situation& situation) {
    constexpr double at_ball = 0.7, moved = 0.15;  // m
    const bool there = (situation.ball - situation.frame.origin()).norm() < at_ball;
    if (!there || !waits_since_ || (situation.ball - waits_at_).norm() > moved) {
      waits_since_ = situation.time;
      waits_at_ = situation.ball;
    }
    return there ? situation.time - *waits_since_ : 0.0;
  }

  PlaySettings play_;
  ExpectedGain gain_;
  Claim claim_;
  ClaimVerdict told_;
  regista::Log log_;
  double direction_error_ = 0.0;
  std::optional<double> waits_since_;  // match time
  Vector2d waits_at_{0, 0};
  KickChoice choice_;
  std::vector<KickKind> kinds_;
  std::vector<Teammate> teammates_;
  std::vector<Blocker> opponents_;
  std::optional<KickPlan> last_;
};

}  // namespace behaviours
