// SPDX-License-Identifier: MIT
// Who of a team goes to the ball. A role names one robot, on what all robots know; but the ball rolls on, and the news
// of teammates grow old. Whoever is surely the first at the ball takes it, whatever its role, and the robot of the role
// leaves it to a teammate that is surely there before. The striker of the HULKs is claimed in the same way, by the time
// until a robot can kick. Teammates learn of a claim by the target that the robot announces in its packets.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "approach.hpp"
#include "situation.hpp"

namespace behaviours {

struct ClaimSettings {
  bool nearest_plays = false;  // otherwise the role decides alone
  double sooner = 0.1;         // s: so much sooner than all others a robot takes a ball that is not its role's
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

// What became of the claim in the last decision, for people who ask why somebody went, or did not.
struct ClaimVerdict {
  enum Kind { by_role, takes, leaves } kind = by_role;
  int other = 0;                   // the teammate that is there first, or next; 0: there is none
  double own = 0.0, others = 0.0;  // s until this robot, and that teammate, is at the ball
};

class Claim {
 public:
  void reserve(std::size_t teammates) { times_.reserve(teammates); }
  void forget() {
    holds_ = leaves_ = false;
    verdict_ = {};
  }
  const ClaimVerdict& verdict() const { return verdict_; }

  // Whether this robot plays the ball now. `by_role`: its role plays it.
  bool update(const Situation& situation, const ClaimSettings& settings, std::span<const Teammate> teammates,
              bool by_role) {
    if (!settings.nearest_plays || !situation.ball_trusted) {
      forget();
      return by_role;
    }
    const double own = meeting(situation, situation.frame.origin()).time;
    const double margin = holds_ ? settings.kept : settings.sooner;
    verdict_ = {};
    times_.clear();
    for (const Teammate& mate : teammates) {
      times_.push_back(stays_home(situation, mate) ? never : meeting(situation, mate.position).time);
      if (by_role || before(own, margin, settings, mate, times_.back())) continue;
      holds_ = leaves_ = false;  // one that is sooner is enough where nobody has to leave the ball
      return false;
    }
    holds_ = before_all(own, margin, settings, teammates, nobody);
    leaves_ = leaves_to_another(own, settings, teammates);
    if (holds_ || (by_role && leaves_)) {
      verdict_ = {holds_ ? ClaimVerdict::takes : ClaimVerdict::leaves, 0, own, 0.0};
      const auto soonest = std::min_element(times_.begin(), times_.end());
      if (soonest != times_.end() && *soonest < never) {
        verdict_.other = teammates[static_cast<std::size_t>(soonest - times_.begin())].number;
        verdict_.others = *soonest;
      }
    }
    return holds_ || (by_role && !leaves_);
  }

 private:
  static constexpr std::size_t nobody = static_cast<std::size_t>(-1);
  static constexpr double never = std::numeric_limits<double>::infinity();

  // The goalkeeper does not come out for a ball beyond its penalty area.
  static bool stays_home(const Situation& situation, const Teammate& mate) {
    constexpr int goalkeeper = 1;  // the rules number it so
    const Field& field = situation.facts.field;
    const Vector2d own_goal(-field.length / 2.0, 0.0);
    return mate.number == goalkeeper && (situation.ball - own_goal).norm() > field.penalty_area_length;
  }

  // Whether somebody who is there in `time` is so much sooner than a teammate that needs `other`. It may have come
  // nearer since its last packet.
  static bool before(double time, double margin, const ClaimSettings& settings, const Teammate& mate, double other) {
    return time + margin < other - settings.doubt * mate.age;
  }

  // The same of all teammates but one.
  bool before_all(double time, double margin, const ClaimSettings& settings, std::span<const Teammate> teammates,
                  std::size_t but) const {
    for (std::size_t i = 0; i < teammates.size(); ++i) {
      if (i != but && !before(time, margin, settings, teammates[i], times_[i])) return false;
    }
    return true;
  }

  // Only to one that takes the ball, as it can be computed here: or nobody would go.
  bool leaves_to_another(double own, const ClaimSettings& settings, std::span<const Teammate> teammates) const {
    std::size_t first = nobody;
    for (std::size_t i = 0; i < teammates.size(); ++i) {
      if (teammates[i].age <= settings.news_at_most && (first == nobody || times_[i] < times_[first])) first = i;
    }
    if (first == nobody) return false;
    const double latest = times_[first] + settings.doubt * teammates[first].age;
    return latest + (leaves_ ? settings.kept : settings.left) < own &&
           before_all(times_[first], settings.sooner, settings, teammates, first);
  }

  std::vector<double> times_;  // until each teammate is at the ball, s; keeps its memory
  bool holds_ = false, leaves_ = false;
  ClaimVerdict verdict_;
};

}  // namespace behaviours
