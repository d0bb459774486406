// SPDX-License-Identifier: MIT
// When to spend a packet: on news at once, else after a while. Knows nothing of Regista, so that it can be tested and
// used alone.
#pragma once

struct Thrift {
  double period = 10.0;     // s between two packets without news
  double after_news = 1.0;  // s that lie between any two packets
};

// since_own: s since this robot sent its last packet. packets_left: of the team, without what it keeps for the end.
inline bool due(const Thrift& thrift, double since_own, bool news, int packets_left) {
  return packets_left > 0 && since_own >= (news ? thrift.after_news : thrift.period);
}
