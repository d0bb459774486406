// SPDX-License-Identifier: MIT
#include "report/plugin_json.hpp"

#include <cmath>
#include <span>

#include "plugin/declarations.hpp"
#include "plugin/info.hpp"

namespace regista::report {

using Json = nlohmann::ordered_json;

namespace {

Json parameter_json(const config::PluginParameter& declared, const plugin::ParameterInfo& info) {
  using Type = config::PluginParameter::Type;
  Json out{{"name", info.name}, {"type", info.type}};
  switch (declared.type) {
    case Type::real:
      out.update({{"minimum", declared.minimum}, {"maximum", declared.maximum}, {"default", declared.initial}});
      break;
    case Type::integer:
      out.update({{"minimum", std::llround(declared.minimum)},
                  {"maximum", std::llround(declared.maximum)},
                  {"default", std::llround(declared.initial)}});
      break;
    case Type::boolean:
      out["default"] = declared.initial != 0.0;
      break;
    case Type::choice:
      out.update({{"choices", declared.choices}, {"default", info.initial}});
      break;
    case Type::text:
    case Type::file:
      out["default"] = info.initial;
      break;
  }
  out.update({{"unit", info.unit}, {"tunable", info.tunable}, {"log_scale", info.log_scale}, {"doc", info.doc}});
  return out;
}

}  // namespace

Json plugin_json(const plugin::Found& plugin) {
  const plugin::Info info = plugin::info(plugin);
  Json parameters = Json::array();
  // One for each kind, all with the same parameters.
  const auto declarations = plugin::declarations(std::span(&plugin, 1));
  if (!declarations.empty()) {
    for (std::size_t i = 0; i < info.parameters.size(); ++i) {
      parameters.push_back(parameter_json(declarations.front().parameters[i], info.parameters[i]));
    }
  }
  return {{"id", info.id},
          {"kinds", info.kinds},
          {"version", info.version},
          {"summary", info.summary},
          {"licence", info.licence},
          {"build_tag", info.build_tag},
          {"interface", info.abi},
          {"file", info.file},
          {"subjects", info.subjects},
          {"negotiates", info.negotiates},
          {"parameters", parameters}};
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace regista::report
