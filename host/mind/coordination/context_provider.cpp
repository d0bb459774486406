// SPDX-License-Identifier: MIT
#include "mind/coordination/context_provider.hpp"

#include <cassert>

namespace regista::mind {

int choose_context(std::span<const config::Context> contexts, std::span<ContextParts> parts, const Worlds& worlds,
                   regista_frame& frame) {
  assert(contexts.size() == parts.size());
  int chosen = -1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    frame.knowledge = raw(worlds.answering(contexts[i].knowledge));
    if (parts[i].condition.holds(frame) && chosen < 0) chosen = static_cast<int>(i);
  }
  return chosen;
}

}  // namespace regista::mind
