// SPDX-License-Identifier: MIT
// The dotted paths of a document, as --set and `use:` write them.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"

namespace regista::config {

// Of every value, and of every map and list that holds some. Elements of a list go by their `name`; of lists without
// names the list alone is told.
std::vector<std::string> paths_of(const Node& document);

}  // namespace regista::config
