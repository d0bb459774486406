// SPDX-License-Identifier: MIT
// Sender plugin around algorithm.hpp: translates frame, events and budget; takes along what offers fit.
//
// Of the own last packet the sender remembers the pose and the speed that it was given when it sent; role and target it
// reads from the common world, as the host chooses the target after it. The number of packets left is the controller's,
// which the host tells at every decision, so that the own count of B-Human is not needed. Whether the own eyes see the
// ball, and whom the next kick is meant for, the extension regista.told says. A host without it tells of no pass; the
// ball of `mine` then counts as seen while its age is below half a decision period (what a teammate told is older).
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/sender.hpp>
#include <regista/told.hpp>

#include "algorithm.hpp"

namespace {

using extrapolated_change::Allowance;
using extrapolated_change::Cause;
using extrapolated_change::Clock;
using extrapolated_change::Point;
using extrapolated_change::Sense;
using extrapolated_change::Settings;

constexpr double never = -std::numeric_limits<double>::infinity();

struct ExtrapolatedChange {
  static constexpr auto id = "extrapolated_change", version = "1.0.0",
                        summary =
                            "A packet when teammates extrapolate the last one wrongly, the budget spread by a line";
  static constexpr unsigned reads = REGISTA_READS_COVARIANCES;
  static constexpr std::array<const char*, 4> reasons{"first_packet", "ball_seen_or_lost", "ball_news_old",
                                                      "pass_target"};

  Settings settings;
  int reserve = 30, whistle_reserve = 15;
  double more_per_half = 10.0, line_ahead = 5.0;
  bool before_kick_off = true, offers = true;
  std::string active_role = "striker";
  static constexpr regista::Range seconds{0.0, 120.0}, metres{0.0, 20.0}, packets{0.0, 10000.0};
  static constexpr std::tuple parameters{
      regista::integer("reserve", &ExtrapolatedChange::reserve, packets, "1",
                       "Packets of a match that are left at its end; B-Human: 30"),
      regista::integer("whistle_reserve", &ExtrapolatedChange::whistle_reserve, packets, "1",
                       "A whistle is sent while more packets of a match than this are left; B-Human: 15"),
      regista::real("more_per_half", &ExtrapolatedChange::more_per_half, seconds, "s",
                    "By which a half counts as longer for the line; B-Human: 10"),
      regista::real("line_ahead", &ExtrapolatedChange::line_ahead, seconds, "s",
                    "The line is taken so much later than now; B-Human: 5"),
      regista::boolean("before_kick_off", &ExtrapolatedChange::before_kick_off,
                       "Send in Ready and Set too, or robots do not know of each other at kick-off; assumption"),
      regista::boolean(
          "offers", &ExtrapolatedChange::offers,
          "Send when a plugin offers something of urgency 1, in the place of B-Human's proposals; assumption"),
      regista::text("active_role", &ExtrapolatedChange::active_role,
                    "Name of the role that plays the ball; a robot that takes it sends sooner; assumption"),
      regista::within(
          &ExtrapolatedChange::settings,
          regista::within(
              &Settings::sense,
              regista::real("distance", &Sense::distance, metres, "m",
                            "Pose or ball must be farther from what teammates believe; B-Human: 0.3")
                  .tunable(),
              regista::real("angle", &Sense::angle, {0.0, 3.15}, "rad",
                            "And stand in another direction for some teammate, or look larger or smaller, "
                            "by more than this; B-Human: 5 degrees")
                  .tunable(),
              regista::real("size", &Sense::size, {0.01, 10.0}, "m", "Of what looks larger or smaller; B-Human: 0.45")),
          regista::real("own_interval", &Settings::own_interval, seconds, "s",
                        "Least time between two packets of this robot; B-Human: 1"),
          regista::real("lasts_near", &Settings::lasts_near, seconds, "s",
                        "A cause must last so long with the ball within `near`; B-Human: 0.3")
              .tunable(),
          regista::real("lasts_far", &Settings::lasts_far, seconds, "s",
                        "A cause must last so long with the ball beyond `far` or unknown; B-Human: 1.2")
              .tunable(),
          regista::real("near", &Settings::near, metres, "m", "From the ball, see lasts_near; B-Human: 1"),
          regista::real("far", &Settings::far, metres, "m", "From the ball, see lasts_far; B-Human: 3"),
          regista::real("active_lasts", &Settings::active_lasts, seconds, "s",
                        "The same for the role that plays the ball, newly taken; B-Human: 0.1"),
          regista::real("poor_pose", &Settings::poor_pose, metres, "m",
                        "A robot whose own place has a larger standard deviation is silent; assumption"),
          regista::real("vanished_after", &Settings::vanished_after, seconds, "s",
                        "A ball unseen for longer has vanished; B-Human: 3"),
          regista::real("seen_within", &Settings::seen_within, seconds, "s",
                        "A ball at most so old is in sight; B-Human: 0.5"),
          regista::real("team_ball_off_for", &Settings::team_ball_off_for, seconds, "s",
                        "The own ball must be off the team's for so long; B-Human: 0.3"),
          regista::real("retell_after", &Settings::retell_after, seconds, "s",
                        "A ball in sight is sent again when the team's news of it are older; B-Human: 9")
              .tunable(),
          regista::real("retell_spread", &Settings::retell_spread, seconds, "s",
                        "And so much older for each shirt number; B-Human: 0.5"),
          regista::real("whistle_within", &Settings::whistle_within, seconds, "s",
                        "A whistle is sent at most so long after it was heard; B-Human: 4"))};

