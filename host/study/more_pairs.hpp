// SPDX-License-Identifier: MIT
// More pairs of matches for a study that was begun with fewer. What was said for the first number was seen before the
// second was asked for, so the plan keeps both and reports say so.
#pragma once

#include <cstdint>
#include <string>

namespace regista::study {

inline constexpr std::uint64_t most_pairs = 10'000'000;

// pairs becomes `wanted`, and `before` lists what it was, "100, 150"; nothing changes where it is that already. Throws
// std::invalid_argument, one line, for fewer, and for more than can be played from that seed on.
void raise_pairs(std::uint64_t& pairs, std::string& before, std::uint64_t wanted, std::uint64_t first_seed);

}  // namespace regista::study
