// SPDX-License-Identifier: MIT
// How often something became of the segments of one robot's plugins: for the report of a match. Every offer that was
// taken is sent, dropped, or still pending; what is refused was never one.
#pragma once

#include <cstdint>

namespace regista::mind {

struct SegmentCounts {
  std::uint32_t offered = 0;  // and taken
  std::uint32_t refused = 0;
  std::uint32_t sent = 0;     // left in a packet
  std::uint32_t dropped = 0;  // expired, replaced or withdrawn
  std::uint32_t heard = 0;    // of teammates, handed to a plugin
  std::uint32_t bytes = 0;    // of those that left, with their headings
};

}  // namespace regista::mind
