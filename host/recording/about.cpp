// SPDX-License-Identifier: MIT
#include "recording/about.hpp"

#include <fmt/format.h>
#include <algorithm>

#include <span>

#include "config/packet_share.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "plugin/declarations.hpp"
#include "texts/json.hpp"

namespace regista::recording {
namespace {

using Json = nlohmann::ordered_json;

// "after=4.5 near=true": the values in force, given or not.
std::string parameters(const mind::Part& part) {
  using Type = config::PluginParameter::Type;
  const auto declarations = plugin::declarations(std::span(part.found, 1));
  if (declarations.empty()) return {};
  std::string out;
  const auto values = part.parameters.values();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const config::PluginParameter& declared = declarations.front().parameters[i];
    std::string value;
    switch (declared.type) {
      case Type::boolean:
        value = values[i].number != 0.0 ? "true" : "false";
        break;
      case Type::choice:
        value = declared.choices.at(static_cast<std::size_t>(values[i].number));
        break;
      case Type::text:
        value = values[i].text != nullptr ? values[i].text : "";
        break;
      case Type::file:
        for (const plugin::FileUsed& file : part.parameters.files()) {
          if (file.parameter == declared.name) value = file.path.filename().string();
        }
        break;
      default:
        value = fmt::format("{}", values[i].number);
    }
    out += fmt::format("{}{}={}", out.empty() ? "" : " ", declared.name, value);
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
                   {"robot", table[i].robot},
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

// As text that may stand in a file of UTF-8: names are whatever a user typed.
std::string sound(const std::string& text) { return Json::parse(dump(text)).get<std::string>(); }

}  // namespace

mcap::Pairs about(const RecordedSetup& setup) {
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
                                             {"file", plan.team().file},
                                             {"robot_radius", plan.robot().body.radius},
                                             {"walk_speed", plan.robot().walk.forward},
                                             {"roles", roles(plan)},
                                             {"contexts", contexts(plan)}});
  }
  return out;
}

const mcap::Pairs* about_in(const mcap::Reader& reader) {
  const auto found = std::ranges::find(reader.metadata(), about_record, &mcap::Metadata::name);
  return found == reader.metadata().end() ? nullptr : &found->pairs;
}

}  // namespace regista::recording
