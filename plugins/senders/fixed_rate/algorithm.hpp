// SPDX-License-Identifier: MIT
// Packets at a fixed rate: the arm "without events" of Affinita et al. 2023, with the periods of the SPQR team's
// fixed-rate configuration: every 8 s, the striker every 4 s. Seven robots then send one packet a second: 1200 in two
// halves of 600 s. What is sent while the clock stands (in Ready and Set) is missing at the end, and a team that falls
// silent minutes before the end plays as seven strangers: stretch() makes periods longer instead, from the beginning.
//
// Every robot has a phase of its own, so that robots do not send at once, and the times at which it is due do not drift
// with the moments at which it decides.
#pragma once

#include <cassert>

namespace fixed_rate {

struct Settings {
  double period = 8.0;       // s, > 0
  double fast_period = 4.0;  // s, > 0, of the robot with the fast role
  int reserve = 0;           // packets that are left unspent, >= 0
  // Who takes the fast role is due by the fast period at once, that is, it tells of its new role soon; false: its next
  // packet is due as it was when the last one was sent.
  bool at_once = true;
};

// By how much periods have to be longer, >= 1, so that what is left lasts to the end. packets_left: without the
// reserve; line: those that would be left if all had been spent evenly. A packet for each robot may be missing: they
// are not sent evenly to the second.
inline double stretch(int packets_left, double line, int team_size) {
  const double wanted = line - team_size;
  return packets_left > 0 && wanted > packets_left ? wanted / packets_left : 1.0;
}

class Schedule {
 public:
  Schedule() = default;
  // Robot `number` of `team_size`, counted from 1.
  Schedule(int number, int team_size) : phase_((number - 0.5) / team_size) {
    assert(1 <= number && number <= team_size);
  }

  // Whether to send now. time: s since the start of the match, never runs back. since_own: s since this robot last
  // sent, since the start of the match if never. packets_left: of the whole team, which is silent from the moment at
  // which only the reserve is left. Call once per decision; in between another schedule may have been in force (another
  // context of the team), whose packets count like its own.
  bool decide(const Settings& settings, double time, double since_own, bool fast, int packets_left) {
    const bool by_fast_period = settings.at_once ? fast : was_fast_;
    const double period = by_fast_period ? settings.fast_period : settings.period;
    const double sent = time - since_own;
    if (!started_) {
      started_ = true;
      // Number k of n is due first after (k - 1/2) n-ths of its period.
      last_due_ = sent <= rounding ? time + (phase_ - 1.0) * period : sent;
      last_sent_ = sent;
    } else if (sent > last_sent_ + same_packet) {
      last_due_ = last_sent_ = sent;
    }
    if (time < last_due_ + period - rounding) return false;
    if (packets_left <= settings.reserve) return false;
    was_fast_ = fast;
    last_due_ += period;
    if (last_due_ + period < time) last_due_ = time;  // was out of play, or silent: does not make up for it
    last_sent_ = time;
    return true;
  }

 private:
  static constexpr double rounding = 1e-9;     // s
  static constexpr double same_packet = 0.05;  // s; no two packets of a robot are nearer than that
  double phase_ = 1.0, last_due_ = 0.0, last_sent_ = 0.0;
  bool started_ = false, was_fast_ = false;  // had the fast role at its last packet
};

}  // namespace fixed_rate
