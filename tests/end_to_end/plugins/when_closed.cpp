// SPDX-License-Identifier: MIT
// A context in a file that does something when the process ends that has opened it. The build says what: WHEN_CLOSED is
// the name of a function, PLUGIN_ID that of the file.
#include <unistd.h>

#include <regista/context.hpp>

namespace {

[[maybe_unused]] void leave() { ::_exit(7); }

[[maybe_unused]] void sleep_on() {
  for (;;) ::pause();
}

[[maybe_unused]] void spin() {
  volatile bool for_ever = true;
  while (for_ever) {
  }
}

struct AtTheEnd {
  ~AtTheEnd() { WHEN_CLOSED(); }
};
const AtTheEnd at_the_end;

}  // namespace

struct WhenClosed {
  static constexpr auto id = PLUGIN_ID, version = "1.0.0", summary = "Does something when the process ends";
  bool holds(const regista::Frame&) { return true; }
};

REGISTA_PLUGIN(WhenClosed, regista::context)
