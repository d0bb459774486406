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

// Who dies so often in a row does so again.
constexpr int most_deaths = 3;

constexpr double longest_wait = 60.0;  // s, for a plugin that sleeps when it is loaded

// Between fork and exec: only calls that are safe in a signal handler.
[[noreturn]] void execute_server(int socket, const Limits& limits, pid_t coordinator) {
  constexpr int cannot = 127;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != coordinator || !limit_memory(limits)) _exit(cannot);
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
  execve("/proc/self/exe", arguments, environment_with({}));
  _exit(cannot);
}

}  // namespace

void ForkServer::begin() {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) == -1) return;
  socket_.reset(ends[0]);
  const FileDescriptor theirs(ends[1]);
  const pid_t coordinator = getpid();
  process_ = fork();
  if (process_ == 0) execute_server(theirs.number, limits_, coordinator);
  if (process_ != -1) setpgid(process_, process_);  // whoever of the two comes first
}

void ForkServer::end() {
  socket_.reset();
  if (process_ == -1) return;
  end_group(process_);
  while (waitpid(process_, nullptr, 0) == -1 && errno == EINTR) {
  }
  process_ = -1;
  end_strays_();
}

bool ForkServer::ask(int job_file, const WorkerFiles& files) {
  std::vector<int> passed{job_file, files.answer, files.note, files.output};
  if (files.trail != -1) passed.push_back(files.trail);
  return send_with_files(socket_.number, ForkRequest{++number_, files.trail != -1, 0}, passed);
}

// Dead, or held by a signal.
bool ForkServer::has_stopped() const {
  siginfo_t found{};
  return waitid(P_PID, static_cast<id_t>(process_), &found, WEXITED | WSTOPPED | WNOHANG | WNOWAIT) != 0 ||
         found.si_pid != 0;
}

// Nothing: it has died, does not come back from loading a plugin, or says what it does not say.
std::optional<ForkReply> ForkServer::hear() const {
  using Clock = std::chrono::steady_clock;
  constexpr int patience = 100;  // ms between two looks at it
  const auto began = Clock::now();
  const double processor = processor_seconds_of(process_);
  for (;;) {
    pollfd watched{socket_.number, POLLIN, 0};
    const int ready = poll(&watched, 1, patience);
    if (ready == 1) break;
    const bool working = processor_seconds_of(process_) - processor > limits_.processor_seconds;
    const bool waiting = std::chrono::duration<double>(Clock::now() - began).count() > longest_wait;
    if (working || waiting || has_stopped()) return std::nullopt;
  }
  ForkReply reply;
  std::vector<FileDescriptor> none;
  if (!receive_with_files(socket_.number, reply, none) || reply.number != number_) return std::nullopt;
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
    return -1;
  }
  deaths_ = reply->state == ForkReply::State::unfit ? most_deaths : 0;
  if (reply->state != ForkReply::State::ready) end();
  return reply->process;
}

}  // namespace regista::campaign
