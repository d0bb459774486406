// SPDX-License-Identifier: MIT
// Where the ball is: within a box of the field, with a band about it so that a ball on its edge does not make the team
// change its mind ten times a second. With one side only it is attack or defence by the ball's x, which the SPQR team
// planned as contexts.
#pragma once

namespace ball_zone {

struct Box {
  double x_least, x_most, y_least, y_most;  // m, field frame, closed; empty when a least is above its most

  constexpr bool is_empty() const { return x_least > x_most || y_least > y_most; }
  constexpr bool contains(double x, double y, double band) const {
    return x >= x_least - band && x <= x_most + band && y >= y_least - band && y <= y_most + band;
  }
};

class Memory {
 public:
  // Enters at the box, leaves `band` >= 0 m beyond it. A ball that nobody knows is in no zone. An empty box holds
  // nothing, whatever its band. Call once per decision.
  bool update(const Box& box, double band, bool known, double x, double y) {
    inside_ = known && !box.is_empty() && box.contains(x, y, inside_ ? band : 0.0);
    return inside_;
  }
  void forget() { inside_ = false; }

 private:
  bool inside_ = false;
};

}  // namespace ball_zone
