// SPDX-License-Identifier: MIT
#include "config/plugin_use.hpp"

#include <utility>

namespace regista::config {

std::vector<Field> plugin_fields(PluginUse& use) {
  return {
      required(name("plugin", use.plugin, "id")),
      file("file", use.file, "a certain shared object, instead of the one that the search finds"),
      free("params", use.params, "params", "parameters of the plugin"),
  };
}

Field plugin_field(std::string key, PluginUse& use, std::string kind, std::string doc) {
  return {std::move(key), std::move(doc),
          Section{[&use, kind = std::move(kind)] {
                    return Map{.fields = plugin_fields(use), .where = &use.where, .plugin_kind = kind};
                  },
                  [&use] { return !use.plugin.empty(); }}};
}

}  // namespace regista::config
