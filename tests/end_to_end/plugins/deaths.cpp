// SPDX-License-Identifier: MIT
// Contexts that take the whole process with them, or try to, when they are asked for the twentieth time.
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <regista/context.hpp>
#include <regista/utility.hpp>

namespace {

template <class Death>
struct Mortal {
  static constexpr auto version = "1.0.0";
  int asked = 0;
  bool holds(const regista::Frame&) {
    if (++asked == 20) static_cast<Death*>(this)->die();
    return true;
  }
};

volatile bool deeper = true;

int depth(volatile char* caller) {
  volatile char room[4096];
  room[0] = caller == nullptr ? 1 : caller[0];
  return deeper ? depth(room) + room[0] : 0;
}

}  // namespace

struct Crashes : Mortal<Crashes> {
  static constexpr auto id = "crashes", summary = "Writes to where nothing is";
  void die() {
    volatile int* volatile nothing = nullptr;
    *nothing = 1;
  }
};

struct Aborts : Mortal<Aborts> {
  static constexpr auto id = "aborts", summary = "Aborts";
  void die() { std::abort(); }
};

struct Exits : Mortal<Exits> {
  static constexpr auto id = "exits", summary = "Ends the process as if all were well";
  void die() { std::exit(0); }
};

struct Spins : Mortal<Spins> {
  static constexpr auto id = "spins", summary = "Never answers";
  volatile bool for_ever = true;
  void die() {
    while (for_ever) {
    }
  }
};

struct TakesMemory : Mortal<TakesMemory> {
  static constexpr auto id = "takes_memory", summary = "Takes more memory than there is";
  std::vector<std::vector<char>> taken;
  void die() {
    for (;;) taken.emplace_back(std::size_t{64} << 20, 'x');
  }
};

struct OverflowsStack : Mortal<OverflowsStack> {
  static constexpr auto id = "overflows_stack", summary = "Calls itself without end";
  void die() { depth(nullptr); }
};

struct KillsItself : Mortal<KillsItself> {
  static constexpr auto id = "kills_itself", summary = "Sends itself the signal that nobody survives";
  void die() { kill(getpid(), SIGKILL); }
};

struct CorruptsAnswer : Mortal<CorruptsAnswer> {
  static constexpr auto id = "corrupts_answer", summary = "Writes into every file that is open";
  void die() {
    for (int descriptor = 3; descriptor < 64; ++descriptor) {
      [[maybe_unused]] const ssize_t written = write(descriptor, "{\"kind\":", 8);
    }
  }
};

// Dies in the first process only, the one that finds no file "died" in the current folder.
struct DiesOnce : Mortal<DiesOnce> {
  static constexpr auto id = "dies_once", summary = "Crashes, but not when it is tried again";
  void die() {
    if (access("died", F_OK) == 0) return;
    std::fclose(std::fopen("died", "w"));
    std::abort();
  }
};

// Dies only where a tuner leads it.
struct DiesOfDaring : Mortal<DiesOfDaring> {
  static constexpr auto id = "dies_of_daring", summary = "Crashes when it dares more than half";
  double daring = 0.2;
  static constexpr std::tuple parameters{
      regista::real("daring", &DiesOfDaring::daring, {0.0, 1.0}, "1", "Above a half it crashes").tunable()};
  void die() {
    if (daring > 0.5) std::abort();
  }
};

struct DiesAtTheEnd {
  static constexpr auto id = "dies_at_the_end", version = "1.0.0", summary = "Crashes when it is destroyed";
  bool used = false;
  bool holds(const regista::Frame&) { return used = true; }
  ~DiesAtTheEnd() {
    if (used) std::abort();
  }
};

struct DiesScoring {
  static constexpr auto id = "dies_scoring", version = "1.0.0", summary = "Aborts when it is asked for utilities";
  void score(const regista::Frame&, regista::Utilities) { std::abort(); }
};

REGISTA_PLUGINS(regista::Plugin<DiesScoring, regista::utility>, regista::Plugin<Crashes, regista::context>,
                regista::Plugin<Aborts, regista::context>, regista::Plugin<Exits, regista::context>,
                regista::Plugin<Spins, regista::context>, regista::Plugin<TakesMemory, regista::context>,
                regista::Plugin<OverflowsStack, regista::context>, regista::Plugin<KillsItself, regista::context>,
                regista::Plugin<CorruptsAnswer, regista::context>, regista::Plugin<DiesOnce, regista::context>,
                regista::Plugin<DiesOfDaring, regista::context>, regista::Plugin<DiesAtTheEnd, regista::context>)
