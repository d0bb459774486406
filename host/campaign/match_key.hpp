// SPDX-License-Identifier: MIT
// What a stored match is found by, and how much of it is asked for.
#pragma once

#include <cstdint>

namespace regista::campaign {

// The number that the store gave to a fixture, and the seed.
struct MatchKey {
  std::int64_t fixture = 0;
  std::uint64_t seed = 0;
  friend bool operator==(const MatchKey&, const MatchKey&) = default;
};

// What is read of the numbers of a match, which are some kilobytes. packets: those of match/packet_metrics.hpp, and
// perhaps others.
enum class Metrics { wanted, packets, left_out };

}  // namespace regista::campaign
