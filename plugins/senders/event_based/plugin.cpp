// SPDX-License-Identifier: MIT
// Sender plugin around algorithm.hpp: translates the frame, the events and the budget; takes along what offers fit.
#include <algorithm>
#include <array>
#include <vector>

#include <regista/choose_offers.hpp>
#include <regista/sender.hpp>

#include "algorithm.hpp"
#include "ball_witness.hpp"

namespace {

using event_based::Cause;
using event_based::Rule;
using event_based::Settings;

// What there is to send for, in the order of causes: the event as the host has it, and the rule unless a team sets
// another.
struct Row {
  Cause cause;
  std::int32_t event;
  Rule rule;
};
constexpr std::array<Row, event_based::causes> rows{{
    {Cause::whistle, REGISTA_EVENT_WHISTLE, {.interval = 1.5}},
    {Cause::returned, REGISTA_EVENT_RETURNED, {.interval = 1.0}},
    {Cause::ball_found, REGISTA_EVENT_BALL_FOUND, {.interval = 2.0}},
    {Cause::goalkeeper_saw_ball, REGISTA_EVENT_GOALKEEPER_SAW_BALL, {.interval = 2.0, .threshold = 8.0}},
    {Cause::ball_known_again, REGISTA_EVENT_BALL_KNOWN_AGAIN, {.interval = 2.0, .threshold = 5.0}},
    {Cause::fell, REGISTA_EVENT_FELL, {.heeded = false, .interval = 5.0}},
    {Cause::offer, REGISTA_EVENT_OFFER, {.interval = 1.0}},
    {Cause::role_changed, REGISTA_EVENT_ROLE_CHANGED, {.interval = 1.0}},
    {Cause::got_up, REGISTA_EVENT_GOT_UP, {.heeded = false, .interval = 5.0}},
    {Cause::phase_changed, REGISTA_EVENT_PHASE_CHANGED, {.heeded = false, .interval = 1.0}},
    {Cause::context_changed, REGISTA_EVENT_CONTEXT_CHANGED, {.heeded = false, .interval = 2.0}},
    {Cause::ball_moved, REGISTA_EVENT_BALL_MOVED, {.interval = 2.0, .threshold = 1.0}},
    {Cause::pose_moved, REGISTA_EVENT_POSE_MOVED, {.interval = 4.0, .threshold = 1.0}},
    {Cause::period, REGISTA_EVENT_PERIOD, {}},
}};

constexpr std::size_t index(Cause cause) { return static_cast<std::size_t>(cause); }
static_assert(std::ranges::all_of(rows, [](const Row& row) { return &row == &rows[index(row.cause)]; }));

constexpr int reason_of(Cause cause) { return rows[index(cause)].event; }

constexpr std::optional<Cause> cause_of(std::int32_t event) {
  if (event == REGISTA_EVENT_OFFER || event == REGISTA_EVENT_PERIOD) return std::nullopt;  // reasons, but no events
  for (const Row& row : rows) {
    if (row.event == event) return row.cause;
  }
  return std::nullopt;
}

constexpr Settings initial_settings() {
  Settings settings;
  for (const Row& row : rows) settings.rules[index(row.cause)] = row.rule;
  return settings;
}

// Binds to the rule of one cause.
struct RuleOf {
  Cause cause;
  constexpr auto& operator()(auto& settings) const { return settings.rules[index(cause)]; }
};

constexpr regista::Range seconds{0.0, 120.0}, metres{0.0, 10.0};

constexpr auto heeded(const char* name, const char* doc) { return regista::boolean(name, &Rule::heeded, doc); }
constexpr auto interval(const char* name, const char* doc = "Least time between two such packets; our choice") {
  return regista::real(name, &Rule::interval, seconds, "s", doc);
}
constexpr auto threshold(const char* name, regista::Range range, const char* unit, const char* doc) {
  return regista::real(name, &Rule::threshold, range, unit, doc).tunable();
}

struct EventBased {
  static constexpr auto id = "event_based", version = "1.3.0",
                        summary = "A packet on events, with a slow period beneath or by events alone";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  Settings settings = initial_settings();
  int reserve = 30;
  double alone_after = 10.0;
  static constexpr std::array<const char*, 2> paces{"linear", "none"};
  static constexpr std::tuple parameters{
      regista::integer("reserve", &EventBased::reserve, {0, 10000}, "1",
                       "Packets of the team at which it falls silent; SPQR: 30"),
      regista::within(
          &EventBased::settings,
          regista::real("minimum_interval", &Settings::minimum_interval, {0.0, 60.0}, "s",
                        "Least time between two packets of this robot, whatever the cause; B-Human: 1")
              .tunable(),
          regista::real("pending_for", &Settings::pending_for, {0.0, 60.0}, "s",
                        "How long an event that had to wait still counts; our choice")
              .tunable(),
          regista::choice("pace", &Settings::pace, paces,
                          "linear: roles, moves and periods wait while more than an even share of what lies above the "
                          "reserve is spent, after B-Human; none: they never wait, as in SPQR's released code"),
          regista::real("pace_margin", &Settings::pace_margin, {0.0, 10000.0}, "1",
                        "Packets below the even share at which they begin to wait; our choice")
              .tunable(),
          regista::boolean(
              "periodic", &Settings::periodic,
              "Send for time alone too, by the periods below; SPQR: yes; false: by events alone, which leaves robots "
              "silent for minutes: the team's `teammates_forgotten_after` must then be long (3600: never), and "
              "`phase_changed` lets robots know of each other before the first whistle"),
          regista::real("period", &Settings::period, {0.5, 120.0}, "s", "A packet at least so often; SPQR: 10")
              .tunable(),
          regista::real("period_alone", &Settings::period_alone, {0.5, 120.0}, "s",
                        "The same for the only robot that sees the ball; SPQR: 4")
              .tunable(),
          regista::real("period_goalkeeper", &Settings::period_goalkeeper, {0.5, 120.0}, "s",
                        "The same for robot 1; SPQR: 20")
              .tunable(),
          regista::real("period_ready_least", &Settings::period_ready_least, {0.5, 120.0}, "s",
                        "The same in Ready and Set for robot 1, growing with the number; SPQR: 8 (in Ready)"),
          regista::real("period_ready_most", &Settings::period_ready_most, {0.5, 120.0}, "s",
                        "The same in Ready and Set for the last robot; SPQR: 14 (in Ready)")),
      regista::real("alone_after", &EventBased::alone_after, seconds, "s",
                    "A robot that sees the ball counts as the only one after so long without news from others; ours")
          .tunable(),
      regista::within(
          &EventBased::settings,
          regista::within(RuleOf{Cause::whistle}, heeded("whistle", "Send on hearing the whistle; SPQR: yes"),
                          interval("whistle_interval", "Least time between two such packets; SPQR: 1.5")),
          regista::within(RuleOf{Cause::returned}, heeded("returned", "Send on coming back from a penalty; our choice"),
                          interval("returned_interval")),
          regista::within(RuleOf{Cause::ball_found},
                          heeded("ball_found", "Send when a searcher sees the ball; SPQR: yes"),
                          interval("ball_found_interval").tunable()),
          regista::within(
              RuleOf{Cause::goalkeeper_saw_ball},
              heeded("goalkeeper_saw_ball",
                     "Send when the goalkeeper sees a ball that it had not seen for long; SPQR: yes"),
              threshold("goalkeeper_unseen", seconds, "s", "How long it must not have seen the ball; SPQR: 8"),
              interval("goalkeeper_interval")),
          regista::within(
              RuleOf{Cause::ball_known_again},
              heeded("ball_known_again", "Send on seeing the ball when the team lacked it for long; SPQR: yes"),
              threshold("ball_lacked", seconds, "s", "How long the team must have lacked the ball; SPQR: 5"),
              interval("ball_known_again_interval")),
          regista::within(RuleOf{Cause::offer}, heeded("offers", "Send when a plugin offers something of urgency 1"),
                          interval("offers_interval")),
          regista::within(RuleOf{Cause::role_changed},
                          heeded("role_changed", "Send on taking another role; our choice"),
                          interval("role_changed_interval").tunable()),
          regista::within(
              RuleOf{Cause::ball_moved},
              heeded("ball_moved", "Send when the ball is seen far from where the team believes it; our choice"),
              threshold("ball_moved_distance", metres, "m", "How far; our choice"),
              interval("ball_moved_interval").tunable()),
          regista::within(
              RuleOf{Cause::pose_moved},
              heeded("pose_moved", "Send when this robot is far from where the team believes it, after B-Human"),
              threshold("pose_moved_distance", metres, "m",
                        "How far; B-Human: 0.3, with 5 degrees besides; 1 is our choice"),
              interval("pose_moved_interval").tunable()),
          regista::within(
              RuleOf{Cause::fell},
              heeded("fell", "Send on falling, so that others take over what this robot was to do; our choice: no"),
              interval("fell_interval").tunable()),
          regista::within(RuleOf{Cause::got_up}, heeded("got_up", "Send on standing again; our choice: no"),
                          interval("got_up_interval").tunable()),
          regista::within(
              RuleOf{Cause::phase_changed},
              heeded(
                  "phase_changed",
                  "Send when the phase of the game changes, which teammates learn from the game too; our choice: no"),
              interval("phase_changed_interval").tunable()),
          regista::within(RuleOf{Cause::context_changed},
                          heeded("context_changed", "Send when another context comes into force; our choice: no"),
                          interval("context_changed_interval").tunable()))};

  event_based::Sender sender;
  event_based::BallWitness witness;
  int number = 1, team_size = 1, budget = 0;
  std::vector<event_based::Event> events;
  std::vector<regista::PendingOffer> pending;
  std::vector<std::size_t> chosen;

  void setup(const regista::Environment& environment) {
    number = environment->own_number;
    team_size = static_cast<int>(environment->team_size);
    budget = static_cast<int>(environment->packet_budget);
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
    now.budget = budget;
    now.packets_left = query.budget.packets_left;
    now.reserve = regista::in_this_game(reserve, query.budget);
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
