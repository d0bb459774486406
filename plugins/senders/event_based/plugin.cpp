// SPDX-License-Identifier: MIT
// Sender plugin around algorithm.hpp: translates the frame, the events and the budget; takes along what offers fit.
#include <limits>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/sender.hpp>

#include "algorithm.hpp"
#include "ball_witness.hpp"

namespace {

using event_based::Cause;
using event_based::Pace;

constexpr std::optional<Cause> cause_of(std::int32_t kind) {
  switch (kind) {
    case REGISTA_EVENT_WHISTLE:
      return Cause::whistle;
    case REGISTA_EVENT_BALL_FOUND:
      return Cause::ball_found;
    case REGISTA_EVENT_GOALKEEPER_SAW_BALL:
      return Cause::goalkeeper_saw_ball;
    case REGISTA_EVENT_BALL_KNOWN_AGAIN:
      return Cause::ball_known_again;
    case REGISTA_EVENT_ROLE_CHANGED:
      return Cause::role_changed;
    case REGISTA_EVENT_BALL_MOVED:
      return Cause::ball_moved;
    case REGISTA_EVENT_POSE_MOVED:
      return Cause::pose_moved;
    case REGISTA_EVENT_FELL:
      return Cause::fell;
    case REGISTA_EVENT_GOT_UP:
      return Cause::got_up;
    case REGISTA_EVENT_PHASE_CHANGED:
      return Cause::phase_changed;
    case REGISTA_EVENT_CONTEXT_CHANGED:
      return Cause::context_changed;
    case REGISTA_EVENT_RETURNED:
      return Cause::returned;
    default:
      return std::nullopt;
  }
}

constexpr int reason_of(Cause cause) {
  switch (cause) {
    case Cause::whistle:
      return REGISTA_EVENT_WHISTLE;
    case Cause::returned:
      return REGISTA_EVENT_RETURNED;
    case Cause::ball_found:
      return REGISTA_EVENT_BALL_FOUND;
    case Cause::goalkeeper_saw_ball:
      return REGISTA_EVENT_GOALKEEPER_SAW_BALL;
    case Cause::ball_known_again:
      return REGISTA_EVENT_BALL_KNOWN_AGAIN;
    case Cause::fell:
      return REGISTA_EVENT_FELL;
    case Cause::offer:
      return REGISTA_EVENT_OFFER;
    case Cause::role_changed:
      return REGISTA_EVENT_ROLE_CHANGED;
    case Cause::got_up:
      return REGISTA_EVENT_GOT_UP;
    case Cause::phase_changed:
      return REGISTA_EVENT_PHASE_CHANGED;
    case Cause::context_changed:
      return REGISTA_EVENT_CONTEXT_CHANGED;
    case Cause::ball_moved:
      return REGISTA_EVENT_BALL_MOVED;
    case Cause::pose_moved:
      return REGISTA_EVENT_POSE_MOVED;
    case Cause::period:
      break;
  }
  return REGISTA_EVENT_PERIOD;
}

struct EventBased {
  static constexpr auto id = "event_based", version = "1.1.0",
                        summary = "A packet on events, with a slow period beneath";

  int reserve = 30;
  double minimum_interval = 1.0, pending_for = 2.0;
  Pace pace = Pace::linear;
  double pace_margin = 20.0;
  double period = 10.0, period_alone = 4.0, period_goalkeeper = 20.0, period_ready_least = 8.0,
         period_ready_most = 14.0;
  double alone_after = 10.0;
  bool whistle = true, returned = true, ball_found = true, goalkeeper_saw_ball = true, ball_known_again = true;
  bool offers = true, role_changed = true, ball_moved = true, pose_moved = true;
  bool fell = false, got_up = false, phase_changed = false, context_changed = false;
  double whistle_interval = 1.5, returned_interval = 1.0, ball_found_interval = 2.0, goalkeeper_interval = 2.0;
  double ball_known_again_interval = 2.0, offers_interval = 1.0, role_changed_interval = 1.0;
  double ball_moved_interval = 2.0, pose_moved_interval = 4.0;
  double fell_interval = 5.0, got_up_interval = 5.0, phase_changed_interval = 1.0, context_changed_interval = 2.0;
  double goalkeeper_unseen = 8.0, ball_lacked = 5.0, ball_moved_distance = 1.0, pose_moved_distance = 1.0;

