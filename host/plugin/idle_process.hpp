// SPDX-License-Identifier: MIT
// For how long another process has done nothing. One that waits for a processor or for a disk is not idle: a machine
// with much else to do is held against nobody.
#pragma once

#include <sys/types.h>

#include <chrono>

namespace regista::plugin {

class IdleProcess {
 public:
  explicit IdleProcess(pid_t process) : process_(process) {}

  // s for which it has slept or been stopped, at every look: to be called several times a second.
  double idle_seconds();

 private:
  using Clock = std::chrono::steady_clock;
  pid_t process_;
  unsigned long long used_ = 0;  // of the processor, in ticks of the system
  Clock::time_point since_ = Clock::now();
};

}  // namespace regista::plugin
