// SPDX-License-Identifier: MIT
// A context in a file that does something when it is opened, before anybody has asked for its plugin. The build says
// what: WHEN_OPENED is the name of a function, PLUGIN_ID that of the file.
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include <regista/context.hpp>

namespace {

[[maybe_unused]] void nothing() {}

[[maybe_unused]] void crash() {
  volatile int* volatile nowhere = nullptr;
  *nowhere = 1;
}

[[maybe_unused]] void leave() { std::_Exit(0); }

[[maybe_unused]] void sleep_on() {
  for (;;) pause();
}

[[maybe_unused]] void spin() {
  volatile bool for_ever = true;
  while (for_ever) {
  }
}

[[maybe_unused]] void start_a_thread() { std::thread(sleep_on).detach(); }

[[maybe_unused]] void share_memory() {
  void* volatile shared = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  (void)shared;
}

// What start-up code of -ffast-math does.
[[maybe_unused]] void flush_small_numbers() {
#if defined(__x86_64__)
  _mm_setcsr(_mm_getcsr() | 0x8040u);
#else
  std::fesetround(FE_UPWARD);
#endif
}

// As a machine without memory does, until the file "marks" of the working folder has MOST_KILLS lines.
[[maybe_unused]] void be_killed() {
  const char* const most = std::getenv("MOST_KILLS");
  std::ifstream before("marks");
  const auto lines = std::count(std::istreambuf_iterator<char>(before), {}, '\n');
  if (most == nullptr || lines >= std::atoi(most)) return;
  std::ofstream("marks", std::ios::app) << "killed\n";
  std::raise(SIGKILL);
}

[[maybe_unused]] void round_upward() { std::fesetround(FE_UPWARD); }

__attribute__((constructor)) void opened() { WHEN_OPENED(); }

}  // namespace

struct WhenOpened {
  static constexpr auto id = PLUGIN_ID, version = "1.0.0", summary = "Does something when its file is opened";
  bool holds(const regista::Frame&) { return true; }
};

REGISTA_PLUGIN(WhenOpened, regista::context)
