// SPDX-License-Identifier: MIT
// An object -> the YAML it would be read from, every value with its unit, meaning and origin as a comment.
#pragma once

#include <span>
#include <string>

#include "config/declaration.hpp"
#include "config/node.hpp"
#include "config/plugin_declaration.hpp"

namespace regista::config {

enum class Remarks { with, without };  // values alone: equal for documents that mean the same

// `document` is what the object was read from: it tells where each value stood. Values it does not have are defaults.
std::string show(const Map& map, const Node& document, std::span<const PluginDeclaration> plugins,
                 Remarks remarks = Remarks::with);

}  // namespace regista::config
