// SPDX-License-Identifier: MIT
// Whether this robot is the only one that sees the ball. A robot is not told who sees what; it concludes it from two
// ages: that of the ball in its own world, and that of the ball in what has been sent. News in the latter that are
// newer than what it sent itself come from somebody else.
#pragma once

#include <algorithm>
#include <limits>

namespace event_based {

class BallWitness {
 public:
  struct Sighting {
    bool known;
    double age;  // s
  };

  // alone_after: s without news of the ball from others. Call once per decision, before sent().
  bool is_alone(double time, const Sighting& mine, const Sighting& common, double alone_after) {
    const double told = common.known ? time - common.age : never;
    if (told > told_by_me_ + tolerance) told_by_others_ = std::max(told_by_others_, told);
    seen_ = mine.known ? time - mine.age : never;
    const bool sees = mine.known && mine.age <= sees_within && seen_ > told_by_others_;
    return sees && time - told_by_others_ > alone_after;
  }
  // A packet left with what this robot knew at the last is_alone().
  void sent() { told_by_me_ = std::max(told_by_me_, seen_); }

 private:
  static constexpr double never = -std::numeric_limits<double>::infinity();
  static constexpr double sees_within = 0.5;  // s: the camera looks several times a second
  static constexpr double tolerance = 0.3;    // s: ages are rounded in packets
  double seen_ = never, told_by_me_ = never, told_by_others_ = never;
};

}  // namespace event_based
