// SPDX-License-Identifier: MIT
#include "campaign/serve_matches.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <exception>
#include <utility>
#include <vector>

#include "campaign/descriptor.hpp"
#include "campaign/descriptor_text.hpp"
#include "campaign/file_passing.hpp"
#include "campaign/fork_server.hpp"
#include "campaign/job.hpp"
#include "campaign/play_job.hpp"
#include "campaign/prepared_teams.hpp"
#include "campaign/shared_note.hpp"
#include "campaign/worker_process.hpp"
#include "config/bad_input.hpp"
#include "plugin/fatal_signal.hpp"

namespace regista::campaign {
namespace {

// As fork(), but the copy is a child of this process's parent, which can then wait for it. This process has one thread,
// and nothing asks the C library to be told of forks.
pid_t copy_for_parent() { return static_cast<pid_t>(::syscall(SYS_clone, CLONE_PARENT | SIGCHLD, 0, 0, 0, 0)); }

// In the copy. Files that it does not hand to the worker stay open until its end.
[[noreturn]] void play_in_copy(const Job& job, PreparedTeams::Match match, const WorkerFiles& files, pid_t coordinator,
                               const std::string& program) {
  constexpr int cannot = 127;
  if (!become_worker(files, job.limits, coordinator)) ::_exit(cannot);
  for (const int each : {files.answer, files.note, files.output, files.trail}) {
    if (each > trail_descriptor) ::close(each);
  }
  write_all(STDERR_FILENO, match.output);
  try {
    SharedNote shared(note_descriptor);
    WorkerNote& note = shared.note();
    plugin::note_fatal_signals(note.fatal);
    const Answer answer = answer_of([&] { return play_job(job, std::move(match.setup), program, note); });
    ::_exit(hand_over(answer) ? 0 : 1);
  } catch (const std::exception&) {  // the note
    ::_exit(cannot);
  }
}

}  // namespace

void serve_matches(const std::string& program) {
  int kind = 0;
  socklen_t size = sizeof kind;
  if (::getsockopt(server_descriptor, SOL_SOCKET, SO_TYPE, &kind, &size) == -1 || kind != SOCK_SEQPACKET) {
    throw config::BadInput(fmt::format("{}: is for the program itself, which starts it for a study", server_command));
  }
  const pid_t coordinator = ::getppid();
  PreparedTeams teams;
  for (;;) {
    ForkRequest request;
    std::vector<Descriptor> files;
    if (!receive_with_files(server_descriptor, request, files)) return;
    ForkReply reply;
    const bool has_trail = request.has_trail != 0;
    if (files.size() == (has_trail ? 5u : 4u)) {
      try {
        const Job job = job_from_json(everything_in(files[0].number));
        PreparedTeams::Match match = teams.prepare(job);
        if (match.changed.empty()) {
          reply.process = copy_for_parent();
          if (reply.process == 0) {
            files[0].reset();
            play_in_copy(job, std::move(match),
                         {files[1].number, files[2].number, files[3].number, has_trail ? files[4].number : -1},
                         coordinator, program);
          }
        }
      } catch (const Stale&) {
        reply.state = ForkReply::State::stale;
      } catch (const Unfit&) {
        reply.state = ForkReply::State::unfit;
      } catch (const std::exception&) {  // a worker that starts the program will say it
      }
    }
    const bool heard = ::send(server_descriptor, &reply, sizeof reply, MSG_NOSIGNAL) == sizeof reply;
    if (!heard || reply.state != ForkReply::State::ready) return;
  }
}

}  // namespace regista::campaign
