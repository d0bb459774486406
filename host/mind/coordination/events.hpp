// SPDX-License-Identifier: MIT
// The events e of Affinita et al. 2023: what happened to this robot since its last decision that its teammates may want
// to know. Whether one is worth a packet is for the sender to say; here they are only noticed. As it arrives at the
// others, an event is a Report (mind/world/packet.hpp).
#pragma once

#include <vector>

#include "mind/coordination/decision.hpp"
#include "mind/percepts.hpp"
#include "mind/world/world_model.hpp"

namespace regista::mind {

class EventDetector {
 public:
  explicit EventDetector(int own_number) : own_number_(own_number) {}

  // `searching`: the own role is one of looking for the ball. Replaces `out`.
  void detect(const Percepts& percepts, const WorldModel& world, const Decision& decision, bool searching,
              std::vector<regista_event>& out);

 private:
  int own_number_;
  bool first_ = true;
  int role_ = -1, context_ = -1, phase_ = 0;
  bool fallen_ = false, penalised_ = false, searching_ = false;
  double ball_seen_at_ = 0.0, team_ball_seen_at_ = 0.0;
};

}  // namespace regista::mind
