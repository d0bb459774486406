// SPDX-License-Identifier: MIT
// When to spend a packet, after B-Human (Roefer et al., "B-Human 2022 - More Team Play with Less Communication",
// RoboCup 2022, LNCS 13561; numbers of the code release of 2025): when what the teammates extrapolate from this robot's
// last packet is no longer so. Each cause must last a while, longer the farther the ball is, so that what passes by
// itself costs nothing. Then spending.hpp has to agree.
//
// Decided by us, where the sources leave it open:
//   - "own ball off the team ball for more than 0.3 s": the place where the own ball comes to rest must be 0.3 m from
//     that of the team's ball, for at least 0.3 s;
//   - the ball's place is compared with what this robot itself said of it; a ball that it did not see then is another
//     cause;
//   - the first packet of a robot has nothing to differ from and nothing to wait for but the budget;
//   - without a ball causes must last as long as with a ball far away;
//   - an urgent offer of another plugin stands in the place of B-Human's proposals;
//   - a pass target is whom the kick of this decision is meant for, nobody too. Packets do not say it: what goes out is
//     where the passer and its ball are now. A host that does not tell it has no such cause.
// Not here, because the host has no such news for a sender: the referee's signals, the indirect kick.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "extrapolation.hpp"
#include "spending.hpp"

namespace extrapolated_change {

// Why a packet is sent; in order of importance.
enum class Cause {
  whistle,
  first,        // it has not sent yet
  offer,        // another plugin has something urgent to say
  pass_target,  // its kick is meant for another one than when it sent
  upright,      // it fell, or stands again
  role,         // it has another role than it said
  ball_seen,    // it sees the ball, having said that it does not, or the other way round
  pose,         // it is not where the teammates believe it
  ball,         // the same of the ball that it sees
  ball_is_old,  // nobody has told of the ball for long, and it sees it
};
inline constexpr std::size_t causes = 10;

struct Settings {
  Sense sense;
  double own_interval = 1.0;                       // s between two packets of one robot
  double lasts_near = 0.3, lasts_far = 1.2;        // s that a cause must last, with the ball near or far
  double near = 1.0, far = 3.0;                    // m from the ball
  double active_lasts = 0.1;                       // s: of the role that plays the ball, newly taken
  double poor_pose = 0.5;                          // m: with a larger standard deviation nothing is told
  double vanished_after = 3.0;                     // s
  double seen_within = 0.5;                        // s: a ball that old is seen
  double team_ball_off_for = 0.3;                  // s
  double retell_after = 9.0, retell_spread = 0.5;  // s, and for each number
  double whistle_within = 4.0;                     // s
  double whistle_reserve = 15.0;                   // packets: a whistle is told while more are left
};

struct Situation {
  double time = 0.0;
  int number = 1;
  bool playing = true;          // news of play count now
  double pose_deviation = 0.0;  // m
  Point place;
  double speed = 0.0;  // m/s
  bool upright = true;
  int role = -1;
  bool role_is_active = false;  // it is the one that plays the ball
  // As its teammates know it from its last packet; nothing before the first.
  std::optional<int> told_role;
  Point told_target;
  // The own ball: it sees one, or has seen it so long ago.
  bool knows_ball = false;
  double ball_age = std::numeric_limits<double>::infinity();  // s
  Point ball, ball_rests;                                     // now, and where it will come to rest
  // What all together have told.
  bool team_knows_ball = false;
  double team_ball_age = std::numeric_limits<double>::infinity();
  Point team_ball_rests;
  std::span<const Point> mates;
  bool heard_whistle = false, urgent_offer = false;  // now
  std::optional<int> pass_target;  // number of a teammate, 0 = nobody; nothing: the host does not tell
  double since_own = 0.0;          // s
  Allowance allowance;
  Purse purse;
};

class Sender {
 public:
  // Whether to send now, and why. Call once per decision.
  std::optional<Cause> decide(const Settings& settings, const Situation& now) {
    if (now.heard_whistle) whistle_at_ = now.time;
    if (target_is_missing_ && now.told_role) {  // the host chose it after the last call
      walk_.target = now.told_target;
      target_is_missing_ = false;
    }
    const std::array<bool, causes> holds = ask(settings, now);
    for (std::size_t k = 0; k < causes; ++k) {
      if (!holds[k]) {
        since_[k] = never;
      } else if (since_[k] == never) {
        since_[k] = now.time;
      }
    }
    if (now.since_own < settings.own_interval - rounding) return std::nullopt;
    if (now.pose_deviation > settings.poor_pose) return std::nullopt;
    for (std::size_t k = 0; k < causes; ++k) {
      const auto cause = static_cast<Cause>(k);
      if (!holds[k] || now.time - since_[k] < must_last(settings, now, cause) - rounding) continue;
      const bool granted =
          cause == Cause::whistle ? now.purse.left > settings.whistle_reserve : may_spend(now.allowance, now.purse);
      if (granted) return sent(settings, now, cause);
    }
    return std::nullopt;
  }

