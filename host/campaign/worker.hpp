// SPDX-License-Identifier: MIT
// A worker: a process that plays one match, with limits, a pipe for the answer, and a note in shared memory of the
// current call of a plugin. The process is a newly started program, or a copy of a process that has read the teams
// (fork_server.hpp). A worker protects from accidents, not from malice: a plugin has all rights of the user.
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "match/side.hpp"
#include "plugin/call_inputs.hpp"
#include "plugin/fatal_signal.hpp"
#include "process/child.hpp"
#include "process/file_descriptor.hpp"

namespace regista::campaign {

// The first try of a confined mind (process/confinement.hpp) to reach outside of its process, and the call of a plugin
// in which this happened.
struct OutsideNote {
  std::array<char, 48> what{};  // "open a file for writing"; empty: no mind has tried
  plugin::CallNote call;
  std::int32_t unconfined = 0;  // 1: this system does not confine processes
};

// The note of a worker in memory that it shares with its coordinator, who can read the note after the worker's death.
struct WorkerNote {
  plugin::CallNote call;
  plugin::FatalNote fatal;
  OutsideNote outside;
  std::array<pid_t, 2 * match::largest_team> groups{};  // process groups of minds with own processes; 0: unused

  // Returns a copy in which every text ends with a zero, even if a plugin has overwritten the note.
  WorkerNote sound() const {
    WorkerNote out = *this;
    out.call.plugin.back() = out.call.call.back() = '\0';
    out.outside.what.back() = out.outside.call.plugin.back() = out.outside.call.call.back() = '\0';
    out.fatal.thread.back() = out.fatal.object.back() = '\0';
    return out;
  }
};

using SharedNote = process::SharedMemory<WorkerNote>;

// File descriptors of a worker.
inline constexpr int answer_descriptor = 3, note_descriptor = 4, trail_descriptor = 5;

// The mark before the answer. The coordinator ignores bytes before the mark, which a plugin wrote by accident.
inline constexpr std::string_view answer_mark = "\nregista-answer:";

// The hidden command that a worker runs. It reads a Job from standard input, and writes an Answer to answer_descriptor.
inline constexpr const char* worker_command = "play-one";

// The files for a worker, as descriptors of the process that starts the worker; -1: no file. job: for standard input.
struct WorkerFiles {
  int answer = -1, note = -1, output = -1, trail = -1, job = -1;
};
process::Setting worker_setting(const WorkerFiles& files, const Limits& limits);

// The limits of stack and address space for a process that opens plugins.
inline process::Limits memory_limits(const Limits& limits) { return {.memory = limits.memory, .small_stack = true}; }

// Returns the environment for programs that play matches, with a null at the end: that of this process, and a variable
// for large pages of memory, because page faults in some megabytes of usual pages take a fifth of a game's processor
// time (benchmarks/campaign/fork_server.py). A perturbed play has usual pages, and a variable that moves its memory.
std::vector<char*> environment(bool perturbed);

// The end of a worker.
struct End {
  bool answered = false;  // true: the worker has sent its complete answer, which is in `text`
  // true: the cause is a signal that people and systems send: one of ProcessEnd::from_outside(), or one that stopped
  // the process (SIGSTOP), so that it was killed.
  bool from_outside = false;
  std::string text;       // the answer; otherwise the reason of the end: "Segmentation fault, in crashes.so"
  std::string output;     // the worker's output on standard error; a long output lacks its middle
  plugin::CallNote note;  // the last call of a plugin; its plugin id is empty if no plugin was called
  OutsideNote outside;    // the first try of a confined mind to reach outside of its process
  double seconds = 0.0;   // s of wall time
};

class ForkServer;

// A running worker. Its functions never block.
class Worker {
 public:
  // Starts a worker. Clears `note`, which must outlive the worker, and the file with the descriptor `trail`; -1: no
  // trail. server: a fork server, which starts the worker faster; null: none. Throws std::system_error.
  Worker(const Job& job, SharedNote& note, int trail, ForkServer* server);
  ~Worker();  // kills the worker if it still runs

  // The pipe for the answer, which is readable when advance() has something to do; -1 after the worker closed the pipe.
  int descriptor() const { return pipe_.number; }
  pid_t process() const { return child_.process(); }             // -1 after the worker has ended
  int output_descriptor() const { return output_pipe_.number; }  // the pipe for standard error; -1: closed

  // Reads both pipes and checks the limits. Returns true when the worker has ended. Must be called when a descriptor is
  // readable, and also at regular times.
  bool advance();

  // Precondition: advance() has returned true.
  End end() const { return end_; }

 private:
  void read();
  void kill();
  void watch_call();
  double seconds() const;
  double match_wall_seconds() const;
  void ended(const process::ProcessEnd& end);

  using Clock = std::chrono::steady_clock;
  Limits limits_;
  SharedNote& note_;
  bool apart_;
  process::Child child_;
  process::FileDescriptor pipe_, output_pipe_;
  std::string why_killed_;  // empty: not killed
  bool stopped_ = false;    // true: killed, because a signal had stopped the process
  Clock::time_point began_ = Clock::now();
  process::CallWatch<plugin::CallNote> watch_;
  std::string answer_;
  process::KeptOutput output_;
  End end_;
};

}  // namespace regista::campaign
