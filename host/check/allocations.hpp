// SPDX-License-Identifier: MIT
// How often this process allocates by operator new: the plugins that it has opened included, as far as they are C++.
#pragma once

#include <cstddef>

namespace regista::check {

// Begins to count. Returns what tells the count; null where sanitizers allocate.
std::size_t (*count_allocations())();

}  // namespace regista::check
