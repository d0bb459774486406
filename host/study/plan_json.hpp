// SPDX-License-Identifier: MIT
// What plans of studies have in common as JSON: openings, limits; and what is said of a text
// that no plan was written as.
#pragma once

#include <fmt/format.h>

#include <climits>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/whole_number.hpp"
#include "campaign/worker.hpp"
#include "config/json.hpp"
#include "study/opening.hpp"
#include "study/plan_names.hpp"

namespace regista::study {

inline nlohmann::ordered_json json_of(const std::vector<campaign::Input>& inputs) {
  return nlohmann::ordered_json::parse(campaign::to_json(inputs));
}
inline std::vector<campaign::Input> inputs_of(const nlohmann::ordered_json& json) {
  return campaign::inputs_from_json(json.dump());
}

inline nlohmann::ordered_json json_of(const std::vector<Opening>& openings) {
  auto out = nlohmann::ordered_json::array();
  for (const Opening& each : openings) {
    out.push_back({{"file", each.file}, {"input", json_of(std::vector<campaign::Input>{each.input})}});
  }
  return out;
}
inline std::vector<Opening> openings_of(const nlohmann::ordered_json& json) {
  std::vector<Opening> out;
  for (const auto& each : json) out.push_back({each.at("file").get<std::string>(), inputs_of(each.at("input")).at(0)});
  return out;
}

inline nlohmann::ordered_json json_of(const campaign::Limits& limits) {
  return {{"processor_seconds", limits.processor_seconds},
          {"memory", limits.memory},
          {"wall_seconds", limits.wall_seconds},
          {"match_wall_seconds", limits.match_wall_seconds}};
}
inline campaign::Limits limits_of(const nlohmann::ordered_json& json) {
  campaign::Limits out;
  out.processor_seconds = static_cast<int>(campaign::whole_number(json.at("processor_seconds"), INT_MAX));
  out.memory = campaign::whole_number(json.at("memory"));
  json.at("wall_seconds").get_to(out.wall_seconds);
  out.match_wall_seconds = json.value("match_wall_seconds", out.match_wall_seconds);  // results of before know none
  return out;
}

// read(json), or std::invalid_argument with the reason.
template <class Read>
auto read_plan(const std::string& text, const char* study, int version, Read read) {
  using Json = nlohmann::ordered_json;
  try {
    const Json json = Json::parse(text);
    if (json.at("study") != study) throw std::invalid_argument("these are results of another study");
    if (json.at("version") != version) throw std::invalid_argument("its plan is of another version");
    return read(json);
  } catch (const Json::exception& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  } catch (const std::out_of_range&) {
    throw std::invalid_argument("its plan is damaged");
  }
}

}  // namespace regista::study
