// SPDX-License-Identifier: MIT
#include "recording/recorded_drawings.hpp"

#include <charconv>
#include <system_error>
#include <utility>

#include "recording/recorded_json.hpp"

namespace regista::recording {
namespace {

// Whose message it is. Its writers put these keys first, so the shapes, which are nearly all of it, are not looked at.
class Heading : public nlohmann::json_sax<nlohmann::json> {
 public:
  // with_layer: "plugin" and "layer" are wanted too.
  Heading(std::string_view message, bool with_layer) : wanted_(with_layer ? 4 : 2) {
    nlohmann::json::sax_parse(message.data(), message.data() + message.size(), this);
    require(found() == wanted_ && number_ && (side_ == "home" || side_ == "away"));
  }
  bool is_of(const RobotName& robot) const {
    return *number_ == robot.number && side_ == (robot.side == 0 ? "home" : "away");
  }
  const std::string& plugin() const { return *plugin_; }
  const std::string& layer() const { return *layer_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }  // below zero: no robot's number
  bool number_unsigned(number_unsigned_t value) override {
    if (depth_ == 1 && key_ == "robot") {
      require(std::in_range<int>(value));
      number_ = static_cast<int>(value);
    }
    return found() < wanted_;
  }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t& value) override {
    if (depth_ != 1) return true;
    if (key_ == "side") side_ = value;
    if (wanted_ == 4 && key_ == "plugin") plugin_ = value;
    if (wanted_ == 4 && key_ == "layer") layer_ = value;
    return found() < wanted_;
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    ++depth_;
    return true;
  }
  bool key(string_t& name) override {
    if (depth_ == 1) key_ = name;
    return true;
  }
  bool end_object() override {
    --depth_;
    return true;
  }
  bool start_array(std::size_t) override { return start_object(0); }
  bool end_array() override { return end_object(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  int found() const { return (side_ ? 1 : 0) + (number_ ? 1 : 0) + (plugin_ ? 1 : 0) + (layer_ ? 1 : 0); }

  int wanted_, depth_ = 0;
  std::string key_;
  std::optional<std::string> side_, plugin_, layer_;
  std::optional<int> number_;
};

RecordedColour colour(const std::string& text) {
  require(text.size() == 9 && text[0] == '#');
  std::uint32_t value = 0;
  const auto [rest, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  require(error == std::errc() && rest == text.data() + text.size());
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(value >> shift & 255u); };
  return {byte(24), byte(16), byte(8), byte(0)};
}

RecordedShape::Kind kind(const std::string& word) {
  using Kind = RecordedShape::Kind;
  if (word == "points") return Kind::points;
  if (word == "line") return Kind::line;
  if (word == "polygon") return Kind::polygon;
  require(word == "text");
  return Kind::text;
}

RecordedShape shape(const nlohmann::json& json) {
  RecordedShape out;
  out.kind = kind(json.at("shape").get<std::string>());
  const nlohmann::json& at = json.at("at");
  require(at.is_array());
  for (const nlohmann::json& point : at) {
    require(point.size() == 2);
    out.at.push_back({point.at(0), point.at(1)});
  }
  if (json.contains("colour")) out.colour = colour(json.at("colour").get<std::string>());
  if (json.contains("width")) {
    out.width = json.at("width").get<double>();
    require(*out.width >= 0.0);
  }
  if (json.contains("filled")) json.at("filled").get_to(out.filled);
  if (out.kind == RecordedShape::Kind::text) {
    require(out.at.size() == 1);
    json.at("text").get_to(out.text);
  }
  return out;
}

std::vector<RecordedShape> shapes(const std::string& message) {
  const nlohmann::json parsed = nlohmann::json::parse(message);
  const nlohmann::json& all = parsed.at("shapes");
  require(all.is_array());
  std::vector<RecordedShape> out;
  for (const nlohmann::json& each : all) out.push_back(shape(each));
  return out;
}

}  // namespace

void DrawingsOfRobot::take(std::string_view message) {
  const Heading heading(message, true);
  if (!heading.is_of(robot_)) return;
  const auto [layer, added] = places_.try_emplace({heading.plugin(), heading.layer()}, messages_.size());
  if (added) messages_.emplace_back();
  messages_[layer->second] = message;
}

std::vector<RecordedDrawing> DrawingsOfRobot::drawings() const {
  std::vector<RecordedDrawing> out(messages_.size());
  for (const auto& [layer, place] : places_) out[place] = {layer.first, layer.second, shapes(messages_[place])};
  return out;
}

void LogOfRobot::take(std::string_view message) {
  if (!Heading(message, false).is_of(robot_)) return;
  last_.emplace_back(message);
  if (last_.size() > most_) last_.pop_front();
}

std::vector<RecordedLogLine> LogOfRobot::lines() const {
  std::vector<RecordedLogLine> out;
  for (const std::string& message : last_) {
    const nlohmann::json json = nlohmann::json::parse(message);
    out.push_back({json.at("time"), json.at("plugin"), json.at("level"), json.at("text")});
  }
  return out;
}

}  // namespace regista::recording
