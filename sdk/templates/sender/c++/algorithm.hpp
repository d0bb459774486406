// SPDX-License-Identifier: MIT
// When to spend a packet: soon on news, as long as the packets last, else after a while. Knows nothing of Regista, so
// that it can be tested and used alone.
#pragma once

struct Thrift {
  double period = 10.0;     // s between two packets without news
  double after_news = 1.0;  // s that lie between any two packets
};

// since_own: s since this robot sent its last packet. packets_left: of the team. line: those that would be left if they
// were spent evenly; both without the reserve. A team that has less is not hurried by news.
inline bool due(const Thrift& thrift, double since_own, bool news, int packets_left, double line) {
  return packets_left > 0 && since_own >= (news && packets_left >= line ? thrift.after_news : thrift.period);
}
