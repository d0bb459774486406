// SPDX-License-Identifier: MIT
// The paper's Context Provider: CTX is the context of the highest priority whose conditions hold.
#pragma once

#include <span>

#include "config/team.hpp"
#include "mind/coordination/context_parts.hpp"
#include "mind/coordination/worlds.hpp"
#include "regista/abi.h"

namespace regista::mind {

// The index of the context in force, -1 when none holds. `contexts` and `parts` are of the same length, the highest
// priority first. Every condition is asked, so that those with a memory keep it, about the world that answers for the
// one its context names: `frame.knowledge` changes.
int choose_context(std::span<const config::Context> contexts, std::span<ContextParts> parts, const Worlds& worlds,
                   regista_frame& frame);

// How a frame says which world a step is computed on.
inline std::int32_t raw(config::Knowledge knowledge) {
  return static_cast<std::int32_t>(knowledge == config::Knowledge::common ? REGISTA_COMMON : REGISTA_MINE);
}

}  // namespace regista::mind
