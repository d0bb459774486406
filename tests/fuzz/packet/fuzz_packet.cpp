// SPDX-License-Identifier: MIT
// Any bytes that come out of the air: refused, or the one encoding of a report that makes sense.
#include <cstdlib>

#include "fuzz/packet/canonical.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace regista::mind;
  const PacketLimits limits{.team_size = 7, .role_count = 20, .context_count = 3, .size = 128};
  const Verdict verdict = examine({data, size}, limits);
  if (verdict == Verdict::not_canonical || verdict == Verdict::no_sense) std::abort();
  return 0;
}
