// SPDX-License-Identifier: MIT
// Rooms that all plugins of one robot write to, one after the other. They are small and asked for in every call, so
// that a room for each instance would drive more useful things out of the processor's cache.
#pragma once

#include <cstdint>

#include <regista/abi.h>

#include "plugin/guarded_room.hpp"

namespace regista::plugin {

struct SharedRooms {
  GuardedRoom<regista_error> error{1};
  GuardedRoom<std::uint32_t> count{1};     // of a predictor's tracks
  GuardedRoom<std::int32_t> condition{1};  // of a context
};

}  // namespace regista::plugin
