// SPDX-License-Identifier: MIT
// Watching another process: what it has used, for how long it has done nothing, and whether the call that it is in
// takes too long.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>

namespace regista::process {

// s of processor time of a process that runs, so far; 0 where it cannot be known.
double processor_seconds_of(pid_t process);

// Bytes of addresses that a process has mapped; 0 where it cannot be known.
std::uint64_t address_space_of(pid_t process);

// For how long it has done nothing. One that waits for a processor or for a disk is not idle: a machine with much else
// to do is held against nobody.
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

struct CallLimits {
  int processor_seconds = 0;  // of one call
  double wall_seconds = 0.0;  // likewise: a far back-stop, for one that sleeps
};

enum class Exceeded { nothing, processor_time, wall_time };

// Whether the call that is under way in a process has used up its time. Looked at every now and then. Call: what says
// which call it is, a value that differs from one call to the next.
template <class Call>
class CallWatch {
 public:
  using Clock = std::chrono::steady_clock;
  explicit CallWatch(const CallLimits& limits) : limits_(limits) {}

  // working: it is in that call, and not between two.
  Exceeded look(const Call& call, bool working, pid_t process) {
    const double processor = processor_seconds_of(process);
    if (!(call == call_)) {
      call_ = call;
      began_ = Clock::now();
      processor_then_ = processor;
    }
    if (processor_then_ < 0.0) processor_then_ = processor;
    if (wall_seconds() > limits_.wall_seconds) return Exceeded::wall_time;
    if (working && processor - processor_then_ > limits_.processor_seconds) return Exceeded::processor_time;
    return Exceeded::nothing;
  }
  // s since it was seen first.
  double wall_seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  // Nothing is under way whose time is limited.
  void pause() {
    began_ = Clock::now();
    processor_then_ = unknown;
  }

 private:
  CallLimits limits_;
  Call call_{};
  Clock::time_point began_ = Clock::now();
  static constexpr double unknown = -1.0;
  double processor_then_ = unknown;  // s that the process had used when the call was seen first
};

}  // namespace regista::process
