// SPDX-License-Identifier: MIT
#include "process/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>
#include <sstream>
#include <system_error>

#include "process/file_descriptor.hpp"
#include "process/sanitized.hpp"

namespace regista::process {
namespace {

constexpr rlim_t small_stack = rlim_t{8} << 20;  // bytes
constexpr int lowest_spare = 10;  // lowest descriptor for duplicates; above all target numbers of handed files
constexpr std::size_t most_handed = 8;

bool limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  rlimit now{};
  if (::getrlimit(resource, &now) == -1) return false;
  const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  return ::setrlimit(resource, &wanted) == 0;
}

bool set_limits(const Limits& limits) {
  if (!limits.core_file && !limit(RLIMIT_CORE, 0, 0)) return false;
  if (limits.small_stack && !limit(RLIMIT_STACK, small_stack, small_stack)) return false;
  const auto seconds = static_cast<rlim_t>(limits.processor_seconds);
  if (seconds > 0 && !limit(RLIMIT_CPU, seconds, seconds + 2)) return false;
  return limits.memory == 0 || addresses_are_reserved() || limit(RLIMIT_AS, limits.memory, limits.memory);
}

// Returns the used processor time, s.
double used_by(const rusage& usage) {
  const auto seconds_of = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

// Gives each file its number in the child. Copies all files to high numbers first, because the numbers may be in use.
bool place_files(const Setting& setting) {
  std::array<HandedFile, most_handed + 3> wanted;
  std::size_t count = 0;
  for (const HandedFile& each : setting.files) wanted[count++] = each;
  if (!setting.keeps_streams) {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
      if (std::ranges::find(setting.files, stream, &HandedFile::to) == setting.files.end())
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

// Starts a process. Returns 0 in the child.
pid_t forked() {
  const pid_t process = ::fork();
  if (process == -1) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (process > 0) ::setpgid(process, process);  // parent and child both call setpgid(); the first call takes effect
  return process;
}

std::vector<pid_t> children() {
  std::vector<pid_t> out;
  std::ifstream list("/proc/thread-self/children");
  for (pid_t child = 0; list >> child;) out.push_back(child);
  return out;
}

bool holds(std::span<const pid_t> all, pid_t one) { return std::ranges::find(all, one) != all.end(); }

using Clock = std::chrono::steady_clock;

// Reads output and errors of the program until it has closed the pipes of both. Returns false after a timeout.
bool read_both(const ProgramCall& call, FileDescriptor& output, FileDescriptor& errors, ProgramEnd& out) {
  const auto begin = Clock::now();
  const auto append_to = [&](std::string& text) {
    return [&text, &call](std::string_view piece) {
      text.append(piece.substr(0, call.longest_text - std::min(call.longest_text, text.size())));
    };
  };
  while (output.is_open() || errors.is_open()) {
    int wait = -1;
    if (call.patience) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(begin + *call.patience - Clock::now());
      if (left.count() <= 0) return false;
      wait = static_cast<int>(left.count());
    }
    std::array<pollfd, 2> ends{{{output.number, POLLIN, 0}, {errors.number, POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), wait) <= 0) continue;  // a signal interrupted poll(), or the time is over
    if (ends[0].revents != 0) read_available(output, append_to(out.output));
    if (ends[1].revents != 0) read_available(errors, append_to(out.errors));
  }
  return true;
}

struct Activity {
  char state = 'R';
  unsigned long long used = 0;
};

// The format is that of proc(5): number, name in parentheses (any characters), state, ten fields, user and kernel time.
std::optional<Activity> activity_of(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string line;
  if (!std::getline(file, line) || line.rfind(')') == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(line.rfind(')') + 1));
  Activity out;
  std::string skipped;
  unsigned long long user = 0, kernel = 0;
  fields >> out.state;
  for (int i = 0; i < 10; ++i) fields >> skipped;
  if (!(fields >> user >> kernel)) return std::nullopt;
  out.used = user + kernel;
  return out;
}

std::string quoted(const std::string& word) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + '\'';
}

}  // namespace

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> out;
  for (const std::string& each : words) out.push_back(const_cast<char*>(each.c_str()));
  out.push_back(nullptr);
  return out;
}

void limit_processor_time(int seconds) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  rlimit now{};
  ::getrlimit(RLIMIT_CPU, &now);
  now.rlim_cur = std::min(static_cast<rlim_t>(used_by(used) + seconds), now.rlim_max);
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
    if (::getppid() != parent) return false;  // the parent died before PR_SET_PDEATHSIG
  }
  if (!place_files(setting) || !set_limits(setting.limits)) return false;
  if (!setting.keeps_signals) default_signals();
  return true;
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
  uninterrupted([this] { return ::waitpid(process_, nullptr, 0); });
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
  // With noexcept, an exception of `work` ends this process and does not reach the caller of copy().
  ::_exit([&]() noexcept { return work(); }());
}

