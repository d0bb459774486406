// SPDX-License-Identifier: MIT
// From role, target and belief to a command: which skill, and where to look. Keeps what must not flicker: the chosen
// kick.
#pragma once

#include <optional>

#include "mind/behaviour/kick_choice.hpp"
#include "mind/behaviour/situation.hpp"
#include "mind/command.hpp"
#include "mind/percepts.hpp"

namespace regista::mind {

class Behaviour {
 public:
  Command act(const Situation& situation, const Percepts& percepts);

 private:
  KickPlan kick(const Situation& situation);
  std::optional<KickPlan> last_kick_;
};

// Wanted heading of the camera, robot frame: on the ball most of the time, about the field for landmarks and other
// robots the rest; to and fro while the ball is lost.
double look(const Situation& situation);

}  // namespace regista::mind
