// SPDX-License-Identifier: MIT
// Rooms that the plugins of one robot write their answers to, one call after the other. A room for each instance would
// be seldom used, and its edges, which are looked at after each call, would drive more useful things out of the
// processor's cache.
#pragma once

#include <cstdint>

#include <regista/abi.h>

#include "plugin/call_note.hpp"
#include "plugin/guarded_room.hpp"

namespace regista::plugin {

struct AnswerRooms {
  // After every call the edges of its rooms are looked at, and how numbers are rounded. Closely: also all of their
  // pattern, and all of the floating-point state.
  bool closely = true;

  CallNote unheard;                   // where calls are noted that nobody listens to
  GuardedValue<regista_error> error;  // of every call
  // Predictor
  GuardedValue<regista_room> track_room;
  GuardedRoom<regista_track> tracks{1};
  // Context
  GuardedValue<std::int32_t> holds;
  // Positioner
  GuardedValue<regista_placement> placement;
  GuardedRoom<regista_waypoint> points{1};
  GuardedRoom<regista_edge> edges{1};
  GuardedRoom<regista_cell> cells{1};
  GuardedRoom<regista_vertex> vertices{1};
  // Utility
  GuardedRoom<double> utilities{1};
  // Assigner
  GuardedRoom<std::int32_t> columns{1};
  // Behaviour
  GuardedValue<regista_action> action;
  // Sender
  GuardedValue<regista_send> send;
  GuardedRoom<std::uint64_t> granted{1};
  // Mailbox
  GuardedRoom<char> text{1};
};

}  // namespace regista::plugin
