// SPDX-License-Identifier: MIT
// Contexts that are long done with their calls when a thread or a timer that they started does harm, in the call of
// another plugin; and one that damages the heap, as which everybody's call may be the one to die.
#include <sys/time.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include <regista/context.hpp>

namespace {

// Started once in a process, at the twentieth call of a robot's. Harm that ends the process has come before the
// hundredth call returns: on a busy machine the match would else be over first.
template <class Harm>
struct Threaded {
  static constexpr auto version = "1.0.0";
  int asked = 0;
  bool holds(const regista::Frame&) {
    static bool started = false;
    if (++asked == 100 && Harm::ends_the_process) {
      for (;;) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (asked != 20 || started) return true;
    started = true;
    std::thread([] {
      std::this_thread::sleep_for(std::chrono::milliseconds(3));
      Harm::harm();
    }).detach();
    return true;
  }
};

}  // namespace

struct CrashesLater : Threaded<CrashesLater> {
  static constexpr auto id = "crashes_later", summary = "Its thread writes to where nothing is";
  static constexpr bool ends_the_process = true;
  static void harm() {
    volatile int* volatile nothing = nullptr;
    *nothing = 1;
  }
};

struct ExitsLater : Threaded<ExitsLater> {
  static constexpr auto id = "exits_later", summary = "Its thread ends the process as if all were well";
  static constexpr bool ends_the_process = true;
  static void harm() { std::_Exit(0); }
};

struct StaysLater : Threaded<StaysLater> {
  static constexpr auto id = "stays_later", summary = "Its thread does nothing, and does not end";
  static constexpr bool ends_the_process = false;
  static void harm() {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
};

namespace {

volatile std::sig_atomic_t called = 0;  // whether CrashesInAHandler is, in whatever instance

// SIGALRM, every millisecond of time from then on.
void ring() {
  const itimerval often{{0, 1000}, {0, 1000}};
  ::setitimer(ITIMER_REAL, &often, nullptr);
}

}  // namespace

struct RingsLater {
  static constexpr auto id = "rings_later", version = "1.0.0", summary = "Starts a timer whose signal ends the process";
  int asked = 0;
  bool holds(const regista::Frame&) {
    if (++asked == 20) ring();
    return true;
  }
};

struct CrashesInAHandler {
  static constexpr auto id = "crashes_in_a_handler", version = "1.0.0",
                        summary = "A timer's signal finds it writing to where nothing is, but in its own calls";
  int asked = 0;
  bool holds(const regista::Frame&) {
    called = 1;
    if (++asked == 20) {
      std::signal(SIGALRM, [](int) {
        volatile int* volatile nothing = nullptr;
        if (called == 0) *nothing = 1;
      });
      ring();
    }
    called = 0;
    return true;
  }
};

struct FreesTwice {
  static constexpr auto id = "frees_twice", version = "1.0.0", summary = "Gives a block of memory back twice";
  int asked = 0;
  bool holds(const regista::Frame&) {
    void* volatile block = std::malloc(2000);
    std::free(block);
    if (++asked == 20) std::free(block);
    return true;
  }
};

REGISTA_PLUGINS(regista::Plugin<CrashesLater, regista::context>, regista::Plugin<ExitsLater, regista::context>,
                regista::Plugin<StaysLater, regista::context>, regista::Plugin<RingsLater, regista::context>,
                regista::Plugin<CrashesInAHandler, regista::context>, regista::Plugin<FreesTwice, regista::context>)
