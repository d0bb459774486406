// SPDX-License-Identifier: MIT
// Glue of the behaviours that kick: hands the kick choice what the robot believes, and keeps what must not flicker: the
// last choice.
#pragma once

#include <optional>
#include <vector>

#include <regista/behaviour.hpp>

#include "kick_choice.hpp"
#include "situation.hpp"

namespace behaviours {

class KickMemory {
 public:
  void setup(const regista::Environment& environment, const KickSettings& settings) {
    choice_ = KickChoice(settings);
    for (const regista::Kick& kick : environment.kicks()) {
      kinds_.push_back({kick.minimum_distance, kick.maximum_distance});
    }
    teammates_.reserve(environment->team_size);
    constexpr std::size_t most_opponents = 64;  // more than there are; only memory depends on it
    opponents_.reserve(most_opponents);
  }

  void forget() { last_.reset(); }

  KickPlan choose(const regista::Frame& frame, const Situation& situation) {
    const regista::World world = frame.mine();
    teammates_.clear();
    for (const regista::Robot& robot : world.robots()) {
      const bool reachable = (robot.flags & REGISTA_ROBOT_ACTIVE) != 0 && (robot.flags & REGISTA_ROBOT_FALLEN) == 0 &&
                             robot.number != situation.facts.own_number;
      if (reachable) teammates_.push_back({{robot.pose[0], robot.pose[1]}, robot.age});
    }
    opponents_.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      opponents_.push_back({{opponent.position[0], opponent.position[1]}, opponent.weight});
    }
    last_ = choice_.choose({situation.facts.field, situation.ball, kinds_, teammates_, opponents_, last_});
    return *last_;
  }

 private:
  KickChoice choice_;
  std::vector<KickKind> kinds_;
  std::vector<Receiver> teammates_;
  std::vector<Blocker> opponents_;
  std::optional<KickPlan> last_;
};

}  // namespace behaviours
