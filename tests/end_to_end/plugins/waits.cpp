// SPDX-License-Identifier: MIT
// Contexts that use no processor time and do not let the match go on.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <regista/context.hpp>

namespace {

template <class Kind>
struct Waiting {
  static constexpr auto version = "1.0.0";
  int asked = 0;
  bool holds(const regista::Frame&) {
    if (++asked == 20) static_cast<Kind*>(this)->wait();
    return true;
  }
};

}  // namespace

struct Stops : Waiting<Stops> {
  static constexpr auto id = "stops", summary = "Stops its own process";
  void wait() { kill(getpid(), SIGSTOP); }
};

struct Sleeps : Waiting<Sleeps> {
  static constexpr auto id = "sleeps", summary = "Never wakes up";
  void wait() {
    for (;;) pause();
  }
};

struct Dawdles {
  static constexpr auto id = "dawdles", version = "1.0.0", summary = "Rests for a moment at every call";
  bool holds(const regista::Frame&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return true;
  }
};

REGISTA_PLUGINS(regista::Plugin<Stops, regista::context>, regista::Plugin<Sleeps, regista::context>,
                regista::Plugin<Dawdles, regista::context>)
