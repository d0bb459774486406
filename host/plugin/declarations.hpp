// SPDX-License-Identifier: MIT
// What plugins declare, in the words of the configuration: from it come the JSON Schema of a team and `config show`.
#pragma once

#include <span>
#include <vector>

#include "config/plugin_declaration.hpp"
#include "plugin/found.hpp"

namespace regista::plugin {

// One for each plugin and kind it implements (mailboxes are no place of a team), in the given order. Of several plugins
// with the same id and kind the first.
std::vector<config::PluginDeclaration> declarations(std::span<const Found> plugins);

}  // namespace regista::plugin
