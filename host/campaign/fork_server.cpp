// SPDX-License-Identifier: MIT
#include "campaign/fork_server.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <vector>

#include "campaign/file_passing.hpp"
#include "campaign/process.hpp"

namespace regista::campaign {
namespace {

// Who dies so often while teams are read does so again.
constexpr int most_deaths = 3;

// Between fork and exec: only calls that are safe in a signal handler.
[[noreturn]] void execute_server(int socket, pid_t coordinator) {
  constexpr int cannot = 127;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != coordinator) _exit(cannot);
  const int kept = fcntl(socket, F_DUPFD, 10), nothing = open("/dev/null", O_RDWR);
  if (kept == -1 || nothing == -1) _exit(cannot);
  for (const int each : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, each);
  if (dup2(kept, server_descriptor) == -1) _exit(cannot);
  close(kept);
  if (nothing > server_descriptor) close(nothing);
  std::array<char, 8> name{"regista"};
  std::array<char, 16> command{};
  std::strncpy(command.data(), server_command, command.size() - 1);
  char* const arguments[] = {name.data(), command.data(), nullptr};
  execv("/proc/self/exe", arguments);
  _exit(cannot);
}

}  // namespace

void ForkServer::begin() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == -1) return;
  socket_.reset(ends[0]);
  const Descriptor theirs(ends[1]);
  const pid_t coordinator = getpid();
  process_ = fork();
  if (process_ == 0) execute_server(theirs.number, coordinator);
  if (process_ != -1) setpgid(process_, process_);  // whoever of the two comes first
}

void ForkServer::end() {
  socket_.reset();
  if (process_ == -1) return;
  end_group(process_);
  while (waitpid(process_, nullptr, 0) == -1 && errno == EINTR) {
  }
  process_ = -1;
}

bool ForkServer::ask(int job_file, const WorkerFiles& files) const {
  std::vector<int> passed{job_file, files.answer, files.note, files.output};
  if (files.trail != -1) passed.push_back(files.trail);
  return send_with_files(socket_.number, ForkRequest{files.trail != -1}, passed);
}

// Nothing: it has died, or does not come back from loading a plugin.
std::optional<ForkReply> ForkServer::hear() const {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::seconds(limits_.processor_seconds);
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd watched{socket_.number, POLLIN, 0};
    const int ready = poll(&watched, 1, left > 0 ? static_cast<int>(left) : 0);
    if (ready == -1 && errno == EINTR) continue;
    if (ready != 1) return std::nullopt;
    break;
  }
  ForkReply reply;
  if (recv(socket_.number, &reply, sizeof reply, 0) != static_cast<ssize_t>(sizeof reply)) return std::nullopt;
  return reply;
}

pid_t ForkServer::start(const Job& job, int job_file, const WorkerFiles& files) {
  // Minds in processes of their own, or a match that is to be played elsewhere: these need a program of their own.
  if (job.isolated || job.elsewhere || job.plugin_files.empty() || deaths_ >= most_deaths) return -1;
  if (process_ == -1) begin();
  const std::optional<ForkReply> reply = process_ != -1 && ask(job_file, files) ? hear() : std::optional<ForkReply>();
  if (!reply) {
    ++deaths_;
    end();
    end_strays_();
    return -1;
  }
  if (reply->state == ForkReply::State::unfit) deaths_ = most_deaths;
  if (reply->state != ForkReply::State::ready) end();
  return reply->process;
}

}  // namespace regista::campaign
