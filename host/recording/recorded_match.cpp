// SPDX-License-Identifier: MIT
#include "recording/recorded_match.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <string_view>
#include <system_error>

#include "config/errors.hpp"
#include "mcap/reader.hpp"
#include "mcap/writer.hpp"
#include "recording/recording_metadata.hpp"
#include "texts/json.hpp"

namespace regista::recording {
namespace {

// Thrown for a message with correct types but impossible values.
struct Senseless {};

void require(bool holds) {
  if (!holds) throw Senseless();
}

// Returns a whole number. The JSON library's own conversion is undefined for a number outside of the range of int.
int whole(const nlohmann::json& json) {
  require(json.is_number_integer());
  const bool fits = json.is_number_unsigned() ? std::in_range<int>(json.get<std::uint64_t>())
                                              : std::in_range<int>(json.get<std::int64_t>());
  require(fits);
  return static_cast<int>(json.get<std::int64_t>());
}

// Returns the JSON of the keys that name the robot of a message. Our writers put these keys before the key `rest`, so
// the long remainder is not parsed. If a key is missing before `rest`, the whole message is parsed.
nlohmann::json heading_of(std::string_view message, std::string_view rest, std::initializer_list<const char*> keys) {
  const std::string first = std::string(message.substr(0, message.find(rest))) + '}';
  nlohmann::json out = nlohmann::json::parse(first, nullptr, false);
  const bool has_all = out.is_object() && std::ranges::all_of(keys, [&](const char* key) { return out.contains(key); });
  return has_all ? out : nlohmann::json::parse(message);
}

bool is_of(const RobotName& robot, const nlohmann::json& heading) {
  const std::string side = heading.at("side").get<std::string>();
  const int number = whole(heading.at("robot"));
  require(number >= 0 && (side == "home" || side == "away"));
  return number == robot.number && side == (robot.side == 0 ? "home" : "away");
}

RecordedColour colour(const std::string& text) {
  require(text.size() == 9 && text[0] == '#');
  std::uint32_t value = 0;
  const auto [rest, error] = std::from_chars(text.data() + 1, text.data() + text.size(), value, 16);
  require(error == std::errc() && rest == text.data() + text.size());
  const auto byte = [&](unsigned shift) { return static_cast<std::uint8_t>(value >> shift & 255u); };
  return {byte(24), byte(16), byte(8), byte(0)};
}

RecordedShape::Kind kind(const std::string& word) {
  constexpr std::array words{"points", "line", "polygon", "text"};  // in the order of the enumeration
  const auto found = std::ranges::find(words, word);
  require(found != words.end());
  return static_cast<RecordedShape::Kind>(found - words.begin());
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

constexpr std::size_t most_robots = 22;
constexpr std::size_t most_log_lines = 5;
constexpr double log_seconds = 2.0;

bool has_shape(const RecordedMatrix& matrix, std::size_t rows, std::size_t columns) {
  return matrix.size() == rows && std::ranges::all_of(matrix, [&](const auto& row) { return row.size() == columns; });
}

std::vector<int> wholes(const nlohmann::json& json) {
  require(json.is_array());
  std::vector<int> out;
  for (const nlohmann::json& each : json) out.push_back(whole(each));
  return out;
}

std::array<int, 2> two(const nlohmann::json& json) { return {whole(json.at(0)), whole(json.at(1))}; }
std::array<std::vector<int>, 2> both(const nlohmann::json& json) { return {wholes(json.at(0)), wholes(json.at(1))}; }

mind::Pose pose(const nlohmann::json& json) { return {json.at(0), json.at(1), json.at(2)}; }
RecordedCovariance covariance(const nlohmann::json& json) { return {json.at(0), json.at(1), json.at(2)}; }

RecordedTeam team(const nlohmann::json& json) {
  RecordedTeam out;
  out.name = json.contains("title") ? json.at("title") : json.at("team");  // earlier versions knew no title
  json.at("robot_radius").get_to(out.robot_radius);
  for (const nlohmann::json& role : json.at("roles")) out.roles.push_back(role.at("name"));
  for (const nlohmann::json& context : json.at("contexts")) {
    RecordedContext& added = out.contexts.emplace_back();
    context.at("name").get_to(added.name);
    context.at("plugin").get_to(added.plugin);
    context.at("parameters").get_to(added.parameters);
    added.priority = whole(context.at("priority"));
    for (const nlohmann::json& term : context.at("terms")) added.terms.push_back({term.at("name"), term.at("weight")});
  }
  return out;
}

config::FieldSize field(const nlohmann::json& json) {
  config::FieldSize out;
  json.at("length").get_to(out.length);
  json.at("width").get_to(out.width);
  json.at("border_strip").get_to(out.border_strip);
  json.at("goal_width").get_to(out.goal_width);
  json.at("goal_depth").get_to(out.goal_depth);
  out.goal_area_length = json.at("goal_area").at(0);
  out.goal_area_width = json.at("goal_area").at(1);
  out.penalty_area_length = json.at("penalty_area").at(0);
  out.penalty_area_width = json.at("penalty_area").at(1);
  json.at("penalty_mark_distance").get_to(out.penalty_mark_distance);
  out.centre_circle_diameter = 2.0 * json.at("centre_circle_radius").get<double>();
  return out;
}

RecordedGame game(const nlohmann::json& json) {
  RecordedGame out;
  json.at("time").get_to(out.time);
  json.at("clock").get_to(out.clock);
  out.half = whole(json.at("half"));
  json.at("phase").get_to(out.phase);
  json.at("set_play").get_to(out.set_play);
  json.at("kicking").get_to(out.kicking);
  out.score = two(json.at("score"));
  out.packets_left = two(json.at("packets_left"));
  out.penalised = both(json.at("penalised"));
  out.fallen = both(json.at("fallen"));
  out.ball = {json.at("ball").at(0), json.at("ball").at(1)};
  for (const std::size_t side : {0u, 1u}) {
    for (const nlohmann::json& robot : json.at(side == 0 ? "home" : "away")) out.robots[side].push_back(pose(robot));
  }
  out.roles = both(json.at("roles"));
  const std::size_t robots = out.robots[0].size();
  require(robots >= 1 && robots <= most_robots && out.robots[1].size() == robots);
  require(out.roles[0].size() == robots && out.roles[1].size() == robots);
  return out;
}

RecordedWorld world(const nlohmann::json& json) {
  RecordedWorld out;
  if (const nlohmann::json& ball = json.at("ball"); !ball.is_null()) {
    out.ball = {ball.at("at").at(0), ball.at("at").at(1), ball.at("age"), 1.0, covariance(ball.at("covariance"))};
  }
  const nlohmann::json& mates = json.at("teammates");
  for (std::size_t i = 0; i < mates.at("number").size(); ++i) {
    out.teammates.push_back({whole(mates.at("number").at(i)), whole(mates.at("role").at(i)),
                             pose(mates.at("pose").at(i)), covariance(mates.at("covariance").at(i)),
                             mates.at("age").at(i)});
  }
  const nlohmann::json& others = json.at("opponents");
  for (std::size_t i = 0; i < others.at("at").size(); ++i) {
    out.opponents.push_back({others.at("at").at(i).at(0), others.at("at").at(i).at(1), others.at("age").at(i),
                             others.at("weight").at(i), covariance(others.at("covariance").at(i))});
  }
  return out;
}

RecordedBelief belief(const nlohmann::json& json) {
  RecordedBelief out;
  json.at("time").get_to(out.time);
  out.pose = pose(json.at("pose"));
  out.mine = world(json.at("mine"));
  if (json.contains("common")) out.common = world(json.at("common"));
  return out;
}

RecordedMatrix matrix(const nlohmann::json& json) {
  RecordedMatrix out;
  for (const nlohmann::json& row : json) {
    auto& added = out.emplace_back();
    for (const nlohmann::json& value : row) {
      added.push_back(value.is_null() ? std::optional<double>() : std::optional<double>(value.get<double>()));
    }
  }
  return out;
}

RecordedDecision decision(const nlohmann::json& json) {
  RecordedDecision out;
  json.at("time").get_to(out.time);
  out.context = whole(json.at("context"));
  json.at("knowledge").get_to(out.knowledge);
  json.at("waypoints").get_to(out.waypoints);
  for (const nlohmann::json& edge : json.at("edges")) out.edges.push_back(two(edge));
  for (const nlohmann::json& task : json.at("tasks")) {
    RecordedTask& added = out.tasks.emplace_back();
    added.role = whole(task.at("role"));
    added.before = pose(task.at("before"));
    if (!task.at("after").is_null()) added.after = pose(task.at("after"));
  }
  out.columns = wholes(json.at("columns"));
  out.rows = wholes(json.at("rows"));
  out.assigned = wholes(json.at("assigned"));
  out.role = whole(json.at("role"));
  out.utility = matrix(json.at("utility"));
  for (const nlohmann::json& term : json.at("terms")) out.terms.push_back(matrix(term));
  require(has_shape(out.utility, out.rows.size(), out.columns.size()));
  for (const RecordedMatrix& term : out.terms) require(has_shape(term, out.rows.size(), out.columns.size()));
  return out;
}

std::uint64_t clamped_nanoseconds(double seconds) {
  return static_cast<std::uint64_t>(std::llround(std::clamp(seconds, 0.0, 1e9) * 1e9));
}

// Reads the next readable message. `damage` receives the first error on the way. Throws mcap::Unsortable.
bool next(mcap::Reader& reader, mcap::Message& message, std::string& damage) {
  for (;;) {
    try {
      return reader.next(message);
    } catch (const mcap::Unsortable&) {
      throw;
    } catch (const mcap::Error& error) {
      if (damage.empty()) damage = error.what();
    }
  }
}

template <class Read>
auto reading(const std::filesystem::path& file, const std::string& what, Read read) {
  try {
    return read();
  } catch (const nlohmann::json::exception&) {
  } catch (const Senseless&) {
  }
  throw mcap::Error(file, "is damaged: " + what + " cannot be read");
}

// Only changes of a layer are recorded, so its present drawing may be minutes old. Messages are kept as text, and only
// the last of each layer is parsed completely. Throw nlohmann::json::exception or Senseless if one cannot be read.
class DrawingsOfRobot {
 public:
  explicit DrawingsOfRobot(const RobotName& robot) : robot_(robot) {}
  // The caller must pass all messages of /draw from the beginning of the match.
  void take(std::string_view message) {
    const nlohmann::json heading = heading_of(message, R"(,"shapes":)", {"side", "robot", "plugin", "layer"});
    const std::pair layer(heading.at("plugin").get<std::string>(), heading.at("layer").get<std::string>());
    if (!is_of(robot_, heading)) return;
    const auto [place, added] = places_.try_emplace(layer, messages_.size());
    if (added) messages_.emplace_back();
    messages_[place->second] = message;
  }
  std::vector<RecordedDrawing> drawings() const {
    std::vector<RecordedDrawing> out(messages_.size());
    for (const auto& [layer, place] : places_) out[place] = {layer.first, layer.second, shapes(messages_[place])};
    return out;
  }

 private:
  RobotName robot_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  // key: plugin and layer
  std::vector<std::string> messages_;                                  // last message of each layer, at its place
};

}  // namespace

RecordedMatch::RecordedMatch(const std::filesystem::path& file) : file_(file) {
  mcap::Reader reader(file);
  // Reads all messages to find the first and the last state of the game, and messages that are not in the order of
  // time. In a file without a summary this also finds the metadata.
  mcap::Message message;
  std::string first, last;
  std::uint64_t latest = 0, log_end = 0;
  while (next(reader, message, damage_)) {
    const std::string& topic = reader.channels().at(message.channel).topic;
    if (topic == "/heard")
      continue;  // robots write these messages when they decide, some time after the packet arrived
    in_order_ = in_order_ && latest <= message.log_time;
    latest = std::max(latest, message.log_time);
    if (topic != "/game") continue;
    if (first.empty() || message.log_time < log_begin_) {
      first = message.data;
      log_begin_ = message.log_time;
    }
    if (message.log_time < log_end) continue;
    last = message.data;
    log_end = message.log_time;
  }
  if (reader.cut_off() && damage_.empty()) damage_ = *reader.cut_off();
  const auto because = [&](const char* what) {  // an error names the first cause, not only its consequence
    return damage_.empty() ? what : damage_.substr(file.string().size() + 2) + "; " + what;
  };
  const mcap::Pairs* const about = match_metadata_in(reader);
  if (about == nullptr && !damage_.empty()) throw mcap::Error(file, because("what says who plays cannot be read"));
  if (about == nullptr) {
    throw mcap::Error(file, "is no recording of a match; `regista match A.yaml B.yaml --record FILE` writes one");
  }
  const auto value = [&](const char* key) -> const std::string& {
    const auto found = about->find(key);
    if (found == about->end()) throw mcap::Error(file, "is damaged: it does not say its " + std::string(key));
    return found->second;
  };
  if (const std::string& format = value("format"); format != std::to_string(recording_format)) {
    throw mcap::Error(file, "has format " + format + " of " + value("program") + "; this program reads format " +
                                std::to_string(recording_format));
  }
  if (last.empty()) throw mcap::Error(file, because("holds no state of the game"));
  reading(file, "who plays", [&] {
    field_ = recording::field(nlohmann::json::parse(value("field")));
    ball_radius_ = nlohmann::json::parse(value("ball_radius")).get<double>();
    teams_ = {team(nlohmann::json::parse(value("home"))), team(nlohmann::json::parse(value("away")))};
  });
  const RecordedGame ending =
      reading(file, "the last state of the game", [&] { return game(nlohmann::json::parse(last)); });
  end_ = ending.time;
  begin_ = reading(file, "the first state of the game", [&] { return game(nlohmann::json::parse(first)).time; });
  team_size_ = static_cast<int>(ending.robots[0].size());
  const std::uint64_t begin = clamped_nanoseconds(begin_);
  // Messages contain times in whole milliseconds, so a smaller difference means nothing.
  if (std::max(begin, log_begin_) - std::min(begin, log_begin_) < 1'000'000) log_begin_ = begin;
  fits_page_ = in_order_ && log_begin_ == begin && !reader.has_lz4();
}

// Converts seconds since the match began into a log time. Log times may count from any beginning, such as 1970.
std::uint64_t RecordedMatch::log_time(double time) const {
  const std::uint64_t away = clamped_nanoseconds(std::abs(time - begin_));
  if (time < begin_) return log_begin_ - std::min(away, log_begin_);
  return log_begin_ + std::min(away, std::numeric_limits<std::uint64_t>::max() - log_begin_);
}

void RecordedMatch::write_for_page(const std::filesystem::path& to) const {
  mcap::Reader reader(file_);
  reader.select({.by_time = !in_order_ || !reader.indexed()});  // the index knows the metadata beforehand
  mcap::Writer writer(to);
  std::map<mcap::ChannelId, mcap::ChannelId> channels;  // of the copy, by channel of this file
  for (mcap::Message message; reader.next(message);) {
    if (channels.empty()) std::ranges::for_each(reader.metadata(), [&](const auto& each) { writer.write(each); });
    const auto [channel, added] = channels.try_emplace(message.channel);
    const mcap::Channel& here = reader.channels().at(message.channel);
    if (added) channel->second = writer.add_channel(here.topic, here.message_encoding);
    message.channel = channel->second;
    const std::uint64_t since_begin = message.log_time + clamped_nanoseconds(begin_);
    message.log_time = since_begin - std::min(since_begin, log_begin_);
    writer.write(message);
  }
  writer.finish_chunk();
  if (!reader.cut_off()) writer.close();
}

std::optional<double> RecordedMatch::time_of(int half, double clock) const {
  mcap::Reader reader(file_);
  reader.select({.topics = {"/game"}, .by_time = true});
  mcap::Message message;
  std::string told_before;
  while (next(reader, message, told_before)) {
    const RecordedGame state =
        reading(file_, "a state of the game", [&] { return game(nlohmann::json::parse(message.data)); });
    if (state.half == half && state.clock >= clock - 1e-9) return state.time;
  }
  return std::nullopt;
}

RecordedMoment RecordedMatch::at(double time, const std::optional<RobotName>& robot) const {
  const std::string whose =
      robot ? (robot->side == 0 ? "/home/" : "/away/") + std::to_string(robot->number) : std::string();
  const std::string decisions = "/decision" + whose, beliefs = "/belief" + whose;
  mcap::Reader reader(file_);
  mcap::Selection selection{.last_time = log_time(time), .topics = {"/game"}, .by_time = true};
  if (robot) selection.topics.insert(selection.topics.end(), {decisions, beliefs, "/draw", "/log"});
  reader.select(selection);
  std::map<std::string, std::string> last;  // last message of each topic
  mcap::Message message;
  std::string told_before;
  DrawingsOfRobot drawings(robot.value_or(RobotName{}));
  std::deque<std::string> log;  // the last messages of /log
  const std::uint64_t log_begins = log_time(time - log_seconds);
  while (next(reader, message, told_before)) {
    const std::string& topic = reader.channels().at(message.channel).topic;
    if (topic == "/draw") {
      reading(file_, "a message of /draw", [&] { drawings.take(message.data); });
    } else if (topic == "/log") {
      const auto of_robot = [&] { return is_of(*robot, heading_of(message.data, R"(,"plugin":)", {"side", "robot"})); };
      if (message.log_time < log_begins || !reading(file_, "a message of /log", of_robot)) continue;
      log.emplace_back(message.data);
      if (log.size() > most_log_lines) log.pop_front();
    } else {
      last[topic] = message.data;
    }
  }
  if (last["/game"].empty()) throw mcap::Error(file_, "says nothing of a time that early");

  RecordedMoment out;
  out.game = reading(file_, "a state of the game", [&] { return game(nlohmann::json::parse(last["/game"])); });
  const auto told = [&](const std::string& topic, auto read) {
    return reading(file_, "a message of " + topic, [&] { return read(nlohmann::json::parse(last[topic])); });
  };
  if (!last[decisions].empty()) out.decision = told(decisions, decision);
  if (!last[beliefs].empty()) out.belief = told(beliefs, belief);
  out.drawings = reading(file_, "a message of /draw", [&] { return drawings.drawings(); });
  reading(file_, "a message of /log", [&] {
    for (const std::string& each : log) {
      const nlohmann::json json = nlohmann::json::parse(each);
      out.log.push_back({json.at("time"), json.at("plugin"), json.at("level"), json.at("text")});
    }
  });
  return out;
}

}  // namespace regista::recording