// Between fork() and exec(), the child makes only calls that are safe in a signal handler. If the start fails, the
// child writes the error to a pipe, which a successful exec() closes.
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
  if (uninterrupted([&] { return ::read(reason.read.number, &error, sizeof error); }) != sizeof error) return out;
  out.wait();
  throw std::system_error(error, std::generic_category(), "cannot start " + program.words.front());
}

std::optional<ProcessEnd> Child::reaped(int options) {
  assert(process_ != -1);
  int status = 0;
  rusage usage{};
  const pid_t waited = uninterrupted([&] { return ::wait4(process_, &status, options, &usage); });
  if (waited == 0) return std::nullopt;
  if (waited == process_ && WIFSTOPPED(status)) return ProcessEnd{status, 0.0};
  const int error = errno;
  const pid_t process = std::exchange(process_, -1);
  if (waited == -1) throw std::system_error(error, std::generic_category(), "cannot wait for a process");
  if (ends_group_) ::kill(-process, SIGKILL);
  return ProcessEnd{status, used_by(usage)};
}

std::optional<ProcessEnd> Child::look() { return process_ == -1 ? std::nullopt : reaped(WNOHANG | WUNTRACED); }

ProcessEnd Child::wait() { return *reaped(0); }

void Child::kill() const {
  // Kills the process itself, too, because the process may not have joined its group yet, or may have left it.
  if (process_ == -1) return;
  ::kill(-process_, SIGKILL);
  ::kill(process_, SIGKILL);
}

Descendants::Descendants() : strangers_(children()), groups_{::getpgrp()} {
  for (const pid_t each : strangers_) {
    if (const pid_t group = ::getpgid(each); group > 0) groups_.push_back(group);
  }
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
}

void Descendants::end_all_but(std::span<const pid_t> those) const {
  // Repeats the search, because the children of a killed process become children of this process.
  for (int round = 0; round < 100; ++round) {
    bool found = false;
    for (const pid_t child : children()) {
      if (holds(those, child) || holds(strangers_, child) || holds(groups_, ::getpgid(child))) continue;
      found = true;
      ::kill(child, SIGKILL);
      ::waitpid(child, nullptr, 0);
    }
    if (!found) return;
  }
}

double processor_seconds_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::uint64_t address_space_of(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/statm", process));
  std::uint64_t pages = 0;
  file >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

double IdleProcess::idle_seconds() {
  const std::optional<Activity> now = activity_of(process_);
  const bool idle = now && now->state != 'R' && now->state != 'D' && now->used == used_;
  if (now) used_ = now->used;
  if (!idle) since_ = Clock::now();
  return std::chrono::duration<double>(Clock::now() - since_).count();
}

void KeptOutput::add(std::string_view text) {
  const std::size_t room = most_each - first_.size();
  first_.append(text.substr(0, room));
  text.remove_prefix(std::min(room, text.size()));
  last_.append(text);
  if (last_.size() <= most_each) return;
  const std::size_t too_many = last_.size() - most_each;
  left_out_ += too_many;
  last_.erase(0, too_many);
}

std::string KeptOutput::text() const {
  if (left_out_ == 0) return first_ + last_;
  return fmt::format("{}\n[{} bytes are left out]\n{}", first_, left_out_, last_);
}

ProgramEnd run_program(const ProgramCall& call) {
  ProgramEnd out;
  Pipe output = make_pipe(), errors = make_pipe();
  Setting setting{.files = {{output.write.number, 1}, {errors.write.number, 2}},
                  .limits = {.core_file = true},
                  .outlives_parent = true};
  Child running;
  try {
    running = Child::program(setting, {call.words.front(), call.words, std::nullopt});
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::no_such_file_or_directory) throw;
    out.found = false;
    return out;
  }
  output.write.reset();
  errors.write.reset();
  out.in_time = read_both(call, output.read, errors.read, out);
  if (!out.in_time) running.kill();
  out.end = running.wait();
  return out;
}

std::string shell_line(const std::vector<std::string>& words) {
  std::vector<std::string> out;
  for (const std::string& word : words) out.push_back(quoted(word));
  return fmt::format("{}", fmt::join(out, " "));
}

std::string command_line(const std::vector<std::string>& words) {
  return words.empty() ? "regista" : "regista " + shell_line(words);
}

}  // namespace regista::process
