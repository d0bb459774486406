// SPDX-License-Identifier: MIT
// Finds the values in which two documents differ. Paths have the form that `--set` takes.
#pragma once

#include <string>
#include <vector>

#include "config/node.hpp"

namespace regista::config {

// The values of two documents at a path, each as YAML in one line; empty for a document without a value there.
struct Difference {
  std::string path, first, second;
};

// Returns the differences. In each map the keys of `first` come first, then keys that only `second` has. Lists of named
// maps are compared name by name, other lists as a whole. An element or map that one document lacks is one difference.
std::vector<Difference> differences(const Node& first, const Node& second);

}  // namespace regista::config