  static constexpr double any = -std::numeric_limits<double>::infinity();  // as a threshold
  static constexpr std::array<const char*, 2> paces{"linear", "none"};
  static constexpr regista::Range seconds{0.0, 120.0}, metres{0.0, 10.0};
  static constexpr std::tuple parameters{
      regista::integer("reserve", &EventBased::reserve, {0, 10000}, "1",
                       "Packets of the team at which it falls silent; SPQR: 30"),
      regista::real("minimum_interval", &EventBased::minimum_interval, {0.0, 60.0}, "s",
                    "Least time between two packets of this robot, whatever the cause; B-Human: 1")
          .tunable(),
      regista::real("pending_for", &EventBased::pending_for, {0.0, 60.0}, "s",
                    "How long an event that had to wait still counts; our choice")
          .tunable(),
      regista::choice("pace", &EventBased::pace, paces,
                      "linear: roles, moves and periods wait while more than an even share of the budget is spent, "
                      "after B-Human; none: they never wait, as in SPQR's released code"),
      regista::real("pace_margin", &EventBased::pace_margin, {0.0, 10000.0}, "1",
                    "Packets below the even share at which they begin to wait; our choice")
          .tunable(),
      regista::real("period", &EventBased::period, {0.5, 120.0}, "s", "A packet at least so often; SPQR: 10").tunable(),
      regista::real("period_alone", &EventBased::period_alone, {0.5, 120.0}, "s",
                    "The same for the only robot that sees the ball; SPQR: 4")
          .tunable(),
      regista::real("period_goalkeeper", &EventBased::period_goalkeeper, {0.5, 120.0}, "s",
                    "The same for robot 1; SPQR: 20")
          .tunable(),
      regista::real("period_ready_least", &EventBased::period_ready_least, {0.5, 120.0}, "s",
                    "The same in Ready and Set for robot 1, growing with the number; SPQR: 8 (in Ready)"),
      regista::real("period_ready_most", &EventBased::period_ready_most, {0.5, 120.0}, "s",
                    "The same in Ready and Set for the last robot; SPQR: 14 (in Ready)"),
      regista::real("alone_after", &EventBased::alone_after, seconds, "s",
                    "A robot that sees the ball counts as the only one after so long without news from others; ours")
          .tunable(),
      regista::boolean("whistle", &EventBased::whistle, "Send on hearing the whistle; SPQR: yes"),
      regista::real("whistle_interval", &EventBased::whistle_interval, seconds, "s",
                    "Least time between two such packets; SPQR: 1.5"),
      regista::boolean("returned", &EventBased::returned, "Send on coming back from a penalty; our choice"),
      regista::real("returned_interval", &EventBased::returned_interval, seconds, "s",
                    "Least time between two such packets; our choice"),
      regista::boolean("ball_found", &EventBased::ball_found, "Send when a searcher sees the ball; SPQR: yes"),
      regista::real("ball_found_interval", &EventBased::ball_found_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("goalkeeper_saw_ball", &EventBased::goalkeeper_saw_ball,
                       "Send when the goalkeeper sees a ball that it had not seen for long; SPQR: yes"),
      regista::real("goalkeeper_unseen", &EventBased::goalkeeper_unseen, seconds, "s",
                    "How long it must not have seen the ball; SPQR: 8")
          .tunable(),
      regista::real("goalkeeper_interval", &EventBased::goalkeeper_interval, seconds, "s",
                    "Least time between two such packets; our choice"),
      regista::boolean("ball_known_again", &EventBased::ball_known_again,
                       "Send on seeing the ball when the team lacked it for long; SPQR: yes"),
      regista::real("ball_lacked", &EventBased::ball_lacked, seconds, "s",
                    "How long the team must have lacked the ball; SPQR: 5")
          .tunable(),
      regista::real("ball_known_again_interval", &EventBased::ball_known_again_interval, seconds, "s",
                    "Least time between two such packets; our choice"),
      regista::boolean("offers", &EventBased::offers, "Send when a plugin offers something of urgency 1"),
      regista::real("offers_interval", &EventBased::offers_interval, seconds, "s",
                    "Least time between two such packets; our choice"),
      regista::boolean("role_changed", &EventBased::role_changed, "Send on taking another role; our choice"),
      regista::real("role_changed_interval", &EventBased::role_changed_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("ball_moved", &EventBased::ball_moved,
                       "Send when the ball is seen far from where the team believes it; our choice"),
      regista::real("ball_moved_distance", &EventBased::ball_moved_distance, metres, "m", "How far; our choice")
          .tunable(),
      regista::real("ball_moved_interval", &EventBased::ball_moved_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("pose_moved", &EventBased::pose_moved,
                       "Send when this robot is far from where the team believes it, after B-Human"),
      regista::real("pose_moved_distance", &EventBased::pose_moved_distance, metres, "m",
                    "How far; B-Human: 0.3, with 5 degrees besides; 1 is our choice")
          .tunable(),
      regista::real("pose_moved_interval", &EventBased::pose_moved_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("fell", &EventBased::fell,
                       "Send on falling, so that others take over what this robot was to do; our choice: no"),
      regista::real("fell_interval", &EventBased::fell_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("got_up", &EventBased::got_up, "Send on standing again; our choice: no"),
      regista::real("got_up_interval", &EventBased::got_up_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("phase_changed", &EventBased::phase_changed,
                       "Send when the phase of the game changes, which the others are told too; our choice: no"),
      regista::real("phase_changed_interval", &EventBased::phase_changed_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable(),
      regista::boolean("context_changed", &EventBased::context_changed,
                       "Send when another context comes into force; our choice: no"),
      regista::real("context_changed_interval", &EventBased::context_changed_interval, seconds, "s",
                    "Least time between two such packets; our choice")
          .tunable()};

  event_based::Settings settings;
  event_based::Sender sender;
  event_based::BallWitness witness;
  int number = 1, team_size = 1;
  std::vector<event_based::Event> events;
  std::vector<regista::PendingOffer> pending;
  std::vector<std::size_t> chosen;

  void setup(const regista::Environment& environment) {
    number = environment->own_number;
    team_size = static_cast<int>(environment->team_size);
    settings.minimum_interval = minimum_interval;
    settings.pending_for = pending_for;
    settings.period = period;
    settings.period_alone = period_alone;
    settings.period_goalkeeper = period_goalkeeper;
    settings.period_ready_least = period_ready_least;
    settings.period_ready_most = period_ready_most;
    settings.reserve = reserve;
    settings.pace = pace;
    settings.pace_margin = pace_margin;
    const auto rule = [this](Cause cause, bool heeded, double interval, double threshold = any) {
      settings.rules[static_cast<std::size_t>(cause)] = {heeded, interval, threshold};
    };
    rule(Cause::whistle, whistle, whistle_interval);
    rule(Cause::returned, returned, returned_interval);
    rule(Cause::ball_found, ball_found, ball_found_interval);
    rule(Cause::goalkeeper_saw_ball, goalkeeper_saw_ball, goalkeeper_interval, goalkeeper_unseen);
    rule(Cause::ball_known_again, ball_known_again, ball_known_again_interval, ball_lacked);
    rule(Cause::offer, offers, offers_interval);
    rule(Cause::role_changed, role_changed, role_changed_interval);
    rule(Cause::ball_moved, ball_moved, ball_moved_interval, ball_moved_distance);
    rule(Cause::pose_moved, pose_moved, pose_moved_interval, pose_moved_distance);
    rule(Cause::fell, fell, fell_interval);
    rule(Cause::got_up, got_up, got_up_interval);
    rule(Cause::phase_changed, phase_changed, phase_changed_interval);
    rule(Cause::context_changed, context_changed, context_changed_interval);
    events.reserve(32);
    pending.reserve(16);
    chosen.reserve(16);
  }
  void reset(std::uint64_t) {
    sender = {};
    witness = {};
  }

  std::optional<int> decide(const regista::Frame& frame, const regista::SendQuery& query, regista::Grants out) {
    events.clear();
    for (const regista::Event& event : query.events) {
      if (const std::optional<Cause> cause = cause_of(event.kind)) events.push_back({*cause, event.value});
    }
    pending.clear();
    for (const regista::Offer& offer : query.offers) {
      pending.push_back({offer.bytes, offer.urgency});
      if (offer.urgency >= 1.0 && offer.bytes <= query.budget.bytes_free) events.push_back({Cause::offer});
    }
    const regista::World mine = frame.mine(), common = frame.common();
    event_based::Situation now;
    now.time = frame.time();
    now.number = number;
    now.team_size = team_size;
    const int phase = mine.game().phase;
    now.ready_or_set = phase == REGISTA_PHASE_READY || phase == REGISTA_PHASE_SET;
    now.alone_with_ball = witness.is_alone(now.time, {mine.ball_known(), mine.ball().age},
                                           {common.ball_known(), common.ball().age}, alone_after);
    now.packets_left = query.budget.packets_left;
    settings.reserve = regista::in_this_game(reserve, query.budget);
    now.line = query.budget.line;
    now.since_own = query.budget.since_own;
    const std::optional<Cause> cause = sender.decide(settings, now, events);
    if (!cause) return std::nullopt;
    witness.sent();
    regista::choose_offers(pending, query.budget.bytes_free, chosen);
    for (const std::size_t index : chosen) out.grant(query.offers[index]);
    return reason_of(*cause);
  }
};

}  // namespace

REGISTA_PLUGIN(EventBased, regista::sender)
