// SPDX-License-Identifier: MIT
#include "recording/recording_metadata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "config/rules.hpp"
#include "match/game_state.hpp"
#include "match/teams.hpp"
#include "mcap/file_io.hpp"
#include "plugin/info.hpp"
#include "texts/json.hpp"

namespace regista::recording {
namespace {

using Json = nlohmann::ordered_json;

std::string value_text(const regista_value& value, const config::PluginParameter& declared, const mind::Part& part) {
  using Type = config::PluginParameter::Type;
  if (declared.type == Type::boolean) return value.number != 0.0 ? "true" : "false";
  if (declared.type == Type::choice) return declared.choices.at(static_cast<std::size_t>(value.number));
  if (declared.type == Type::text) return value.text != nullptr ? value.text : "";
  if (declared.type != Type::file) return fmt::format("{}", value.number);
  const auto files = part.parameters.files();
  const auto file = std::ranges::find(files, declared.name, &plugin::FileUsed::parameter);
  return file == files.end() ? "" : file->path.filename().string();
}

// Returns the values of all parameters, including defaults: "after=4.5 near=true".
std::string parameters(const mind::Part& part) {
  const auto declarations = plugin::declarations(std::span(part.found, 1));
  if (declarations.empty()) return {};
  std::string out;
  const auto values = part.parameters.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const config::PluginParameter& declared = declarations.front().parameters[i];
    out += fmt::format("{}{}={}", out.empty() ? "" : " ", declared.name, value_text(values[i], declared, part));
  }
  return out;
}

const char* word(config::Knowledge knowledge) { return knowledge == config::Knowledge::mine ? "mine" : "common"; }

Json roles(const mind::TeamPlan& plan) {
  const std::vector<match::Role> table = match::roles(plan);
  const std::vector<std::string> names = match::role_names(table);
  Json out = Json::array();
  for (std::size_t i = 0; i < table.size(); ++i) {
    out.push_back({{"name", names[i]},
                   {"list", table[i].list},
                   {"priority", table[i].priority},
                   {"robots", table[i].robots},
                   {"least_in_play", table[i].least_in_play},
                   {"plays_ball", table[i].plays_ball}});
  }
  return out;
}

Json contexts(const mind::TeamPlan& plan) {
  Json out = Json::array();
  for (std::size_t i = 0; i < plan.contexts().size(); ++i) {
    const mind::ContextPlan& parts = plan.contexts()[i];
    const config::Context& page = plan.team().contexts[i];
    Json terms = Json::array();
    for (const mind::TermPart& term : parts.terms) terms.push_back({{"name", term.name}, {"weight", term.weight}});
    out.push_back({{"name", page.name},
                   {"priority", page.priority},
                   {"plugin", page.use.plugin},
                   {"parameters", parameters(parts.condition)},
                   {"list", plan.team().role_lists[static_cast<std::size_t>(page.role_list)].name},
                   {"utility_knowledge", word(page.utility_knowledge)},
                   {"tasks_knowledge", word(page.tasks.knowledge)},
                   {"waypoints_knowledge", word(page.tasks.waypoints_knowledge)},
                   {"filter_knowledge", word(page.tasks.filter_knowledge)},
                   {"condition_knowledge", word(page.knowledge)},
                   {"terms", terms},
                   {"positioner", page.positioner.plugin},
                   {"assigner", page.assigner.plugin},
                   {"sender", page.sender.plugin}});
  }
  return out;
}

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// Returns the text as well-formed UTF-8, because users may type other bytes.
std::string sound(const std::string& text) { return Json::parse(dump(text)).get<std::string>(); }

constexpr std::uint64_t last_stretch = 1'000'000'000;  // ns: this end of the file is read for the final score

bool says(const mcap::Pairs& about, const char* key, std::string_view value) {
  const auto found = about.find(key);
  return found != about.end() && found->second == value;
}

// Compares a team's name with its label. A label may be a name plus a file or a letter: "small (a/small.yaml)".
bool says_team(const mcap::Pairs& about, const char* side, const std::string& label) {
  const auto found = about.find(side);
  if (found == about.end()) return false;
  const std::string name = nlohmann::json::parse(found->second).at("team").get<std::string>();
  return label == name || label.starts_with(name + " (");
}

bool fits(const mcap::Pairs& about, const RecordingIdentity& match) {
  return says(about, "seed", std::to_string(match.seed)) && says(about, "opening", match.opening) &&
         says_team(about, "home", match.labels[0]) && says_team(about, "away", match.labels[1]);
}

// Returns the score at the end of a complete recording. States come ten times a second, so the last goals need events.
std::optional<std::array<int, 2>> last_score(mcap::Reader& reader) {
  const mcap::Statistics* const statistics = reader.statistics();
  if (statistics == nullptr) return std::nullopt;
  const std::uint64_t end = statistics->last_time;
  reader.select({.first_time = end - std::min(end, last_stretch), .topics = {"/game", "/event"}, .by_time = true});
  std::string last;
  for (mcap::Message message; reader.next(message);) last = message.data;
  if (last.empty()) return std::nullopt;
  return nlohmann::json::parse(last).at("score").get<std::array<int, 2>>();
}

// Returns the number of recorded packets. Precondition: the file has a summary, which counts messages.
double packets(const mcap::Reader& reader) {
  std::uint64_t out = 0;
  for (const auto& [channel, count] : reader.statistics()->messages_of) {
    const auto found = reader.channels().find(channel);
    if (found != reader.channels().end() && found->second.topic == "/packet") out += count;
  }
  return static_cast<double>(out);
}

}  // namespace

