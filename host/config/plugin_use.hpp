// SPDX-License-Identifier: MIT
// The declaration of a plugin's place in a document: `{plugin: greedy, file: old/greedy.so, params: {...}}`.
#pragma once

#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/team.hpp"

namespace regista::config {

// The three keys, for a map that has more of them.
std::vector<Field> plugin_fields(PluginUse& use);

// A section of the three. kind: "predictor", ..., for schema and `show`.
Field plugin_field(std::string key, PluginUse& use, std::string kind, std::string doc);

}  // namespace regista::config
