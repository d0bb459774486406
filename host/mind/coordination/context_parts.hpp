// SPDX-License-Identifier: MIT
// The running plugins of one context of a robot.
#pragma once

#include <optional>
#include <vector>

#include "plugin/kinds.hpp"

namespace regista::mind {

struct ContextParts {
  plugin::Context condition;
  std::optional<plugin::Positioner> positioner;
  std::vector<plugin::Utility> terms;
  plugin::Assigner assigner;
  plugin::Sender sender;
};

}  // namespace regista::mind
