// SPDX-License-Identifier: MIT
// A declaration -> JSON Schema, draft 2020-12.
#pragma once

#include <span>
#include <string>

#include "config/declaration.hpp"
#include "config/plugin_declaration.hpp"

namespace regista::config {

// The schema of a whole document, indented JSON that ends with a line break. Defaults are what the declared object
// holds.
std::string schema(const Map& map, const std::string& title, std::span<const PluginDeclaration> plugins);

}  // namespace regista::config
