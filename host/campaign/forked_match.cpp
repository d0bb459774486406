// SPDX-License-Identifier: MIT
#include "campaign/forked_match.hpp"

#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string_view>

#include "plugin/fatal_signal.hpp"
#include "process/child.hpp"

namespace regista::campaign {
namespace {

// The memory that this process and the copy share.
struct Shared {
  WorkerNote note;
  std::atomic<int> code{-1};         // exit code of the work; -1: the work is not done
  std::array<char, 512> disorder{};  // describes what a plugin changed in the process; ends with a zero
};

constexpr std::array passed_on{SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGCONT};

// Variables of the signal handler, which can use only global variables.
std::atomic<pid_t> copy{0};
std::atomic<int> received{0};

// Signal handler: sends the signal to the copy. The copy has its own process group, so that Ctrl-C in the terminal
// reaches the copy only through this handler.
void pass_on(int signal_number) {
  const int error = errno;
  const pid_t process = copy;
  if (process > 0) ::kill(-process, signal_number);
  if (signal_number == SIGTSTP) {
    ::raise(SIGSTOP);
  } else if (signal_number != SIGCONT) {
    received = signal_number;
  }
  errno = error;
}

int work_in_copy(const std::function<int(WorkerNote&)>& work, Shared& shared) {
  std::signal(SIGTTOU, SIG_IGN);  // so that the copy may write to the terminal
  plugin::note_fatal_signals(shared.note.fatal);
  const auto in_disorder = [&shared](std::string_view what) {
    std::copy_n(what.data(), std::min(what.size(), shared.disorder.size() - 1), shared.disorder.data());
    return EXIT_FAILURE;
  };
  try {
    shared.code = work(shared.note);
  } catch (const LeftoverState& disorder) {
    std::fflush(nullptr);
    return in_disorder(disorder.what());
  } catch (const std::bad_alloc&) {
    return in_disorder("no memory is left");
  }
  // Flushes the streams here, because the copy ends without exit handlers: a plugin may have registered some.
  std::fflush(nullptr);
  return shared.code;
}

// While this object exists, signals to this process are passed on to the copy.
class PassedSignals {
 public:
  // Blocks the signals until go_to() or release().
  PassedSignals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int each : passed_on) sigaddset(&held, each);
    sigprocmask(SIG_BLOCK, &held, &mask_);
  }
  ~PassedSignals() {
    copy = 0;
    for (std::size_t i = 0; i < passed_on.size(); ++i) {
      if (told_) sigaction(passed_on[i], &old_[i], nullptr);
    }
    release();
  }
  PassedSignals(const PassedSignals&) = delete;
  PassedSignals& operator=(const PassedSignals&) = delete;

  void release() const { sigprocmask(SIG_SETMASK, &mask_, nullptr); }
  void go_to(pid_t process) {
    copy = process;
    told_ = true;
    for (std::size_t i = 0; i < passed_on.size(); ++i) {
      sigaction(passed_on[i], nullptr, &old_[i]);
      if (old_[i].sa_handler == SIG_IGN) continue;  // an ignored signal stays ignored, as SIGHUP under nohup
      struct sigaction action {};
      action.sa_handler = pass_on;
      action.sa_flags = SA_RESTART;
      sigaction(passed_on[i], &action, nullptr);
    }
    release();
  }

 private:
  sigset_t mask_;
  bool told_ = false;
  std::array<struct sigaction, passed_on.size()> old_{};
};

// Waits for the end of the child and returns this end. too_long: receives the reason if this function kills the child.
process::ProcessEnd watch_over(process::Child& child, const Shared& shared, const Limits& limits,
                               std::string& too_long) {
  // This descriptor becomes readable when the process ends; -1 if the system has no such descriptors.
  const process::FileDescriptor end_of_it(static_cast<int>(::syscall(SYS_pidfd_open, child.process(), 0)));
  process::CallWatch<plugin::CallNote> watch({limits.processor_seconds, limits.wall_seconds});
  for (;;) {
    if (const auto end = child.look()) {
      if (!end->was_stopped()) return *end;
      // SIGSTOP has stopped only the copy, which is killed. Ctrl-Z stops both processes, and `fg` continues both.
      if (WSTOPSIG(end->status) == SIGSTOP) {
        child.kill();
        child.wait();
        return *end;
      }
    }
    pollfd watched{end_of_it.number, POLLIN, 0};
    ::poll(&watched, 1, end_of_it.is_open() ? 100 : 10);
    const plugin::CallNote call = shared.note.call;
    if (call.inside == 0) watch.pause();  // no limit between calls: the copy may wait for the reader of its output
    const process::Exceeded exceeded = watch.look(call, call.inside == 1, child.process());
    if (exceeded == process::Exceeded::nothing || !too_long.empty()) continue;
    too_long = watch.in_words(exceeded);
    child.kill();
  }
}

}  // namespace

process::RedirectedStream keep_standard_output() { return {STDOUT_FILENO, STDERR_FILENO}; }

int run_supervised(const Limits& limits, const SupervisedWork& supervised) {
  process::SharedMemory<Shared> shared(process::for_copies);
  std::fflush(nullptr);  // otherwise both processes would write the buffered text
  const process::Descendants descendants;
  std::string too_long;
  process::ProcessEnd end;
  {
    PassedSignals signals;
    const process::Setting setting{.limits = {.core_file = true}, .keeps_streams = true, .keeps_signals = true};
    process::Child child = process::Child::copy(setting, [&] {
      signals.release();
      return work_in_copy(supervised.work, *shared);
    });
    signals.go_to(child.process());
    end = watch_over(child, *shared, limits, too_long);
  }
  descendants.end_all();  // ends the processes that plugins have started
  if (shared->code != -1) return shared->code;
  // A signal asked this process to end. has_spoken is false if a signal killed the copy, which then wrote no message.
  if (received != 0) return supervised.interrupted(received, !end.signal_number());
  shared->disorder.back() = '\0';
  ChildDeath loss{too_long, false, shared->note.sound()};
  if (!too_long.empty()) return supervised.lost(loss);
  loss.what = shared->disorder.front() == '\0' ? end.in_words() : shared->disorder.data();
  loss.what += where(loss.note.fatal);
  loss.from_outside = end.from_outside();
  return supervised.lost(loss);
}

}  // namespace regista::campaign
