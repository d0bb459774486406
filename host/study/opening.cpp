// SPDX-License-Identifier: MIT
#include "study/opening.hpp"

#include <Random123/philox.h>

namespace regista::study {

std::size_t drawn_opening(std::uint64_t seed, std::size_t openings) {
  constexpr std::uint32_t purpose = 0x6f70656e;  // no other use of the seed draws these numbers
  const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}};
  const auto random = r123::Philox4x32()(counter, {{purpose, 0}});
  return static_cast<std::size_t>((std::uint64_t{random[0]} << 32 | random[1]) % openings);
}

}  // namespace regista::study
