// SPDX-License-Identifier: MIT
// The context of last resort: it always holds, so that a team has a context in force whatever happens. It belongs at
// the lowest priority of the priority queue of contexts (Affinita et al. 2023, "Distributed Task Assignment").
#include <regista/context.hpp>

namespace {

struct Always {
  static constexpr auto id = "always", version = "1.0.0", summary = "Holds at all times";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  bool holds(const regista::Frame&) { return true; }
};

}  // namespace

REGISTA_PLUGIN(Always, regista::context)
