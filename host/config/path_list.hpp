// SPDX-License-Identifier: MIT
// Files or folders that a document names: one, or a list of them.
#pragma once

#include <string>
#include <vector>

#include "config/declaration.hpp"

namespace regista::config {

struct NamedPath {
  std::string path;  // absolute
  Location where;
};

// Relative to the file that the document stands in; each must exist.
Field paths(std::string key, std::vector<NamedPath>& paths, std::string doc);

}  // namespace regista::config
