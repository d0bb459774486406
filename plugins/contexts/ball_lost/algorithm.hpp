// SPDX-License-Identifier: MIT
// Nobody has seen the ball for a while: the team should search. The rule is that of the SPQR team's released code
// (2022 to 2024): own ball, team ball and the teammates' balls are all older than 4.5 s. The world's ball is the newest
// of them, so one age is enough. The hysteresis is ours: a single false detection need not end the search.
#pragma once

#include <limits>

namespace ball_lost {

struct Rule {
  double after = 4.5;       // s without a sighting until the ball counts as lost, > 0
  double seen_again = 0.0;  // s that the sightings must span before it counts as found; 0: one sighting is enough
};

class Memory {
 public:
  // time: s, never runs back. known: somebody believes to know the ball; age: s since it was last seen, >= 0. Returns
  // whether the ball is lost. Call once per decision.
  bool update(const Rule& rule, double time, bool known, double age) {
    if (!known || age > rule.after) {
      lost_ = true;
      first_sighting_ = none;
    } else if (lost_) {
      // Sightings that follow each other within `after` are one run; it spans from the first to the latest.
      const double latest = time - age;
      if (first_sighting_ == none) first_sighting_ = latest;
      lost_ = latest - first_sighting_ < rule.seen_again - rounding;
    }
    return lost_;
  }
  void forget() { *this = Memory(); }

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();
  static constexpr double rounding = 1e-9;  // s, of time - age
  bool lost_ = false;
  double first_sighting_ = none;
};

}  // namespace ball_lost
