// SPDX-License-Identifier: MIT
// The chance of a search: a stream of Philox4x32-10 (J. K. Salmon et al., "Parallel Random Numbers: As Easy as 1, 2,
// 3", 2011) named by the search's seed and by what it is used for. Laws of its own: those of <random> differ between
// libraries. Two draws must not stand in one argument list.
#pragma once

#include <cstdint>

#include "match/normal_law.hpp"
#include "match/random_words.hpp"

namespace regista::study {

class Draws {
 public:
  // No two users of one seed share a stream.
  enum class Use : std::uint32_t {
    spsa = 0x73707361,
    sep_cma_es = 0x636d6165,
    random = 0x72616e64,
    nlopt = 0x6e6c6f70
  };

  Draws(std::uint64_t seed, Use use) : words_(seed, {0, 0, static_cast<std::uint32_t>(use), 0}) {}

  std::uint32_t bits() { return words_.next(); }

  // [0, 1), in steps of 2^-53.
  double uniform() {
    const std::uint64_t high = bits() >> 5;
    const std::uint64_t low = bits() >> 6;
    return static_cast<double>(high << 26 | low) * 0x1p-53;
  }

  // -1 or 1.
  double sign() { return bits() >> 31 == 0 ? -1.0 : 1.0; }

  double normal() {
    return normal_.draw([this] { return uniform(); });
  }

 private:
  match::RandomWords words_;
  match::NormalLaw normal_;
};

}  // namespace regista::study
