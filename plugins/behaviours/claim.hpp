// SPDX-License-Identifier: MIT
// Who of a team goes to the ball. A role names one robot, on what all robots know; but the ball rolls on, and the news
// of teammates grow old. Whoever is surely the first at the ball takes it, whatever its role, and the robot of the role
// leaves it to a teammate that is surely there before. The striker of the HULKs is claimed in the same way, by the time
// until a robot can kick. Teammates learn of a claim by the target that the robot announces in its packets.
#pragma once

#include <algorithm>
#include <span>

#include "rolling_ball.hpp"
#include "situation.hpp"

namespace behaviours {

// A teammate that could play the ball: in play and on its feet.
struct Contender {
  Vector2d position{0, 0};
  double age = 0.0;  // s since the last news of it
  int number = 0;
};

struct ClaimSettings {
  bool nearest_plays = false;  // otherwise the role decides alone
  double sooner = 0.3;         // s: so much sooner than all others a robot takes a ball that is not its role's
  double kept = 0.0;           // s: as long as it is so much sooner it keeps what it has taken
  double left = 0.5;           // s: the robot of the role leaves the ball to a teammate that is so much sooner
  double news_at_most = 3.0;   // s: older news let nobody leave the ball
  double doubt = 0.05;         // s per s: a teammate may have come nearer since its last packet
  double room = 1.2;           // m: whoever leaves the ball stands so far behind it
};

// Where a robot stands that leaves the ball to a teammate: behind it, on the way to the own goal.
inline Pose place_behind(const Situation& situation, double room) {
  const Vector2d own_goal(-situation.facts.field.length / 2.0, 0.0);
  const Vector2d back = own_goal - situation.ball;
  const double distance = back.norm();
  const Vector2d place =
      distance < 1e-6 ? situation.ball : Vector2d(situation.ball + back * (std::min(room, distance) / distance));
  return {place.x(), place.y(), angle_of(situation.ball - place)};
}

class Claim {
 public:
  void forget() { holds_ = leaves_ = false; }

  // Whether this robot plays the ball now. `by_role`: its role plays it.
  bool update(const Situation& situation, const ClaimSettings& settings, std::span<const Contender> teammates,
              bool by_role) {
    if (!settings.nearest_plays || !situation.ball_trusted) {
      forget();
      return by_role;
    }
    const double own = meeting(situation, situation.frame.origin()).time;
    double soonest = 1e9;         // of those that may be there, and may have come nearer
    double soonest_surely = 1e9;  // of those whose news are young, as they were when these were sent
    for (const Contender& mate : teammates) {
      const double time = meeting(situation, mate.position).time;
      const double doubt = settings.doubt * mate.age;
      soonest = std::min(soonest, time - doubt);
      if (mate.age <= settings.news_at_most) soonest_surely = std::min(soonest_surely, time + doubt);
    }
    holds_ = own + (holds_ ? settings.kept : settings.sooner) < soonest;
    leaves_ = soonest_surely + (leaves_ ? settings.kept : settings.left) < own;
    return holds_ || (by_role && !leaves_);
  }

 private:
  bool holds_ = false, leaves_ = false;
};

}  // namespace behaviours
