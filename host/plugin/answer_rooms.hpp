// SPDX-License-Identifier: MIT
// Rooms that the plugins of one robot write their answers to, one call after the other. A room for each instance would
// be seldom used, and its edges, which are looked at after each call, would drive more useful things out of the
// processor's cache.
#pragma once

#include <cstdint>

#include <regista/abi.h>

#include "plugin/guarded_room.hpp"

namespace regista::plugin {

struct AnswerRooms {
  GuardedRoom<regista_error> error{1};  // of every call
  // Predictor
  GuardedRoom<std::uint32_t> track_count{1};
  // Context
  GuardedRoom<std::int32_t> holds{1};
  // Positioner
  GuardedRoom<regista_placement> placement{1};
  GuardedRoom<regista_waypoint> points{1};
  GuardedRoom<regista_edge> edges{1};
  GuardedRoom<regista_cell> cells{1};
  GuardedRoom<regista_vertex> vertices{1};
  // Utility
  GuardedRoom<double> utilities{1};
  // Assigner
  GuardedRoom<std::int32_t> columns{1};
  // Sender
  GuardedRoom<regista_send> send{1};
  GuardedRoom<std::uint64_t> granted{1};
};

}  // namespace regista::plugin
