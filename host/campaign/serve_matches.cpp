// SPDX-License-Identifier: MIT
#include "campaign/serve_matches.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/fork_server.hpp"
#include "campaign/job.hpp"
#include "campaign/play_job.hpp"
#include "campaign/prepared_teams.hpp"
#include "campaign/worker_note.hpp"
#include "campaign/worker_process.hpp"
#include "config/bad_input.hpp"
#include "plugin/fatal_signal.hpp"
#include "process/child.hpp"
#include "process/descriptor.hpp"

namespace regista::campaign {
namespace {

// Out of the reach of plugins that write to a number which they take for their own file.
process::FileDescriptor away_from_plugins(int socket) {
  process::FileDescriptor kept(::fcntl(socket, F_DUPFD_CLOEXEC, 100));
  const process::FileDescriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
  if (!kept.is_open() || !nothing.is_open()) throw config::BadInput("cannot keep the connection to the coordinator");
  ::dup2(nothing.number, socket);
  return kept;
}

// As fork(), but the copy is a child of this process's parent, which can then wait for it. This process has one thread,
// so that nothing of the C library needs to be told; handlers of forks that libraries of plugins have registered do not
// run. The number by which the C library knows the thread is set as fork() does.
pid_t copy_for_parent() {
  unsigned long flags = CLONE_PARENT | SIGCHLD;
  int* number = nullptr;
  if (::prctl(PR_GET_TID_ADDRESS, &number) == 0 && number != nullptr)
    flags |= CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID;
#if defined(__x86_64__)
  return static_cast<pid_t>(::syscall(SYS_clone, flags, nullptr, nullptr, number, nullptr));
#else  // the last two the other way round
  return static_cast<pid_t>(::syscall(SYS_clone, flags, nullptr, nullptr, nullptr, number));
#endif
}

// What lists of processes show. Where this program was started as something else, it stays.
void be_called(std::string_view name) {
  char* const command = program_invocation_name + std::strlen(program_invocation_name) + 1;
  if (std::string_view(command) != server_command && std::string_view(command) != worker_command) return;
  static_assert(std::string_view(worker_command).size() <= std::string_view(server_command).size());
  std::memset(command, 0, std::string_view(server_command).size());
  std::memcpy(command, name.data(), name.size());
}

struct Connection {
  process::FileDescriptor socket;
  pid_t coordinator;
};

// In the copy, which no destructor leaves: it ends by _exit.
[[noreturn]] void play_in_copy(const Job& job, PreparedTeams::Match match, const WorkerFiles& files,
                               const Connection& connection, const std::string& program) {
  ::close(connection.socket.number);
  if (!process::become_child(worker_setting(files, job.limits), connection.coordinator))
    ::_exit(process::Child::never_began);
  for (const int each : {files.answer, files.note, files.output, files.trail}) {
    if (each > trail_descriptor) ::close(each);
  }
  process::write_all(STDERR_FILENO, match.output);
  try {
    const SharedNote shared{process::FileDescriptor(note_descriptor)};
    WorkerNote& note = *shared;
    plugin::note_fatal_signals(note.fatal);
    const Answer answer = answer_of([&] { return play_job(job, std::move(match.setup), program, note); });
    ::_exit(hand_over(answer) ? 0 : 1);
  } catch (const std::exception&) {  // the note
    ::_exit(process::Child::never_began);
  }
}

// The state that comes of a request; in the copy it does not return.
ForkReply answer(const ForkRequest& request, std::vector<process::FileDescriptor>& files, PreparedTeams& teams,
                 const Connection& connection, const std::string& program) {
  ForkReply reply;
  reply.number = request.number;
  const bool has_trail = request.has_trail != 0;
  if (files.size() != (has_trail ? 5u : 4u)) return reply;
  try {
    const Job job = job_from_json(process::everything_in(files[0].number));
    PreparedTeams::Match match = teams.prepare(job);
    if (!match.changed.empty()) return reply;
    // A copy has the name of a worker from its first moment: whoever ends the server by its name does not end a match.
    be_called(worker_command);
    reply.process = copy_for_parent();
    if (reply.process != 0) be_called(server_command);
    if (reply.process == 0) {
      files[0].reset();
      play_in_copy(job, std::move(match),
                   {files[1].number, files[2].number, files[3].number, has_trail ? files[4].number : -1, -1},
                   connection, program);
    }
    if (reply.process == -1 && errno != EAGAIN && errno != ENOMEM) reply.state = ForkReply::State::unfit;
  } catch (const Stale&) {
    reply.state = ForkReply::State::stale;
  } catch (const Unfit&) {
    reply.state = ForkReply::State::unfit;
  } catch (const std::exception&) {  // a worker that starts the program will say it
  }
  return reply;
}

}  // namespace

void serve_matches(const std::string& program) {
  int kind = 0;
  socklen_t size = sizeof kind;
  if (::getsockopt(server_descriptor, SOL_SOCKET, SO_TYPE, &kind, &size) == -1 || kind != SOCK_SEQPACKET) {
    throw config::BadInput(fmt::format("{}: is for the program itself, which starts it for a study", server_command));
  }
  const Connection connection{away_from_plugins(server_descriptor), ::getppid()};
  PreparedTeams teams;
  for (;;) {
    ForkRequest request;
    std::vector<process::FileDescriptor> files;
    if (!process::receive_with_files(connection.socket.number, request, files)) return;
    const ForkReply reply = answer(request, files, teams, connection, program);
    if (!process::send_with_files(connection.socket.number, reply, {}) || reply.state != ForkReply::State::ready)
      return;
  }
}

}  // namespace regista::campaign
