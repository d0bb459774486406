// SPDX-License-Identifier: MIT
#include "campaign/process.hpp"

#include <csignal>
#include <ctime>

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

}  // namespace regista::campaign
