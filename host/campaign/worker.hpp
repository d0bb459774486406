// SPDX-License-Identifier: MIT
// One match in a process of its own, with limits, a pipe for its answer and a shared note of whose call is under way:
// this program started once more, or a copy of one that has read the teams already (fork_server.hpp). Isolation from
// accidents, not from malice: a plugin can do whatever its user can.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "campaign/fork_server.hpp"
#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/worker_note.hpp"
#include "process/child.hpp"
#include "process/descriptor.hpp"
#include "process/kept_output.hpp"
#include "process/watch.hpp"

namespace regista::campaign {

// How a worker ended.
struct End {
  enum class How {
    answered,            // `text` is its answer
    died,                // by itself: a signal, exit() in the middle, an answer cut off
    processor_time,      // a call used up its limit
    wall_time,           // a call did not return
    match_time,          // the match used up its processor time, though no call did
    match_wall_time,     // the match did not end in time
    stopped,             // somebody stopped the process, which would wait for ever
    killed_from_outside  // by a signal that people and systems send: SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT
  };
  How how = How::died;
  std::string text;       // the answer, or in words how it ended: "Segmentation fault, in crashes.so"
  std::string output;     // what was written to standard error, cut in the middle
  plugin::CallNote note;  // the last one; its plugin is empty when no plugin was called
  OutsideNote outside;    // what a confined mind tried to do
  double seconds = 0.0;   // s of wall time
};

// A running worker. Never blocks.
class Worker {
 public:
  // `note` is cleared and outlives the worker. trail: a descriptor that the worker writes answers of plugins to, or
  // -1. server: who may start it more cheaply; null: nobody. Throws std::system_error when the process cannot be
  // started.
  Worker(const Job& job, const Limits& limits, SharedNote& note, int trail = -1, ForkServer* server = nullptr);
  // Kills it if it still runs.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Becomes readable when there is something to do; -1 once the worker has closed it.
  int descriptor() const { return pipe_.number; }
  pid_t process() const { return child_.process(); }             // -1 when it has ended
  int output_descriptor() const { return output_pipe_.number; }  // likewise

  // Reads what there is; true when the worker has ended. To be called when the descriptor is readable and every now
  // and then.
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
  std::optional<End::How> killed_for_;
  Clock::time_point began_ = Clock::now();
  process::CallWatch<plugin::CallNote> watch_;
  std::string answer_;
  process::KeptOutput output_;
  End end_;
};

}  // namespace regista::campaign
