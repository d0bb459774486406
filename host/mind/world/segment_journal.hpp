// SPDX-License-Identifier: MIT
// What became of the segments of one robot's plugins at one decision, for recorders: what was offered, what left in a
// packet or was dropped, what came from teammates. A mind keeps one only where somebody records; it decides nothing by
// it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace regista::mind {

struct SegmentEvent {
  enum class Kind { offered, refused, sent, dropped, heard, undelivered };
  enum class Why {
    none,  // of what is offered, sent or heard
    // Refused
    senseless,         // urgency outside of [0, 1], an unknown medium, no bytes though there should be some
    too_long,          // for any packet
    too_many_places,   // more plugin instances than a packet can name
    too_many_pending,  // offers of this instance
    // Refused or dropped
    expired,
    // Dropped
    replaced,
    withdrawn,
    // Not delivered
    unknown_place,  // no plugin of this mind stands there
    no_mailbox,     // the one that does takes no messages
    wrong_length    // it claims to go on behind the end of its packet
  };

  Kind kind = Kind::offered;
  Why why = Why::none;
  double time = 0.0;         // s since the start of the match: of the decision
  int place = -1;            // of the plugin, in the order of the team's page; -1: not known (wrong length)
  const char* plugin = "";   // id of the plugin in that place; lives as long as the team's plan
  std::uint64_t handle = 0;  // of the own offer; 0: refused, or of a teammate
  std::uint64_t replaced_by = 0;

  // Of an offer, taken or refused
  double urgency = 0.0, expiry = 0.0;
  std::uint64_t length = 0;  // bytes that were offered
  std::string text;          // what its plugin says that they say; empty: it says nothing
  // Of an offer, and of what a teammate sent: all of them, or where too many are refused none
  std::vector<std::uint8_t> bytes;

  int at = 0;  // which segment of its packet, from 0: of what is sent, heard or not delivered

  // Of what a teammate sent
  int sender = 0;  // shirt number
  double time_sent = 0.0, time_heard = 0.0;
};

const char* word(SegmentEvent::Kind kind);  // "offered", ...
const char* word(SegmentEvent::Why why);    // "too_long", ...; "" for none

class SegmentJournal {
 public:
  // Of the decision that begins. What plugins did while they were created stands with the first one.
  void begin();
  // A plugin may offer without end; a decision that keeps so many is told without the rest.
  bool full() const { return events_.size() >= 1024; }
  SegmentEvent& add(SegmentEvent::Kind kind, SegmentEvent::Why why, double time, int place);
  std::span<SegmentEvent> events() { return events_; }
  std::span<const SegmentEvent> events() const { return events_; }

 private:
  std::vector<SegmentEvent> events_;
  bool begun_ = false;
};

}  // namespace regista::mind
