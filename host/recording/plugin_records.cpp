// SPDX-License-Identifier: MIT
#include "recording/plugin_records.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "match/game_state.hpp"

namespace regista::recording {
namespace {

using Kind = mind::SegmentEvent::Kind;

std::int64_t milliseconds(double seconds) { return std::llround(seconds * 1e3); }

std::string hexadecimal(const std::vector<std::uint8_t>& bytes) { return fmt::format("{:02x}", fmt::join(bytes, "")); }

constexpr double period = 0.5;  // s

const char* word(std::int32_t shape) {
  constexpr std::array words{"points", "line", "polygon"};  // index: shape - REGISTA_SHAPE_POINTS
  const bool drawn = shape >= REGISTA_SHAPE_POINTS && shape <= REGISTA_SHAPE_POLYGON;
  return drawn ? words[static_cast<std::size_t>(shape - REGISTA_SHAPE_POINTS)] : "text";
}

void write(texts::JsonText& json, const mind::DrawnShape& shape, double direction) {
  json.open('{').key("shape").word(word(shape.shape)).key("at").open('[');
  for (const regista_point& each : shape.points) {
    json.open('[').number(direction * each.x, 2).number(direction * each.y, 2).close(']');
  }
  json.close(']');
  if (shape.colour != 0) json.key("colour").word(fmt::format("#{:08x}", shape.colour));
  if (shape.width > 0.0) json.key("width").number(shape.width);
  if (shape.filled) json.key("filled").boolean(true);
  if (shape.shape == REGISTA_SHAPE_TEXT) json.key("text").string(shape.text);
  json.close('}');
}

}  // namespace

bool LastDecision::is(const mind::Decision& decision) const {
  return context == decision.context && role == decision.own_role && assignment == decision.role_of &&
         std::ranges::equal(kept, decision.columns, {}, {}, &regista_task::id);
}

void LastDecision::take(const mind::Decision& decision) {
  context = decision.context;
  role = decision.own_role;
  assignment = decision.role_of;
  kept.clear();
  for (const regista_task& task : decision.columns) kept.push_back(task.id);
}

std::uint64_t SentSegments::follow(match::Side side, int robot, const mind::SegmentEvent& event) {
  if (event.kind == Kind::sent) sent_[{side, robot}].push_back({milliseconds(event.time), event.at, event.handle});
  if (event.kind != Kind::heard && event.kind != Kind::undelivered) return event.handle;
  const std::vector<Sent>& of_sender = sent_[{side, event.sender}];
  const auto key = [](const Sent& each) { return std::pair(each.milliseconds, each.at); };
  const std::pair wanted(milliseconds(event.time_sent), event.at);
  const auto found = std::ranges::lower_bound(of_sender, wanted, {}, key);
  return found != of_sender.end() && key(*found) == wanted ? found->handle : 0;
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
    // The record of a known offer has the bytes already, so this record needs them only for an unknown offer.
    if (record.handle == 0 && event.place >= 0) json.key("bytes").word(hexadecimal(event.bytes));
  }
}

std::span<const DrawnLayers::Change> DrawnLayers::follow(match::Side side, int robot, double time,
                                                         std::span<const mind::DrawnShape> shapes, double direction) {
  changes_.clear();
  std::vector<Layer>& own = layers_[{side, robot}];
  layer_of_.clear();
  for (const mind::DrawnShape& shape : shapes) {
    const std::string_view plugin = shape.plugin;
    const auto found =
        std::ranges::find_if(own, [&](const Layer& each) { return each.plugin == plugin && each.name == shape.layer; });
    layer_of_.push_back(static_cast<std::size_t>(found - own.begin()));
    if (found == own.end()) own.push_back({shape.plugin, shape.layer, "[]", -period});
  }
  for (std::size_t i = 0; i < own.size(); ++i) {
    Layer& each = own[i];
    if (time - each.told < period - 1e-9) continue;
    json_.clear();
    json_.open('[');
    for (std::size_t k = 0; k < shapes.size(); ++k) {
      if (layer_of_[k] == i) write(json_, shapes[k], direction);
    }
    json_.close(']');
    if (json_.text() == each.shapes) continue;
    each.shapes = json_.text();
    each.told = time;
    changes_.push_back({each.plugin, each.name, each.shapes});
  }
  return changes_;
}

}  // namespace regista::recording
