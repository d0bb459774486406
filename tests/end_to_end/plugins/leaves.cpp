// SPDX-License-Identifier: MIT
// Contexts that leave something in the process that is not theirs alone.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include <regista/context.hpp>

namespace {

// Once, at the twentieth call of each robot.
template <class What>
struct Leaves {
  static constexpr auto version = "1.0.0";
  int asked = 0;
  bool holds(const regista::Frame&) {
    if (++asked == 20) What::leave();
    return true;
  }
};

[[noreturn]] void live_on() {
  for (;;) ::sleep(1);
}

}  // namespace

struct LeavesAChild : Leaves<LeavesAChild> {
  static constexpr auto id = "leaves_a_child", summary = "Starts a process and forgets it";
  static void leave() {
    if (::fork() == 0) live_on();
  }
};

struct LeavesAnOrphan : Leaves<LeavesAnOrphan> {
  static constexpr auto id = "leaves_an_orphan", summary = "Starts a process that detaches itself";
  static void leave() {
    const pid_t between = ::fork();
    if (between != 0) {
      ::waitpid(between, nullptr, 0);
      return;
    }
    ::setsid();
    if (::fork() == 0) live_on();
    ::_exit(0);
  }
};

struct BlocksASignal : Leaves<BlocksASignal> {
  static constexpr auto id = "blocks_a_signal", summary = "Blocks a signal";
  static void leave() {
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, SIGUSR2);
    ::pthread_sigmask(SIG_BLOCK, &one, nullptr);
  }
};

struct SetsAVariable : Leaves<SetsAVariable> {
  static constexpr auto id = "sets_a_variable", summary = "Sets a variable of the environment";
  static void leave() { ::setenv("OF_A_PLUGIN", "1", 1); }
};

struct ChangesTheUmask : Leaves<ChangesTheUmask> {
  static constexpr auto id = "changes_the_umask", summary = "Changes the mode of new files";
  static void leave() { ::umask(0007); }
};

REGISTA_PLUGINS(regista::Plugin<LeavesAChild, regista::context>, regista::Plugin<LeavesAnOrphan, regista::context>,
                regista::Plugin<BlocksASignal, regista::context>, regista::Plugin<SetsAVariable, regista::context>,
                regista::Plugin<ChangesTheUmask, regista::context>)
