// SPDX-License-Identifier: MIT
// Which shared object an address belongs to, for handlers of fatal signals: a table that is filled when files are
// loaded and can be read at any moment, also in the middle of a crash. A handler takes no arguments of ours, so this is
// the one table of the process.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace regista::plugin {

using ObjectName = std::array<char, 64>;  // "voronoi.so", cut off; ends with a zero

// Notes where the shared object that `handle` (of dlopen) stands for lies. Those beyond the 256th are left out.
void note_address_range(void* handle);

// An address in each noted object, in the order in which they were noted. Not for handlers.
std::vector<const void*> noted_objects();

// Null when no noted object has this address. Safe in a handler of signals.
const ObjectName* object_at(std::uintptr_t address);

}  // namespace regista::plugin
