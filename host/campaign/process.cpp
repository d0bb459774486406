// SPDX-License-Identifier: MIT
#include "campaign/process.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <ctime>
#include <fstream>

namespace regista::campaign {

double processor_seconds_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool comes_from_outside(int signal_number) {
  return signal_number == SIGKILL || signal_number == SIGTERM || signal_number == SIGINT || signal_number == SIGHUP ||
         signal_number == SIGQUIT;
}

void end_group(pid_t process) {
  if (::kill(-process, SIGKILL) == -1) ::kill(process, SIGKILL);
}

void adopt_orphans() { prctl(PR_SET_CHILD_SUBREAPER, 1); }

void end_children_but(std::span<const pid_t> those) {
  // Killing one may hand over its own children.
  for (int round = 0; round < 100; ++round) {
    std::ifstream list("/proc/thread-self/children");
    bool found = false;
    for (pid_t child = 0; list >> child;) {
      if (std::ranges::find(those, child) != those.end()) continue;
      found = true;
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
    if (!found) return;
  }
}

}  // namespace regista::campaign
