// SPDX-License-Identifier: MIT
// Watches another process: its processor time and memory, its idle time, the duration of its current call, its output.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace regista::process {

// Returns the processor time of a running process so far, s; 0 if it is unknown.
double processor_seconds_of(pid_t process);

// Returns the mapped address space of a process, bytes; 0 if it is unknown.
std::uint64_t address_space_of(pid_t process);

// Measures how long a process has been idle. A process that waits for a processor or a disk does not count as idle.
class IdleProcess {
 public:
  explicit IdleProcess(pid_t process) : process_(process) {}

  // Returns how long, in s, all calls have found the process asleep or stopped. Must be called several times a second.
  double idle_seconds();

 private:
  using Clock = std::chrono::steady_clock;
  pid_t process_;
  unsigned long long used_ = 0;  // used processor time in clock ticks of the system
  Clock::time_point since_ = Clock::now();
};

struct CallLimits {
  int processor_seconds = 0;  // processor time of one call, s
  double wall_seconds = 0.0;  // wall time of one call, s; much longer than processor_seconds, for a plugin that sleeps
};

enum class Exceeded { nothing, processor_time, wall_time };

// Checks whether the current call in a process exceeds its limits. The owner calls look() from time to time. Call: a
// type whose values identify a call and differ from one call to the next.
template <class Call>
class CallWatch {
 public:
  using Clock = std::chrono::steady_clock;
  explicit CallWatch(const CallLimits& limits) : limits_(limits) {}

  // working: the process is in a call, and not between two calls.
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
  // Returns the time since the first look at the current call, s.
  double wall_seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  // Starts the measurement again. Must be called while no call with a time limit is in progress.
  void pause() {
    began_ = Clock::now();
    processor_then_ = unknown;
  }

 private:
  CallLimits limits_;
  Call call_{};
  Clock::time_point began_ = Clock::now();
  static constexpr double unknown = -1.0;
  double processor_then_ = unknown;  // processor time at the first look at the call, s
};

// Keeps the beginning and the end of the standard error text of a process.
class KeptOutput {
 public:
  void add(std::string_view text);
  // Returns the text. If a middle part is missing, a line says how many bytes were left out.
  std::string text() const;

 private:
  static constexpr std::size_t most_each = 4096;  // bytes that are kept at the beginning, and as many at the end
  std::string first_, last_;
  std::uint64_t left_out_ = 0;
};

}  // namespace regista::process
