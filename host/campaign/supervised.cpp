// SPDX-License-Identifier: MIT
#include "campaign/supervised.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string_view>
#include <system_error>

#include "campaign/process.hpp"
#include "plugin/descendants.hpp"
#include "plugin/fatal_signal.hpp"

namespace regista::campaign {
namespace {

// Memory that both processes see.
struct Shared {
  WorkerNote note;
  std::atomic<int> done{0};  // 1: `code` is the exit code of the work
  std::atomic<int> code{0};
  std::array<char, 512> disorder{};  // what a plugin left behind; ends with a zero
};

constexpr std::array passed_on{SIGINT, SIGTERM, SIGHUP, SIGTSTP, SIGCONT};

// Handlers of signals take no arguments of ours.
std::atomic<pid_t> copy{0};
std::atomic<int> received{0};

// The copy has a process group of its own, so that it gets no signal but by this process, and each once.
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

[[noreturn]] void work_in_copy(const std::function<int(WorkerNote&)>& work, Shared& shared, pid_t parent) noexcept {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(EXIT_FAILURE);
  ::setpgid(0, 0);
  std::signal(SIGTTOU, SIG_IGN);  // it may write to the terminal all the same
  plugin::note_fatal_signals(shared.note.fatal);
  int code = EXIT_FAILURE;
  try {
    code = work(shared.note);
  } catch (const Disorder& disorder) {
    const std::string_view what = disorder.what();
    std::copy_n(what.data(), std::min(what.size(), shared.disorder.size() - 1), shared.disorder.data());
    std::fflush(nullptr);
    ::_exit(EXIT_FAILURE);
  } catch (const std::bad_alloc&) {
    constexpr std::string_view what = "no memory is left";
    std::copy_n(what.data(), what.size(), shared.disorder.data());
    ::_exit(EXIT_FAILURE);
  }
  shared.code = code;
  shared.done = 1;
  // At once: what a plugin has left to be done at the end of the program is not to be waited for.
  std::fflush(nullptr);
  ::_exit(code);
}

std::string in_words(int status) {
  if (WIFSTOPPED(status)) return "was stopped";
  if (WIFEXITED(status)) return fmt::format("ended the process (exit code {})", WEXITSTATUS(status));
  return strsignal(WTERMSIG(status));
}

// Whether the call under way has used up its time. Looked at every now and then.
class CallWatch {
 public:
  explicit CallWatch(const Limits& limits) : limits_(limits) {}
  // In words; empty while it has not.
  std::string look(const plugin::CallNote& call, pid_t process) {
    const double processor = processor_seconds_of(process);
    const auto now = std::chrono::steady_clock::now();
    if (call != call_ || call.inside == 0) {
      call_ = call;
      began_ = now;
      processor_at_call_ = processor;
      return {};
    }
    if (processor - processor_at_call_ > limits_.processor_seconds) {
      return fmt::format("used more than {} s of processor time", limits_.processor_seconds);
    }
    if (std::chrono::duration<double>(now - began_).count() > limits_.wall_seconds) {
      return fmt::format("did not return within {:.0f} s", limits_.wall_seconds);
    }
    return {};
  }

 private:
  const Limits& limits_;
  plugin::CallNote call_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  double processor_at_call_ = 0.0;
};

// Its descriptor becomes readable when the process ends; -1 where the system has none.
int descriptor_of(pid_t process) { return static_cast<int>(::syscall(SYS_pidfd_open, process, 0)); }

}  // namespace

StandardOutputKept::StandardOutputKept() : kept_(-1) {
  std::fflush(stdout);
  kept_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 10);
  if (kept_ != -1) ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

StandardOutputKept::~StandardOutputKept() {
  if (kept_ == -1) return;
  std::fflush(stdout);
  ::dup2(kept_, STDOUT_FILENO);
  ::close(kept_);
}

int run_supervised(const Limits& limits, const SupervisedWork& supervised) {
  void* const memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "cannot share memory");
  Shared& shared = *new (memory) Shared;
  std::fflush(nullptr);  // or both would write what waits to be written
  const pid_t parent = ::getpid();
  sigset_t held, before;
  sigemptyset(&held);
  for (const int each : passed_on) sigaddset(&held, each);
  sigprocmask(SIG_BLOCK, &held, &before);  // until it is known whom to tell
  const plugin::Descendants descendants;
  const pid_t process = ::fork();
  if (process == 0) {
    sigprocmask(SIG_SETMASK, &before, nullptr);
    work_in_copy(supervised.work, shared, parent);
  }
  if (process == -1) {
    sigprocmask(SIG_SETMASK, &before, nullptr);
    throw std::system_error(errno, std::generic_category(), "cannot start a process for the match");
  }
  ::setpgid(process, process);  // whoever of the two comes first
  copy = process;
  std::array<struct sigaction, passed_on.size()> old{};
  for (std::size_t i = 0; i < passed_on.size(); ++i) {
    struct sigaction action {};
    sigaction(passed_on[i], nullptr, &old[i]);
    if (old[i].sa_handler == SIG_IGN) continue;  // as nohup asks for
    action.sa_handler = pass_on;
    action.sa_flags = SA_RESTART;
    sigaction(passed_on[i], &action, nullptr);
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  const int descriptor = descriptor_of(process);
  CallWatch watch(limits);
  std::string too_long;
  int status = 0;
  for (;;) {
    const pid_t waited = ::waitpid(process, &status, WNOHANG | WUNTRACED);
    // The terminal's Ctrl-Z stops both, and `fg` wakes both.
    const bool stopped_by_terminal = waited == process && WIFSTOPPED(status) && WSTOPSIG(status) != SIGSTOP;
    if (waited == process && !stopped_by_terminal) break;
    pollfd watched{descriptor, POLLIN, 0};
    ::poll(&watched, 1, descriptor == -1 ? 10 : 100);
    if (too_long.empty()) {
      too_long = watch.look(shared.note.call, process);
      if (!too_long.empty()) ::kill(process, SIGKILL);
    }
  }
  if (descriptor != -1) ::close(descriptor);
  if (WIFSTOPPED(status)) {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }
  copy = 0;
  for (std::size_t i = 0; i < passed_on.size(); ++i) sigaction(passed_on[i], &old[i], nullptr);
  descendants.end_all();  // what plugins have started
  Loss loss{in_words(status), false, shared.note};
  shared.disorder.back() = '\0';
  const std::string disorder = shared.disorder.data();
  const bool done = shared.done == 1;
  const int code = shared.code;
  ::munmap(memory, sizeof(Shared));
  if (done) return code;
  if (received != 0) {
    // It was asked to end, and did not wait for a plugin; or it was asked twice, and said nothing.
    return supervised.interrupted(received, !WIFSIGNALED(status));
  }
  loss.note.call.plugin.back() = loss.note.call.call.back() = '\0';
  loss.note.fatal.thread.back() = loss.note.fatal.object.back() = '\0';
  if (!disorder.empty()) loss.what = disorder;
  loss.what += where(loss.note.fatal);
  if (!too_long.empty()) {
    loss.what = too_long;
    return supervised.lost(loss);
  }
  loss.from_outside = WIFSIGNALED(status) && comes_from_outside(WTERMSIG(status));
  return supervised.lost(loss);
}

}  // namespace regista::campaign
