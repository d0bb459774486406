// SPDX-License-Identifier: MIT
#include "recording/recorded_match.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "mcap/error.hpp"
#include "recording/about.hpp"
#include "recording/recorded_json.hpp"
#include "texts/json.hpp"

namespace regista::recording {
namespace {

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

RecordedPose pose(const nlohmann::json& json) { return {json.at(0), json.at(1), json.at(2)}; }
RecordedCovariance covariance(const nlohmann::json& json) { return {json.at(0), json.at(1), json.at(2)}; }

RecordedTeam team(const nlohmann::json& json) {
  RecordedTeam out;
  json.at("team").get_to(out.name);
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

// The next message that can be read; what cannot is noted in `damage`, the first of it.
bool next(mcap::Reader& reader, mcap::Message& message, std::string& damage) {
  for (;;) {
    try {
      return reader.next(message);
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

}  // namespace

RecordedMatch::RecordedMatch(const std::filesystem::path& file) : file_(file) {
  mcap::Reader reader(file);
  reader.select({.topics = {"/game"}});
  // All of the game's states, for the last one is wanted; of a file without a summary, this also finds who played.
  mcap::Message message;
  std::string first, last;
  while (next(reader, message, damage_)) {
    last = message.data;
    if (first.empty()) first = last;
  }
  if (reader.cut_off() && damage_.empty()) damage_ = *reader.cut_off();
  const mcap::Pairs* const about = about_in(reader);
  if (about == nullptr && !damage_.empty()) throw mcap::Error(file, "breaks off before it says who plays");
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
  if (last.empty()) throw mcap::Error(file, "ends before the first state of the game was written");
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
}

std::optional<double> RecordedMatch::time_of(int half, double clock) const {
  mcap::Reader reader(file_);
  reader.select({.topics = {"/game"}});
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
  mcap::Selection selection{.last_time = clamped_nanoseconds(time), .topics = {"/game"}};
  if (robot) selection.topics.insert(selection.topics.end(), {decisions, beliefs, "/draw", "/log"});
  reader.select(selection);
  std::map<std::string, std::string> last;  // by topic
  mcap::Message message;
  std::string told_before;
  DrawingsOfRobot drawings(robot.value_or(RobotName{}));
  LogOfRobot log(robot.value_or(RobotName{}), most_log_lines);
  const std::uint64_t log_begins = clamped_nanoseconds(time - log_seconds);
  while (next(reader, message, told_before)) {
    const std::string& topic = reader.channels().at(message.channel).topic;
    if (topic == "/draw") {
      reading(file_, "a message of /draw", [&] { drawings.take(message.data); });
    } else if (topic == "/log") {
      if (message.log_time >= log_begins) reading(file_, "a message of /log", [&] { log.take(message.data); });
    } else {
      last[topic] = message.data;
    }
  }
  if (last["/game"].empty()) throw mcap::Error(file_, "says nothing of a time that early");

  RecordedMoment out;
  out.game = reading(file_, "a state of the game", [&] { return game(nlohmann::json::parse(last["/game"])); });
  if (!last[decisions].empty()) {
    out.decision =
        reading(file_, "a message of " + decisions, [&] { return decision(nlohmann::json::parse(last[decisions])); });
  }
  if (!last[beliefs].empty()) {
    out.belief =
        reading(file_, "a message of " + beliefs, [&] { return belief(nlohmann::json::parse(last[beliefs])); });
  }
  out.drawings = reading(file_, "a message of /draw", [&] { return drawings.drawings(); });
  out.log = reading(file_, "a message of /log", [&] { return log.lines(); });
  return out;
}

}  // namespace regista::recording
