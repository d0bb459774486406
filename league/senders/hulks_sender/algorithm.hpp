// SPDX-License-Identifier: MIT
// When the HULKs speak (SPL, released code of 2024): a claim of the striker's role, and the word that it has lost the
// ball, at once; the striker's claim again every 2 s; at least 1 s apart, only in Playing, and never with 20 packets
// left or fewer. In Playing nobody else speaks, so that while one robot is the striker the team spends half a packet a
// second, and one more at each change of striker.
//
// Ours: the least time holds for the lost ball, too. In Ready and Set each robot sends every `ready_period`: here
// robots learn from packets alone who plays, there the game controller tells them. With these packets they also learn
// where the others stand before a kick-off.
#pragma once

#include <optional>

namespace hulks_sender {

// Why a packet is sent.
enum class Cause { news, resend, ready };

struct Settings {
  double resend = 2.0;         // s between two claims of the striker
  double gap = 1.0;            // s between two packets of this robot in Playing
  double ready_period = 20.0;  // s, in Ready and Set; 0: nothing is sent there
};

struct Situation {
  double time = 0.0;              // s
  int number = 1, team_size = 1;  // of this robot
  bool playing = false, ready_or_set = false;
  bool has_packets = true;  // more are left than those at which the team falls silent
  double since_own = 0.0;   // s since this robot sent, since the start of the match if never
  bool has_news = false;    // something is to be said at once
  bool is_striker = false;  // a claim stands
};

class Sender {
 public:
  // Whether to send now, and why. Call once per decision.
  std::optional<Cause> decide(const Settings& settings, const Situation& now) {
    if (!now.ready_or_set) {
      next_ = none;
    } else if (next_ == none) {
      // Each number at another moment, so that robots do not send at once.
      next_ = now.time + settings.ready_period * (now.number - 0.5) / now.team_size;
    }
    if (!now.has_packets) return std::nullopt;
    if (now.playing) {
      if (now.has_news && now.since_own >= settings.gap - rounding) return Cause::news;
      if (now.is_striker && now.since_own >= settings.resend - rounding) return Cause::resend;
      return std::nullopt;
    }
    if (!now.ready_or_set || settings.ready_period <= 0.0 || now.time < next_ - rounding) return std::nullopt;
    next_ += settings.ready_period;
    return Cause::ready;
  }

 private:
  static constexpr double none = -1.0, rounding = 1e-9;  // s
  double next_ = none;
};

}  // namespace hulks_sender
