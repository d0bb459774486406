// SPDX-License-Identifier: MIT
// Where a role is played, computed from the rule that the team's page gives (config::TargetRule). Field frame.
#pragma once

#include "config/rules.hpp"
#include "config/team.hpp"
#include "mind/geometry.hpp"
#include "mind/world/distributed_world_model.hpp"

namespace regista::mind {

// The points that rules can name, for one world.
class Anchors {
 public:
  // `rolling_deceleration` in m/s^2, for the point where the ball will come to rest.
  Anchors(const config::FieldSize& field, double rolling_deceleration, const DistributedWorldModel& world);
  bool ball_known() const { return ball_known_; }
  Vector2d at(const config::Place& place) const;

 private:
  const config::FieldSize* field_;
  bool ball_known_;
  Vector2d ball_, ball_rest_;
};

Vector2d target_of(const config::TargetRule& rule, const Anchors& anchors);

}  // namespace regista::mind
