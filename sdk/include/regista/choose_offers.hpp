// SPDX-License-Identifier: MIT
// Which pending offers of other plugins go along in a packet: the most urgent first, of equally urgent ones the oldest,
// as long as they fit. One that does not fit is passed over for smaller ones behind it. For senders
// (regista/sender.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace regista {

struct PendingOffer {
  std::uint32_t bytes;
  double urgency;  // [0, 1]
};

// offers: the oldest first. Fills `chosen` with indices into it, in the order in which they should be packed; the sum
// of their bytes is at most bytes_free.
inline void choose_offers(std::span<const PendingOffer> offers, std::uint32_t bytes_free,
                          std::vector<std::size_t>& chosen) {
  chosen.clear();
  for (std::size_t i = 0; i < offers.size(); ++i) chosen.push_back(i);
  std::sort(chosen.begin(), chosen.end(), [&](std::size_t a, std::size_t b) {
    return offers[a].urgency != offers[b].urgency ? offers[a].urgency > offers[b].urgency : a < b;
  });
  std::erase_if(chosen, [&](std::size_t i) {
    if (offers[i].bytes > bytes_free) return true;
    bytes_free -= offers[i].bytes;
    return false;
  });
}

}  // namespace regista
