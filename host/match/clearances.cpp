// SPDX-License-Identifier: MIT
#include "match/clearances.hpp"

#include <utility>

namespace regista::match {

void Clearances::kicked(int id, Vector ball, double direction, double time) {
  kick_.reset();
  if (direction * ball.x < -length_ / 6.0) kick_ = {id, ball, direction, time};
}

std::optional<Clearances::Kick> Clearances::rolled(Vector ball) {
  if (!kick_) return std::nullopt;
  const double direction = kick_->direction;
  const bool left = direction * ball.x >= -length_ / 6.0;
  const bool far = to_goal(ball, direction) > to_goal(kick_->at, direction) + cleared_way;
  return left || far ? std::exchange(kick_, std::nullopt) : std::nullopt;
}

}  // namespace regista::match
