// SPDX-License-Identifier: MIT
#include "recording/segment_record.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "match/names.hpp"

namespace regista::recording {
namespace {

using Kind = mind::SegmentEvent::Kind;

std::int64_t milliseconds(double seconds) { return std::llround(seconds * 1e3); }

std::string hexadecimal(const std::vector<std::uint8_t>& bytes) {
  constexpr char digits[] = "0123456789abcdef";
  std::string out;
  for (const std::uint8_t byte : bytes) {
    out += digits[byte >> 4];
    out += digits[byte & 15u];
  }
  return out;
}

}  // namespace

std::uint64_t SentSegments::follow(match::Side side, int robot, const mind::SegmentEvent& event) {
  if (event.kind == Kind::sent) add(side, robot, event);
  return event.kind == Kind::heard || event.kind == Kind::undelivered ? handle(side, event) : event.handle;
}

void SentSegments::add(match::Side side, int robot, const mind::SegmentEvent& sent) {
  std::vector<std::vector<Sent>>& robots = sent_[match::index(side)];
  if (robots.size() < static_cast<std::size_t>(robot)) robots.resize(static_cast<std::size_t>(robot));
  robots[static_cast<std::size_t>(robot - 1)].push_back({milliseconds(sent.time), sent.at, sent.handle});
}

std::uint64_t SentSegments::handle(match::Side side, const mind::SegmentEvent& heard) const {
  const std::vector<std::vector<Sent>>& robots = sent_[match::index(side)];
  if (heard.sender < 1 || robots.size() < static_cast<std::size_t>(heard.sender)) return 0;
  const std::vector<Sent>& own = robots[static_cast<std::size_t>(heard.sender - 1)];
  const auto key = [](const Sent& each) { return std::pair(each.milliseconds, each.at); };
  const std::pair wanted(milliseconds(heard.time_sent), heard.at);
  const auto found = std::ranges::lower_bound(own, wanted, {}, key);
  return found != own.end() && key(*found) == wanted ? found->handle : 0;
}

void write(texts::JsonText& json, const SegmentRecord& record) {
  const mind::SegmentEvent& event = record.event;
  json.key("side").word(match::name(record.side)).key("robot").integer(record.robot);
  json.key("segment").word(word(event.kind));
  if (event.why != mind::SegmentEvent::Why::none) json.key("why").word(word(event.why));
  if (event.place >= 0) json.key("place").integer(event.place).key("plugin").word(event.plugin);
  if (record.handle != 0) json.key("handle").integer(static_cast<std::int64_t>(record.handle));
  const bool offer = event.kind == Kind::offered || event.kind == Kind::refused;
  const bool of_teammate = event.kind == Kind::heard || event.kind == Kind::undelivered;
  if (offer) {
    json.key("length").integer(static_cast<std::int64_t>(event.length)).key("bytes").word(hexadecimal(event.bytes));
    if (!event.text.empty()) json.key("text").string(event.text);
    json.key("urgency").number(event.urgency).key("expires").number(event.expiry);
  }
  if (event.replaced_by != 0) json.key("by").integer(static_cast<std::int64_t>(event.replaced_by));
  if (event.kind == Kind::sent) json.key("at").integer(event.at).key("left").boolean(record.left);
  if (of_teammate) {
    json.key("sender").integer(event.sender).key("sent").number(event.time_sent);
    json.key("heard").number(event.time_heard);
    if (event.place >= 0) json.key("at").integer(event.at);
    // Whose offer it was tells what it said; of an unknown one, these bytes are all there is.
    if (record.handle == 0 && event.place >= 0) json.key("bytes").word(hexadecimal(event.bytes));
  }
}

}  // namespace regista::recording
