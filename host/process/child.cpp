// SPDX-License-Identifier: MIT
#include "process/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "process/descriptor.hpp"
#include "process/sanitized.hpp"

namespace regista::process {
namespace {

constexpr rlim_t small_stack = rlim_t{8} << 20;  // bytes
constexpr int lowest_spare = 10;                 // above the numbers that files are handed over under
constexpr std::size_t most_handed = 8;

bool limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  rlimit now{};
  if (::getrlimit(resource, &now) == -1) return false;
  const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  return ::setrlimit(resource, &wanted) == 0;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Out of the way of the numbers they are to have first, for any of them may be the number of another.
bool place_files(const Setting& setting) {
  std::array<HandedFile, most_handed + 3> wanted;
  std::size_t count = 0;
  for (const HandedFile& each : setting.files) wanted[count++] = each;
  if (!setting.keeps_streams) {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      const auto end = wanted.begin() + static_cast<std::ptrdiff_t>(count);
      if (std::none_of(wanted.begin(), end, [&](const HandedFile& each) { return each.to == stream; }))
        wanted[count++] = {HandedFile::nothing, stream};
    }
  }
  if (count == 0) return true;
  const int opened = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (opened == -1) return false;
  for (std::size_t i = 0; i < count; ++i) {
    const int from = wanted[i].from == HandedFile::nothing ? opened : wanted[i].from;
    wanted[i].from = ::fcntl(from, F_DUPFD_CLOEXEC, lowest_spare);
    if (wanted[i].from == -1) return false;
  }
  ::close(opened);
  for (std::size_t i = 0; i < count; ++i) {
    if (::dup2(wanted[i].from, wanted[i].to) == -1) return false;
    ::close(wanted[i].from);
  }
  return true;
}

// Starts a process. In the child it returns 0.
pid_t forked() {
  const pid_t process = ::fork();
  if (process == -1) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (process > 0) ::setpgid(process, process);  // whoever of the two comes first
  return process;
}

}  // namespace

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> out;
  for (const std::string& each : words) out.push_back(const_cast<char*>(each.c_str()));
  out.push_back(nullptr);
  return out;
}

bool set_limits(const Limits& limits) {
  if (!limits.core_file && !limit(RLIMIT_CORE, 0, 0)) return false;
  if (limits.small_stack && !limit(RLIMIT_STACK, small_stack, small_stack)) return false;
  const auto seconds = static_cast<rlim_t>(limits.processor_seconds);
  if (seconds > 0 && !limit(RLIMIT_CPU, seconds, seconds + 2)) return false;
  return limits.memory == 0 || addresses_are_reserved() || limit(RLIMIT_AS, limits.memory, limits.memory);
}

void limit_processor_time(int seconds) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  rlimit now{};
  ::getrlimit(RLIMIT_CPU, &now);
  const double until = seconds_of(used.ru_utime) + seconds_of(used.ru_stime) + seconds;
  now.rlim_cur = std::min(static_cast<rlim_t>(until), now.rlim_max);
  ::setrlimit(RLIMIT_CPU, &now);
}

void default_signals() {
  for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM, SIGPIPE, SIGXFSZ, SIGXCPU, SIGCHLD})
    std::signal(each, SIG_DFL);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

bool become_child(const Setting& setting, pid_t parent) {
  assert(setting.files.size() <= most_handed);
  ::setpgid(0, 0);
  if (!setting.outlives_parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) return false;  // it died before it could be watched
  }
  if (!place_files(setting) || !set_limits(setting.limits)) return false;
  if (!setting.keeps_signals) default_signals();
  return true;
}

bool ProcessEnd::was_stopped() const { return WIFSTOPPED(status); }

bool ProcessEnd::exited_with(int code) const { return WIFEXITED(status) && WEXITSTATUS(status) == code; }

std::optional<int> ProcessEnd::signal_number() const {
  return WIFSIGNALED(status) ? std::optional(WTERMSIG(status)) : std::nullopt;
}

bool ProcessEnd::from_outside() const {
  constexpr std::array sent{SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT};
  return WIFSIGNALED(status) && std::ranges::find(sent, WTERMSIG(status)) != sent.end();
}

std::string ProcessEnd::in_words() const {
  if (WIFSTOPPED(status)) return fmt::format("was stopped ({})", ::strsignal(WSTOPSIG(status)));
  if (WIFEXITED(status)) return fmt::format("ended the process (exit code {})", WEXITSTATUS(status));
  return ::strsignal(WTERMSIG(status));
}

std::string used_processor_time(int seconds) { return fmt::format("used more than {} s of processor time", seconds); }

std::string did_not_return(double wall_seconds) { return fmt::format("did not return within {:.0f} s", wall_seconds); }

Child::~Child() {
  if (process_ == -1) return;
  kill();
  while (::waitpid(process_, nullptr, 0) == -1 && errno == EINTR) {
  }
}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(process_, other.process_);
  std::swap(ends_group_, other.ends_group_);
  return *this;
}

Child Child::copy(const Setting& setting, const std::function<int()>& work) {
  const pid_t parent = ::getpid();
  const pid_t process = forked();
  if (process != 0) return Child(process);
  if (!become_child(setting, parent)) ::_exit(never_began);
  // Nothing that it throws may go on in what called this.
  ::_exit([&]() noexcept { return work(); }());
}

// Between fork and exec: only calls that are safe in a signal handler. Why a program can't be started comes back
// through a pipe that exec closes.
Child Child::program(const Setting& setting, const Program& program) {
  const std::vector<char*> words = pointers(program.words);
  char* const* const variables = program.variables ? program.variables->data() : environ;
  Pipe reason = make_pipe();
  ::fcntl(reason.read.number, F_SETFL, 0);
  reason.write = moved_up(std::move(reason.write), 64);
  const pid_t parent = ::getpid();
  const pid_t process = forked();
  if (process == 0) {
    errno = 0;
    if (become_child(setting, parent)) ::execvpe(program.file.c_str(), words.data(), variables);
    const int error = errno;
    (void)!::write(reason.write.number, &error, sizeof error);
    ::_exit(Child::never_began);
  }
  Child out(process);
  out.ends_group_ = !setting.outlives_parent;
  reason.write.reset();
  int error = 0;
  ssize_t count = 0;
  do {
    count = ::read(reason.read.number, &error, sizeof error);
  } while (count == -1 && errno == EINTR);
  if (count != sizeof error) return out;
  out.wait();
  throw std::system_error(error, std::generic_category(), "cannot start " + program.words.front());
}

std::optional<ProcessEnd> Child::reaped(int options) {
  assert(process_ != -1);
  int status = 0;
  rusage usage{};
  pid_t waited = -1;
  do {
    waited = ::wait4(process_, &status, options, &usage);
  } while (waited == -1 && errno == EINTR);
  if (waited == 0) return std::nullopt;
  if (waited == process_ && WIFSTOPPED(status)) return ProcessEnd{status, 0.0};
  const int error = errno;
  const pid_t process = std::exchange(process_, -1);
  if (waited == -1) throw std::system_error(error, std::generic_category(), "cannot wait for a process");
  if (ends_group_) ::kill(-process, SIGKILL);
  return ProcessEnd{status, seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime)};
}

std::optional<ProcessEnd> Child::look() { return process_ == -1 ? std::nullopt : reaped(WNOHANG | WUNTRACED); }

ProcessEnd Child::wait() { return *reaped(0); }

void Child::kill() const {
  // Itself, too: it may not have its group yet, or have gone to another.
  if (process_ == -1) return;
  ::kill(-process_, SIGKILL);
  ::kill(process_, SIGKILL);
}

}  // namespace regista::process
