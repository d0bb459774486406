// SPDX-License-Identifier: MIT
#include "mind/world/segment_journal.hpp"

#include <array>

namespace regista::mind {

const char* word(SegmentEvent::Kind kind) {
  constexpr std::array words{"offered", "refused", "sent", "dropped", "heard", "undelivered"};
  return words[static_cast<std::size_t>(kind)];
}

const char* word(SegmentEvent::Why why) {
  constexpr std::array words{"",         "senseless", "too_long",      "too_many_places", "too_many_pending", "expired",
                             "replaced", "withdrawn", "unknown_place", "no_mailbox",      "wrong_length"};
  return words[static_cast<std::size_t>(why)];
}

void SegmentJournal::begin() {
  if (begun_) events_.clear();
  begun_ = true;
}

SegmentEvent& SegmentJournal::add(SegmentEvent::Kind kind, SegmentEvent::Why why, double time, int place) {
  SegmentEvent& event = events_.emplace_back();
  event.kind = kind;
  event.why = why;
  event.time = time;
  event.place = place;
  return event;
}

}  // namespace regista::mind