  // Where the teammates believe this robot; nothing before its first packet.
  std::optional<Point> believed(double time) const {
    if (!has_sent_) return std::nullopt;
    return extrapolate(walk_, time - sent_at_);
  }

 private:
  static constexpr double rounding = 1e-9;  // s
  static constexpr double never = -std::numeric_limits<double>::infinity();

  static bool is_seen(const Settings& settings, const Situation& now) {
    return now.knows_ball && now.ball_age < settings.vanished_after;
  }

  std::array<bool, causes> ask(const Settings& settings, const Situation& now) {
    std::array<bool, causes> out{};
    const auto is = [&](Cause cause) -> bool& { return out[static_cast<std::size_t>(cause)]; };
    is(Cause::whistle) = now.time - whistle_at_ <= settings.whistle_within;
    if (!now.playing) return out;
    is(Cause::offer) = now.urgent_offer;
    is(Cause::first) = !has_sent_;
    const bool sees = now.knows_ball && now.ball_age <= settings.seen_within;
    is(Cause::ball_is_old) = sees && (!now.team_knows_ball ||
                                      now.team_ball_age > settings.retell_after + settings.retell_spread * now.number);
    const bool off =
        sees && (!now.team_knows_ball || distance(now.ball_rests, now.team_ball_rests) > settings.sense.distance);
    if (!off) {
      off_team_ball_since_ = never;
    } else if (off_team_ball_since_ == never) {
      off_team_ball_since_ = now.time;
    }
    if (!has_sent_) return out;
    is(Cause::pass_target) = now.pass_target && now.pass_target != told_pass_target_;
    is(Cause::upright) = now.upright != told_upright_;
    is(Cause::role) = now.told_role && now.role != *now.told_role;
    is(Cause::ball_seen) = is_seen(settings, now) != told_seen_;
    is(Cause::pose) =
        !target_is_missing_ && matters(extrapolate(walk_, now.time - sent_at_), now.place, now.mates, settings.sense);
    is(Cause::ball) = off && now.time - off_team_ball_since_ > settings.team_ball_off_for - rounding && told_ball_ &&
                      matters(*told_ball_, now.ball_rests, now.mates, settings.sense);
    return out;
  }

  static double must_last(const Settings& settings, const Situation& now, Cause cause) {
    if (cause == Cause::whistle || cause == Cause::offer || cause == Cause::first) return 0.0;
    if (cause == Cause::role && now.role_is_active) return settings.active_lasts;
    if (!now.knows_ball) return settings.lasts_far;
    const double away = distance(now.place, now.ball);
    if (away <= settings.near) return settings.lasts_near;
    if (away >= settings.far) return settings.lasts_far;
    const double share = (away - settings.near) / (settings.far - settings.near);
    return settings.lasts_near + share * (settings.lasts_far - settings.lasts_near);
  }

  // A packet carries the whole state: whatever was waiting is told with it.
  Cause sent(const Settings& settings, const Situation& now, Cause cause) {
    since_.fill(never);
    whistle_at_ = never;
    off_team_ball_since_ = never;
    has_sent_ = true;
    sent_at_ = now.time;
    walk_ = {now.place, now.place, now.speed};
    target_is_missing_ = true;
    told_pass_target_ = now.pass_target;
    told_upright_ = now.upright;
    told_seen_ = is_seen(settings, now);
    told_ball_.reset();
    if (told_seen_) told_ball_ = now.ball_rests;
    return cause;
  }

  static constexpr std::array<double, causes> all_never() {
    std::array<double, causes> out{};
    out.fill(never);
    return out;
  }
  std::array<double, causes> since_ = all_never();
  double whistle_at_ = never, off_team_ball_since_ = never;
  bool has_sent_ = false;
  double sent_at_ = 0.0;
  Walk walk_;
  bool target_is_missing_ = false;
  std::optional<int> told_pass_target_;
  bool told_upright_ = true, told_seen_ = false;
  std::optional<Point> told_ball_;
};

}  // namespace extrapolated_change
