// SPDX-License-Identifier: MIT
#include "cli/plugin_json.hpp"

namespace regista::cli {

using Json = nlohmann::ordered_json;

Json plugin_json(const plugin::Info& info) {
  Json parameters = Json::array();
  for (const plugin::ParameterInfo& p : info.parameters) {
    parameters.push_back({{"name", p.name},
                          {"type", p.type},
                          {"range", p.range},
                          {"unit", p.unit},
                          {"default", p.initial},
                          {"tunable", p.tunable},
                          {"log_scale", p.log_scale},
                          {"doc", p.doc}});
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

}  // namespace regista::cli
