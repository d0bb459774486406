// SPDX-License-Identifier: MIT
#include "study/more_pairs.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace regista::study {

void raise_pairs(std::uint64_t& pairs, std::string& before, std::uint64_t wanted, std::uint64_t first_seed) {
  if (wanted == pairs) return;
  if (wanted < pairs) throw std::invalid_argument(fmt::format("it has {} pairs already", pairs));
  if (wanted > most_pairs) throw std::invalid_argument(fmt::format("at most {} pairs can be played", most_pairs));
  if (first_seed > UINT64_MAX - (wanted - 1)) {
    throw std::invalid_argument(
        fmt::format("{} pairs from seed {} on would need seeds beyond {}", wanted, first_seed, UINT64_MAX));
  }
  before += fmt::format("{}{}", before.empty() ? "" : ", ", pairs);
  pairs = wanted;
}

}  // namespace regista::study