mcap::Pairs match_metadata(const RecordedSetup& setup) {
  const config::Rules& rules = setup.plans[0]->rules();
  const config::FieldSize& field = rules.field;
  mcap::Pairs out;
  out["format"] = std::to_string(recording_format);
  out["program"] = setup.program;
  out["command"] = sound(setup.command);
  out["seed"] = std::to_string(setup.seed);
  out["rules"] = sound(rules.name);
  out["opening"] = sound(setup.opening);
  out["field"] = dump({{"length", field.length},
                       {"width", field.width},
                       {"border_strip", field.border_strip},
                       {"goal_width", field.goal_width},
                       {"goal_depth", field.goal_depth},
                       {"goal_area", {field.goal_area_length, field.goal_area_width}},
                       {"penalty_area", {field.penalty_area_length, field.penalty_area_width}},
                       {"penalty_mark_distance", field.penalty_mark_distance},
                       {"centre_circle_radius", field.centre_circle_diameter / 2.0}});
  out["ball_radius"] = dump(rules.ball.diameter / 2.0);
  out["packet_budget"] = std::to_string(config::packets(rules.messages));
  out["half_seconds"] = dump(rules.durations.half);
  for (std::size_t side = 0; side < 2; ++side) {
    const mind::TeamPlan& plan = *setup.plans[side];
    out[side == 0 ? "home" : "away"] = dump({{"team", plan.team().name},
                                             {"title", plan.team().title},
                                             {"file", plan.team().file},
                                             {"robot_radius", plan.robot().body.radius},
                                             {"walk_speed", plan.robot().walk.forward},
                                             {"roles", roles(plan)},
                                             {"contexts", contexts(plan)}});
  }
  return out;
}

const mcap::Pairs* match_metadata_in(const mcap::Reader& reader) {
  const auto found = std::ranges::find(reader.metadata(), match_metadata_name, &mcap::Metadata::name);
  return found == reader.metadata().end() ? nullptr : &found->pairs;
}

bool is_recording_of(const std::filesystem::path& recording, const RecordingIdentity& match) {
  try {
    mcap::Reader reader(recording);
    if (!reader.indexed()) {
      if (match.score) return false;
      // The metadata comes before the first message, so reading this message is enough.
      mcap::Message message;
      reader.next(message);
    }
    const mcap::Pairs* const about = match_metadata_in(reader);
    if (about == nullptr || !fits(*about, match)) return false;
    if (!match.score) return true;
    return last_score(reader) == match.score && (!match.packets || packets(reader) == *match.packets);
  } catch (const mcap::Error&) {
  } catch (const nlohmann::json::exception&) {
  }
  return false;
}

std::optional<double> first_goal(const std::filesystem::path& recording) {
  mcap::Reader reader(recording);
  reader.select({.topics = {"/event"}, .by_time = true});
  for (mcap::Message message; reader.next(message);) {
    const auto event = nlohmann::json::parse(message.data, nullptr, false);
    if (!event.is_object() || event.value("event", "") != match::word(match::EventKind::goal)) continue;
    const auto time = event.find("time");
    if (time != event.end() && time->is_number()) return time->get<double>();
  }
  return std::nullopt;
}

}  // namespace regista::recording
