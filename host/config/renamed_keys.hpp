// SPDX-License-Identifier: MIT
// Keys that got a new name after a release. In a document that a person writes, the old name is a mistake, and the
// message gives the new name. In the documents of a stored match, an old name means the new name.
#pragma once

#include <functional>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

// Returns the new name of the parameter `former` of a plugin. If `plugin` is "", returns the new name of the key
// `former` of a role's target. Returns an empty text if the name has not changed.
std::string_view present_name(std::string_view plugin, std::string_view former);

// Returns whether an available plugin declares a parameter of this name.
using Declares = std::function<bool(std::string_view plugin, std::string_view parameter)>;

// Returns a team's document with new names. A parameter is renamed only if its plugin declares the new name and not the
// old name, because an old build of a plugin still has the old name.
Node with_present_names(const Node& team, const Declares& declares);

}  // namespace regista::config
