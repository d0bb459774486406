// SPDX-License-Identifier: MIT
// A context that never answers.
#include <regista/context.hpp>

struct Hangs {
  static constexpr auto id = "hangs", version = "1.0.0", summary = "Never answers";
  volatile bool for_ever = true;
  bool holds(const regista::Frame&) {
    while (for_ever) {
    }
    return true;
  }
};
REGISTA_PLUGIN(Hangs, regista::context)
