// SPDX-License-Identifier: MIT
// The kinds of plugins that have a contract of their own, in the order in which they are checked.
#pragma once

#include <array>
#include <cstdint>

#include <regista/abi.h>

namespace regista::check {

inline constexpr std::array<std::int32_t, 7> kinds_checked{
    REGISTA_KIND_PREDICTOR, REGISTA_KIND_CONTEXT, REGISTA_KIND_POSITIONER, REGISTA_KIND_UTILITY,
    REGISTA_KIND_ASSIGNER,  REGISTA_KIND_SENDER,  REGISTA_KIND_BEHAVIOUR};

}  // namespace regista::check