  int own_number = 1, robots = 1;
  double period = 0.1, deceleration = 0.32;
  Allowance whole;  // of a match
  std::vector<bool> is_active_role;
  regista::Told told;
  extrapolated_change::Sender sender;
  double ball_seen_at = never, spent_at = never, silent_before = 0.0, line_before = 0.0, line_at_packet = 0.0;
  std::optional<int> left_before;
  std::vector<Point> mates;
  std::vector<regista::PendingOffer> pending;
  std::vector<std::size_t> chosen;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    told = regista::Told(host);
    own_number = environment->own_number;
    robots = static_cast<int>(environment->team_size);
    period = environment->decision_period;
    deceleration = environment->ball_deceleration;
    whole.budget = environment->packet_budget;
    whole.halves = std::max(1u, environment->halves);
    whole.half_length = environment->half_length;
    whole.more_per_half = more_per_half;
    whole.ahead = line_ahead;
    for (const regista::Role& role : environment.roles()) is_active_role.push_back(active_role == role.name);
    mates.reserve(environment->team_size);
    pending.reserve(64);
    chosen.reserve(64);
  }
  void reset(std::uint64_t) {
    sender = {};
    ball_seen_at = spent_at = never;
    silent_before = line_before = line_at_packet = 0.0;
    left_before.reset();
  }

  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery& query, regista::Grants out) {
    extrapolated_change::Situation now;
    describe_robot(frame, now);
    describe_balls(frame, now);
    describe_budget(frame, query.budget, now);
    for (const regista::Event& event : query.events) {
      if (event.kind == REGISTA_EVENT_WHISTLE) now.heard_whistle = true;
    }
    now.pass_target = told.receiver();
    pending.clear();
    for (const regista::Offer& offer : query.offers) {
      pending.push_back({offer.bytes, offer.urgency});
      if (offers && offer.urgency >= 1.0 && offer.bytes <= query.budget.bytes_free) now.urgent_offer = true;
    }
    settings.whistle_reserve = regista::in_this_game(whistle_reserve, query.budget);
    const std::optional<Cause> cause = sender.decide(settings, now);
    if (!cause) return std::nullopt;
    regista::choose_offers(pending, query.budget.bytes_free, chosen);
    for (const std::size_t index : chosen) out.grant(query.offers[index]);
    return reason_of(*cause, now.upright);
  }

 private:
  static int reason_of(Cause cause, bool upright) {
    switch (cause) {
      case Cause::whistle:
        return REGISTA_EVENT_WHISTLE;
      case Cause::first:
        return regista::own_reason(0);
      case Cause::offer:
        return REGISTA_EVENT_OFFER;
      case Cause::pass_target:
        return regista::own_reason(3);
      case Cause::upright:
        return upright ? REGISTA_EVENT_GOT_UP : REGISTA_EVENT_FELL;
      case Cause::role:
        return REGISTA_EVENT_ROLE_CHANGED;
      case Cause::ball_seen:
        return regista::own_reason(1);
      case Cause::pose:
        return REGISTA_EVENT_POSE_MOVED;
      case Cause::ball:
        return REGISTA_EVENT_BALL_MOVED;
      case Cause::ball_is_old:
        break;
    }
    return regista::own_reason(2);
  }

  void describe_robot(const regista::Frame& frame, extrapolated_change::Situation& now) {
    const regista::World mine = frame.mine(), common = frame.common();
    const regista::Robot &self = mine.robot(own_number), &in_common = common.robot(own_number);
    now.time = frame.time();
    now.number = own_number;
    const int phase = mine.game().phase;
    const bool stands_by = phase == REGISTA_PHASE_READY || phase == REGISTA_PHASE_SET;
    now.playing = before_kick_off || !stands_by;
    now.pose_deviation = std::sqrt(0.5 * (self.covariance[0] + self.covariance[2]));
    now.place = {self.pose[0], self.pose[1]};
    now.speed = std::sqrt(self.velocity[0] * self.velocity[0] + self.velocity[1] * self.velocity[1]);
    now.upright = (self.flags & REGISTA_ROBOT_FALLEN) == 0;
    now.role = self.role;
    now.role_is_active = self.role >= 0 && static_cast<std::size_t>(self.role) < is_active_role.size() &&
                         is_active_role[static_cast<std::size_t>(self.role)];
    if ((in_common.flags & REGISTA_ROBOT_KNOWN) != 0) {
      now.told_role = in_common.role;
      now.told_target = {in_common.target[0], in_common.target[1]};
    }
    mates.clear();
    for (const std::int32_t number : mine.active()) {
      const regista::Robot& mate = mine.robot(number);
      if (number != own_number) mates.push_back({mate.pose[0], mate.pose[1]});
    }
    now.mates = mates;
  }

  Point rests(const regista::Ball& ball) const {
    const double speed = std::sqrt(ball.velocity[0] * ball.velocity[0] + ball.velocity[1] * ball.velocity[1]);
    const double time = deceleration > 0.0 ? speed / (2.0 * deceleration) : 0.0;
    return {ball.position[0] + time * ball.velocity[0], ball.position[1] + time * ball.velocity[1]};
  }

  void describe_balls(const regista::Frame& frame, extrapolated_change::Situation& now) {
    const regista::World mine = frame.mine(), common = frame.common();
    if (mine.ball_known()) {
      const bool sees = told.sees_ball().value_or(mine.ball().age < 0.5 * period);
      if (sees) ball_seen_at = frame.time();
      now.knows_ball = ball_seen_at != never;
      now.ball_age = frame.time() - ball_seen_at;
      now.ball = {mine.ball().position[0], mine.ball().position[1]};
      now.ball_rests = rests(mine.ball());
    }
    if (common.ball_known()) {
      now.team_knows_ball = true;
      now.team_ball_age = common.ball().age;
      now.team_ball_rests = rests(common.ball());
    }
  }

  void describe_budget(const regista::Frame& frame, const regista::Budget& budget,
                       extrapolated_change::Situation& now) {
    const regista::Game& game = frame.mine().game();
    now.since_own = budget.since_own;
    now.allowance = whole;
    now.allowance.reserve = regista::in_this_game(reserve, budget);
    extrapolated_change::Purse& purse = now.purse;
    purse.left = budget.packets_left;
    purse.robots = robots;
    const bool is_whole = budget.size < offsetof(regista::Budget, share) + sizeof budget.share || budget.share >= 1.0;
    if (is_whole) {
      const Clock clock{game.half, std::max(0.0, game.time_left)};
      purse.line = now.allowance.line(extrapolated_change::share_left(now.allowance, clock));
      purse.reserve = extrapolated_change::half_reserve(now.allowance, game.half);
      purse.half_left = clock.half_left;
    } else {
      // A game with a share of the packets has no halves of its own: the host's line, and one reserve.
      const double share = whole.budget > 0.0 ? std::clamp(budget.line / whole.budget, 0.0, 1.0) : 0.0;
      purse.line = now.allowance.line(share);
      purse.reserve = now.allowance.reserve;
      purse.half_left = budget.match_time_left;
      now.allowance.half_length *= budget.share;
      now.allowance.more_per_half *= budget.share;
    }
    // The controller tells of a packet before it is heard.
    if (left_before && budget.packets_left < *left_before) spent_at = frame.time();
    left_before = budget.packets_left;
    purse.silent = std::min(budget.since_team, frame.time() - spent_at);
    if (purse.silent <= silent_before) line_at_packet = line_before;
    silent_before = purse.silent;
    line_before = purse.line;
    purse.line_before = line_at_packet;
    purse.turn = period * ((own_number + budget.packets_left % robots + robots) % robots);
  }
};

}  // namespace

REGISTA_PLUGIN(ExtrapolatedChange, regista::sender)
