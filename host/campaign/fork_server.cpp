// SPDX-License-Identifier: MIT
#include "campaign/fork_server.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <system_error>
#include <vector>

#include "process/watch.hpp"

namespace regista::campaign {
namespace {

// Who dies so often in a row does so again.
constexpr int most_deaths = 3;

constexpr double longest_wait = 60.0;  // s, for a plugin that sleeps when it is loaded

}  // namespace

void ForkServer::begin() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == -1) return;
  socket_.reset(ends[0]);
  const process::FileDescriptor theirs(ends[1]);
  process::Setting setting;
  setting.files = {{theirs.number, server_descriptor}};
  setting.limits = memory_limits(limits_);
  const std::vector<char*> variables = environment_with({});
  begun_ = true;
  try {
    server_ = process::Child::program(setting, {process::Child::this_program, {"regista", server_command}, variables});
  } catch (const std::system_error&) {
    // Then workers start the program.
  }
}

void ForkServer::end() {
  socket_.reset();
  if (!begun_) return;
  begun_ = false;
  if (server_.runs()) {
    server_.kill();
    server_.wait();
  }
  end_strays_();
}

bool ForkServer::ask(const WorkerFiles& files) {
  std::vector<int> passed{files.job, files.answer, files.note, files.output};
  if (files.trail != -1) passed.push_back(files.trail);
  return process::send_with_files(socket_.number, ForkRequest{++number_, files.trail != -1, 0}, passed);
}

// Nothing: it has died, does not come back from loading a plugin, or says what it does not say.
std::optional<ForkReply> ForkServer::hear() {
  constexpr int patience = 100;  // ms between two looks at it
  process::CallWatch<int> watch({limits_.processor_seconds, longest_wait});
  for (;;) {
    pollfd watched{socket_.number, POLLIN, 0};
    if (poll(&watched, 1, patience) == 1) break;
    const bool too_long = watch.look(0, true, server_.process()) != process::Exceeded::nothing;
    if (too_long || server_.look()) return std::nullopt;  // or it has died, or is held by a signal
  }
  ForkReply reply;
  std::vector<process::FileDescriptor> none;
  if (!process::receive_with_files(socket_.number, reply, none) || reply.number != number_) return std::nullopt;
  return reply;
}

process::Child ForkServer::start(const Job& job, const WorkerFiles& files) {
  // Minds in processes of their own, or a match that is to be played elsewhere: these need a program of their own.
  if (job.is_apart() || job.elsewhere || job.plugin_files.empty() || deaths_ >= most_deaths) return {};
  if (!server_.runs()) begin();
  const std::optional<ForkReply> reply = server_.runs() && ask(files) ? hear() : std::optional<ForkReply>();
  if (!reply) {
    ++deaths_;
    end();
    return {};
  }
  // From now on it is not in the server's group, with which it would be ended.
  if (reply->process != -1) ::setpgid(reply->process, reply->process);
  deaths_ = reply->state == ForkReply::State::unfit ? most_deaths : 0;
  if (reply->state != ForkReply::State::ready) end();
  return process::Child(reply->process);
}

}  // namespace regista::campaign
