// SPDX-License-Identifier: MIT
// When to spend a packet: on events, with a slow period beneath unless a team will have none (the events e of Affinita
// et al. 2023, "Conclusions": "sending messages only when specific events occur"). Events, periods and the
// reserve are those of the SPQR team's released code; that every event has its own interval and threshold follows Nao
// Devils, the least time between two packets and the budget spread over the match follow B-Human.
//
// Great events tell what changes the game for all. Small ones, and the period, are held back while the team has spent
// more than its share of the budget. What is shared out is the budget without the reserve, so that a team that keeps to
// its share is not silent before the end.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

namespace event_based {

// Why a packet is sent; in order of importance.
enum class Cause {
  whistle,
  returned,             // back in play after a penalty
  ball_found,           // a searcher sees the ball
  goalkeeper_saw_ball,  // value: s unseen before
  ball_known_again,     // value: s the team lacked it
  fell,                 // lies on the ground
  offer,                // another plugin has something urgent to say
  role_changed,
  got_up,
  phase_changed,
  context_changed,
  ball_moved,  // value: m from where the team believes it
  pose_moved,  // value: m from where the team believes this robot
  period,
};
inline constexpr std::size_t causes = 14;

constexpr bool is_great(Cause cause) { return cause < Cause::role_changed; }

struct Event {
  Cause cause;
  double value = 0.0;
};

// What is done about the events of one cause.
struct Rule {
  bool heeded = true;
  double interval = 1.0;  // s at least between two packets of this robot for this cause
  double threshold = -std::numeric_limits<double>::infinity();  // smaller values are ignored
};

enum class Pace { linear, none };

struct Settings {
  std::array<Rule, causes> rules{};                           // by cause; that of `period` is not used
  double minimum_interval = 1.0;                              // s between two packets of this robot, whatever the cause
  double pending_for = 2.0;                                   // s for which an event that had to wait still counts
  bool periodic = true;                                       // false: nothing is sent for time alone
  double period = 10.0;                                       // s
  double period_alone = 4.0;                                  // s, of the only robot that sees the ball
  double period_goalkeeper = 20.0;                            // s
  double period_ready_least = 8.0, period_ready_most = 14.0;  // s, in Ready and Set; spread over the numbers
  Pace pace = Pace::linear;
  double pace_margin = 20.0;  // packets below the line to the reserve at which the small causes are held back
};

struct Situation {
  double time = 0.0;
  int number = 1, team_size = 1;  // of this robot; number 1 keeps the goal
  bool ready_or_set = false;      // phase Ready or Set
  bool alone_with_ball = false;   // this robot sees the ball, and nobody else tells of it
  int budget = 0;                 // packets of the team in this game
  int packets_left = 0;           // of these
  int reserve = 0;                // packets; the team is silent when no more are left
  double line = 0.0;              // packets that would be left if the budget were spent evenly, down to none
  double since_own = 0.0;         // s since this robot sent, since the start of the match if never
};

inline double period_of(const Settings& settings, const Situation& now) {
  if (now.ready_or_set) {
    const double place = now.team_size > 1 ? (now.number - 1.0) / (now.team_size - 1.0) : 0.0;
    return settings.period_ready_least + place * (settings.period_ready_most - settings.period_ready_least);
  }
  if (now.alone_with_ball) return settings.period_alone;
  return now.number == 1 ? settings.period_goalkeeper : settings.period;
}

// Packets that would be left if all but the reserve were spent evenly.
inline double line_to_reserve(const Situation& now) {
  if (now.budget <= now.reserve) return now.reserve;
  return now.reserve + now.line * (now.budget - now.reserve) / now.budget;
}

class Sender {
 public:
  // Whether to send now, and why. events: those since the last call, in any order. Call once per decision.
  std::optional<Cause> decide(const Settings& settings, const Situation& now, std::span<const Event> events) {
    for (const Event& event : events) {
      const Rule& rule = settings.rules[index(event.cause)];
      if (rule.heeded && event.value >= rule.threshold) happened_[index(event.cause)] = now.time;
    }
    if (now.packets_left <= now.reserve) return std::nullopt;
    if (now.since_own < settings.minimum_interval - rounding) return std::nullopt;
    const bool in_pace = settings.pace == Pace::none || now.packets_left >= line_to_reserve(now) - settings.pace_margin;
    for (std::size_t k = 0; k < index(Cause::period); ++k) {
      const auto cause = static_cast<Cause>(k);
      if (!is_great(cause) && !in_pace) break;
      if (now.time - happened_[k] > settings.pending_for + rounding) continue;
      if (now.time - sent_for_[k] < settings.rules[k].interval - rounding) continue;
      return sent(cause, now.time);
    }
    if (!settings.periodic || !in_pace) return std::nullopt;
    // The first time each number is due at another moment, so that robots do not send at once.
    const double share = has_sent_ ? 1.0 : (now.number - 0.5) / now.team_size;
    if (now.since_own < share * period_of(settings, now) - rounding) return std::nullopt;
    return sent(Cause::period, now.time);
  }

 private:
  static constexpr double rounding = 1e-9;  // s
  static constexpr double never = -std::numeric_limits<double>::infinity();
  static constexpr std::size_t index(Cause cause) { return static_cast<std::size_t>(cause); }

  // A packet carries the whole state: whatever was waiting is told with it.
  Cause sent(Cause cause, double time) {
    happened_.fill(never);
    sent_for_[index(cause)] = time;
    has_sent_ = true;
    return cause;
  }

  static constexpr std::array<double, causes> all_never() {
    std::array<double, causes> out{};
    out.fill(never);
    return out;
  }
  std::array<double, causes> happened_ = all_never(), sent_for_ = all_never();
  bool has_sent_ = false;
};

}  // namespace event_based
