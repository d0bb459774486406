// SPDX-License-Identifier: MIT
#include "cli/supervised.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <system_error>

#include "campaign/process.hpp"
#include "cli/end_of_program.hpp"
#include "plugin/fatal_signal.hpp"

namespace regista::cli {
namespace {

// Memory that both processes see.
struct Shared {
  campaign::WorkerNote note;
  std::atomic<int> done{0};  // 1: `code` is the exit code of the work
  std::atomic<int> code{0};
};

constexpr std::array told_on{SIGINT, SIGTERM, SIGHUP};

// Handlers of signals take no arguments of ours.
std::atomic<pid_t> copy{0};
std::atomic<int> told{0};

// The terminal sends Ctrl-C to both; what was sent to this process alone is told on.
void tell_on(int signal_number, siginfo_t* info, void*) {
  told = signal_number;
  const pid_t process = copy;
  if (process > 0 && info->si_code == SI_USER) ::kill(process, signal_number);
}

[[noreturn]] void work_in_copy(const std::function<int(campaign::WorkerNote&)>& work, Shared& shared, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(exit_internal);
  plugin::note_fatal_signals(shared.note.fatal);
  int code = exit_internal;
  try {
    code = work(shared.note);
  } catch (...) {
    code = explain_current_exception();
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

}  // namespace

int run_supervised(const std::function<int(campaign::WorkerNote&)>& work, const std::function<int(const Loss&)>& lost) {
  void* const memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "cannot share memory");
  Shared& shared = *new (memory) Shared;
  std::fflush(nullptr);  // or both would write what waits to be written
  const pid_t parent = ::getpid();
  sigset_t held, before;
  sigemptyset(&held);
  for (const int each : told_on) sigaddset(&held, each);
  sigprocmask(SIG_BLOCK, &held, &before);  // until it is known whom to tell
  const pid_t process = ::fork();
  if (process == 0) {
    sigprocmask(SIG_SETMASK, &before, nullptr);
    work_in_copy(work, shared, parent);
  }
  if (process == -1) {
    sigprocmask(SIG_SETMASK, &before, nullptr);
    throw std::system_error(errno, std::generic_category(), "cannot start a process for the match");
  }
  copy = process;
  std::array<struct sigaction, told_on.size()> old{};
  for (std::size_t i = 0; i < told_on.size(); ++i) {
    struct sigaction action {};
    sigaction(told_on[i], nullptr, &old[i]);
    if (old[i].sa_handler == SIG_IGN) continue;  // as nohup asks for
    action.sa_sigaction = tell_on;
    action.sa_flags = SA_SIGINFO | SA_RESTART;
    sigaction(told_on[i], &action, nullptr);
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  int status = 0;
  for (;;) {
    const pid_t waited = ::waitpid(process, &status, WUNTRACED);
    if (waited == -1 && errno == EINTR) continue;
    // The terminal's Ctrl-Z stops both, and `fg` wakes both.
    if (waited == process && WIFSTOPPED(status) && WSTOPSIG(status) != SIGSTOP) continue;
    break;
  }
  if (WIFSTOPPED(status)) {
    ::kill(process, SIGKILL);
    ::waitpid(process, nullptr, 0);
  }
  copy = 0;
  for (std::size_t i = 0; i < told_on.size(); ++i) sigaction(told_on[i], &old[i], nullptr);
  Loss loss{in_words(status), false, shared.note};
  const bool done = shared.done == 1;
  const int code = shared.code;
  ::munmap(memory, sizeof(Shared));
  if (done) return code;
  if (told != 0) return exit_no;  // it was asked to end, and did not wait for a plugin
  loss.note.call.plugin.back() = loss.note.call.call.back() = '\0';
  loss.note.fatal.thread.back() = loss.note.fatal.object.back() = '\0';
  loss.what += where(loss.note.fatal);
  loss.from_outside = WIFSIGNALED(status) && campaign::comes_from_outside(WTERMSIG(status));
  return lost(loss);
}

}  // namespace regista::cli
