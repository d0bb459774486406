// SPDX-License-Identifier: MIT
// Starts workers faster: a server process starts the program, opens plugins and reads teams once, then copies itself
// for each match (a fork server, as fuzzers have them; M. Zalewski, 2014). The server creates no instance of a plugin.
// So each match begins with the state of a newly started program, and its result does not depend on earlier matches. To
// test this, the second play of a pairing's first match runs in a newly started program. If the server cannot prepare a
// match, a newly started program plays it and reports the reason.
//
// The copies are children of the coordinator (CLONE_PARENT), which watches, limits and blames them like other workers.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "campaign/job.hpp"
#include "campaign/worker.hpp"
#include "process/child.hpp"
#include "process/file_descriptor.hpp"

namespace regista::campaign {

// The hidden command that starts this program as a fork server.
inline constexpr const char* server_command = "fork-server";

struct ForkReply;

// The coordinator's side.
class ForkServer {
 public:
  // The first start() also starts the server. end_strays: ends all children of this process that the caller does not
  // know; called after the end of the server, which may die before it reports a new worker.
  ForkServer(const Limits& limits, std::function<void()> end_strays)
      : limits_(limits), end_strays_(std::move(end_strays)) {}
  ~ForkServer() { end(); }

  // Starts a worker, a child of this process. If the server cannot start it, returns a child that does not run, and the
  // caller must start the worker itself. Waits until the server has read the teams: some 20 ms for new teams, 1 ms for
  // known teams, and at most the time limit of a plugin's call. files.job: a file with the job.
  process::Child start(const Job& job, const WorkerFiles& files);

  pid_t process() const { return server_.process(); }  // -1: the server does not run

 private:
  void begin();
  void end();
  bool ask(const WorkerFiles& files);
  std::optional<ForkReply> hear();

  Limits limits_;
  std::function<void()> end_strays_;
  process::Child server_;
  bool begun_ = false;  // begin() was called after the last end()
  process::FileDescriptor socket_;
  int deaths_ = 0;  // deaths of the server in a row
  std::uint64_t number_ = 0;
};

// The main function of the server: reads teams, and copies itself for each match. Returns when the connection to the
// coordinator ends, or when a new server must replace this one. program: "regista 0.1.0", for recordings. Throws
// config::BadInput if no coordinator has started this process.
void serve_matches(const std::string& program);

}  // namespace regista::campaign
