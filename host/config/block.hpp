// SPDX-License-Identifier: MIT
// A Node tree written back as YAML for people: a line for each value, maps indented, lists of maps with a line for each
// element.
#pragma once

#include <string>

#include "config/node.hpp"

namespace regista::config {

// Precondition: a map that is not empty. Reading it gives the same tree.
std::string block(const Node& map, int indent = 0);

}  // namespace regista::config
