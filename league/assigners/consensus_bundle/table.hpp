// SPDX-License-Identifier: MIT
// Whom to believe: table 1 of Choi, Brunet and How, "Consensus-Based Decentralized Auctions for Robust Task Allocation"
// (IEEE Transactions on Robotics 25(4), 2009). The sender k of a packet says who wins a task, and I, the receiver, say
// so too; the row of the table tells which of us is right. Nothing but the table is in this file, so that it can be
// compared line by line; the rows carry their numbers.
//
// m is the third robot that the sender names, or else the one that I name. In row 12 each of us names another third
// robot: m is the sender's, n is mine.
#pragma once

namespace consensus_bundle {

enum class Says { sender, me, third, nobody };

// update: what the sender says of the task is what I say from now on. reset: nobody wins it, with a bid of 0.
enum class Action { update, reset, leave };

struct Case {
  Says sender_says, i_say;
  bool same_third;  // both name a third robot, and it is the same
  bool newer_m;     // the sender has news of m that are newer than mine
  bool older_m;     // I have news of m that are newer than the sender's
  bool newer_n;     // the sender has news of n that are newer than mine
  bool higher;      // the sender's bid is higher than mine, or as high and its winner has the lower number
};

constexpr Action believe(const Case& c) {
  using enum Says;
  using enum Action;
  const auto update_if = [](bool condition) { return condition ? update : leave; };
  const auto reset_if = [](bool condition) { return condition ? reset : leave; };
  // clang-format off
  switch (c.sender_says) {
    case sender:
      switch (c.i_say) {
        case me:     return update_if(c.higher);                               // 1
        case sender: return update;                                            // 2
        case third:  return update_if(c.newer_m || c.higher);                  // 3
        case nobody: return update;                                            // 4
      }
      break;
    case me:
      switch (c.i_say) {
        case me:     return leave;                                             // 5
        case sender: return reset;                                             // 6
        case third:  return reset_if(c.newer_m);                               // 7
        case nobody: return leave;                                             // 8
      }
      break;
    case third:
      switch (c.i_say) {
        case me:     return update_if(c.newer_m && c.higher);                  // 9
        case sender: return c.newer_m ? update : reset;                        // 10
        case third:
          if (c.same_third) return update_if(c.newer_m);                       // 11
          if (c.newer_m && (c.newer_n || c.higher)) return update;             // 12
          return reset_if(c.newer_n && c.older_m);                             // 12
        case nobody: return update_if(c.newer_m);                              // 13
      }
      break;
    case nobody:
      switch (c.i_say) {
        case me:     return leave;                                             // 14
        case sender: return update;                                            // 15
        case third:  return update_if(c.newer_m);                              // 16
        case nobody: return leave;                                             // 17
      }
      break;
  }
  // clang-format on
  return leave;
}

}  // namespace consensus_bundle
