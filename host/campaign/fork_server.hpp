// SPDX-License-Identifier: MIT
// Workers that need not start the program, open plugins and read teams each: a process that has done that copies itself
// for each match (a fork server, as fuzzers have them; M. Zalewski, 2014). No instance of a plugin is ever made in that
// process, so each match finds what a program just started would find, as far as a plugin may depend on it, and a
// result does not depend on what was played before; the second play of a pairing's first match, which starts the
// program, holds that to account. What it can't prepare, for whatever reason, is left to a worker that starts the
// program, and says why.
//
// The copies are children of the coordinator, not of the server (CLONE_PARENT): they are watched, limited and blamed as
// all workers are.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/worker_process.hpp"
#include "process/child.hpp"
#include "process/descriptor.hpp"

namespace regista::campaign {

// The hidden command of the program that the server runs, with its socket at server_descriptor.
inline constexpr const char* server_command = "fork-server";
inline constexpr int server_descriptor = 3;

// What is asked of the server: a datagram of its own kind, with four or five file descriptors: job (a file with a Job),
// answer, note, output and, where there is one, trail.
struct ForkRequest {
  std::uint64_t number = 0;  // comes back with the reply
  std::int32_t has_trail = 0;
  std::int32_t reserved = 0;
};

struct ForkReply {
  enum class State : std::int32_t {
    ready,  // for the next request
    stale,  // it ends: a file is not what it was
    unfit,  // it ends: none is to be started again
  };
  std::uint64_t number = 0;
  std::int32_t process = -1;  // -1: start it otherwise
  State state = State::ready;
};

class ForkServer {
 public:
  // It is started when it is needed first. end_strays: ends all children of this process that nobody knows of; called
  // when the server has died, which may have started a worker and not said so.
  ForkServer(const Limits& limits, std::function<void()> end_strays)
      : limits_(limits), end_strays_(std::move(end_strays)) {}
  ~ForkServer() { end(); }
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  // A worker, of which this process is the parent; none that runs: start it otherwise. Waits until the teams have been
  // read, some 20 ms where they are new, else one, and at most as long as a call of a plugin may take. files.job: a
  // file with the job.
  process::Child start(const Job& job, const WorkerFiles& files);

  pid_t process() const { return server_.process(); }  // -1: it does not run now

 private:
  void begin();
  void end();
  bool ask(const WorkerFiles& files);
  std::optional<ForkReply> hear();

  Limits limits_;
  std::function<void()> end_strays_;
  process::Child server_;
  bool begun_ = false;  // since it was ended last
  process::FileDescriptor socket_;
  int deaths_ = 0;  // one after the other
  std::uint64_t number_ = 0;
};

}  // namespace regista::campaign
