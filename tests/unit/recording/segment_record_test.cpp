// SPDX-License-Identifier: MIT
// What is told of segments, and which offer a teammate heard.
#include "recording/plugin_records.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace regista::recording {
namespace {

using mind::SegmentEvent;
using Kind = SegmentEvent::Kind;
using Why = SegmentEvent::Why;

SegmentEvent event_of(Kind kind, Why why = Why::none, const char* plugin = "", std::uint64_t handle = 0) {
  SegmentEvent event;
  event.kind = kind;
  event.why = why;
  event.place = 3;
  event.plugin = plugin;
  event.handle = handle;
  return event;
}

SegmentEvent sent(double time, int at, std::uint64_t handle) {
  SegmentEvent event = event_of(Kind::sent, Why::none, "", handle);
  event.time = time;
  event.at = at;
  return event;
}

SegmentEvent heard(int sender, double time_sent, int at) {
  SegmentEvent event = event_of(Kind::heard);
  event.at = at;
  event.sender = sender;
  event.time_sent = time_sent;
  return event;
}

TEST(SentSegments, KnowsWhichOfferWasHeard) {
  SentSegments segments;
  EXPECT_EQ(segments.follow(match::Side::home, 2, sent(1.0, 0, 11)), 11u);
  segments.follow(match::Side::home, 2, sent(1.0, 1, 12));
  segments.follow(match::Side::home, 3, sent(1.0, 0, 13));
  segments.follow(match::Side::away, 2, sent(1.0, 0, 14));
  segments.follow(match::Side::home, 2, sent(2.02, 0, 15));
  const auto of = [&](match::Side side, const SegmentEvent& event) { return segments.follow(side, 7, event); };
  EXPECT_EQ(of(match::Side::home, heard(2, 1.0, 0)), 11u);
  EXPECT_EQ(of(match::Side::home, heard(2, 1.0, 1)), 12u);
  EXPECT_EQ(of(match::Side::home, heard(3, 1.0, 0)), 13u);
  EXPECT_EQ(of(match::Side::away, heard(2, 1.0, 0)), 14u);
  EXPECT_EQ(of(match::Side::home, heard(2, 2.0200001, 0)), 15u) << "packets tell milliseconds";
  EXPECT_EQ(of(match::Side::home, heard(2, 1.0, 2)), 0u);
  EXPECT_EQ(of(match::Side::home, heard(2, 1.5, 0)), 0u);
  EXPECT_EQ(of(match::Side::home, heard(5, 1.0, 0)), 0u);
  EXPECT_EQ(of(match::Side::home, heard(0, 1.0, 0)), 0u);
  SegmentEvent undelivered = heard(2, 1.0, 1);
  undelivered.kind = Kind::undelivered;
  EXPECT_EQ(of(match::Side::home, undelivered), 12u);
}

std::string written(const SegmentEvent& event, std::uint64_t handle, bool left = true) {
  texts::JsonText json;
  json.open('{');
  write(json, {match::Side::away, 4, event, handle, left});
  json.close('}');
  return std::string(json.text());
}

TEST(SegmentRecord, SaysOfEachEventWhatThereIs) {
  SegmentEvent offered = event_of(Kind::offered, Why::none, "bids", 9);
  offered.urgency = 0.5;
  offered.expiry = 2.25;
  offered.length = 2;
  offered.bytes = {10, 255};
  offered.text = "a \"bid\"";
  EXPECT_EQ(written(offered, 9),
            R"({"side":"away","robot":4,"segment":"offered","place":3,"plugin":"bids","handle":9,"length":2,)"
            R"("bytes":"0aff","text":"a \"bid\"","urgency":0.5,"expires":2.25})");
  SegmentEvent refused = event_of(Kind::refused, Why::too_long, "bids");
  refused.length = 300;
  refused.expiry = std::numeric_limits<double>::infinity();
  EXPECT_EQ(written(refused, 0),
            R"({"side":"away","robot":4,"segment":"refused","why":"too_long","place":3,"plugin":"bids","length":300,)"
            R"("bytes":"","urgency":0,"expires":null})");
  EXPECT_EQ(written(sent(1.0, 1, 9), 9, false),
            R"({"side":"away","robot":4,"segment":"sent","place":3,"plugin":"","handle":9,"at":1,"left":false})");
  SegmentEvent dropped = event_of(Kind::dropped, Why::replaced, "bids", 9);
  dropped.replaced_by = 10;
  EXPECT_EQ(written(dropped, 9),
            R"({"side":"away","robot":4,"segment":"dropped","why":"replaced","place":3,"plugin":"bids","handle":9,)"
            R"("by":10})");
  SegmentEvent came = heard(2, 1.5, 0);
  came.time_heard = 1.575;
  came.bytes = {1};
  EXPECT_EQ(written(came, 9),
            R"({"side":"away","robot":4,"segment":"heard","place":3,"plugin":"","handle":9,"sender":2,"sent":1.5,)"
            R"("heard":1.575,"at":0})");
  came.kind = Kind::undelivered;
  came.why = Why::unknown_place;
  EXPECT_EQ(written(came, 0),
            R"({"side":"away","robot":4,"segment":"undelivered","why":"unknown_place","place":3,"plugin":"",)"
            R"("sender":2,"sent":1.5,"heard":1.575,"at":0,"bytes":"01"})");
  came.why = Why::wrong_length;
  came.place = -1;
  EXPECT_EQ(written(came, 0),
            R"({"side":"away","robot":4,"segment":"undelivered","why":"wrong_length","sender":2,"sent":1.5,)"
            R"("heard":1.575})");
}

}  // namespace
}  // namespace regista::recording
