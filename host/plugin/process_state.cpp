// SPDX-License-Identifier: MIT
#include "plugin/process_state.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <clocale>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "plugin/address_ranges.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

namespace fs = std::filesystem;

// Names that are numbers: those of threads, of descriptors.
std::vector<int> numbers_in(const char* folder) {
  std::vector<int> out;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    int number = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), number).ec == std::errc()) out.push_back(number);
  }
  std::ranges::sort(out);
  return out;
}

// The folder is read through a descriptor of its own, which is gone by now.
std::vector<int> open_descriptors() {
  std::vector<int> out;
  for (const int each : numbers_in("/proc/self/fd")) {
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(fmt::format("/proc/self/fd/{}", each), error))) out.push_back(each);
  }
  return out;
}

int running_timers() {
  int out = 0;
  for (const __itimer_which each : {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF}) {
    itimerval now{};
    if (getitimer(each, &now) == 0 && (now.it_value.tv_sec != 0 || now.it_value.tv_usec != 0)) ++out;
  }
  std::ifstream list("/proc/self/timers");  // those of timer_create(); not every kernel has it
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with("ID:")) ++out;
  }
  return out;
}

template <class T>
std::vector<T> without(const std::vector<T>& all, const std::vector<T>& those) {
  std::vector<T> out;
  std::ranges::set_difference(all, those, std::back_inserter(out));
  return out;
}

std::vector<int> blocked_signals() {
  sigset_t set;
  ::pthread_sigmask(SIG_BLOCK, nullptr, &set);
  std::vector<int> out;
  for (int number = 1; number < NSIG; ++number) {
    if (::sigismember(&set, number) == 1) out.push_back(number);
  }
  return out;
}

std::vector<std::string> variables() {
  std::vector<std::string> out;
  for (char** each = environ; each != nullptr && *each != nullptr; ++each) out.emplace_back(*each);
  std::ranges::sort(out);
  return out;
}

// Names of variables whose values differ, or that are there only once.
std::vector<std::string> changed_variables(const ProcessState& before, const ProcessState& after) {
  std::vector<std::string> out = without(before.environment, after.environment);
  const std::vector<std::string> fresh = without(after.environment, before.environment);
  out.insert(out.end(), fresh.begin(), fresh.end());
  for (std::string& each : out) each.resize(std::min(each.find('='), each.size()));
  std::ranges::sort(out);
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

unsigned present_file_mode() {
  const mode_t mode = ::umask(0);
  ::umask(mode);
  return mode;
}

bool has_children_now() {
  siginfo_t none{};
  return ::waitid(P_ALL, 0, &none, WEXITED | WNOHANG | WNOWAIT | __WALL) == 0;
}

std::string signal_name(int number) {
  const char* const name = sigabbrev_np(number);
  return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", number);
}

}  // namespace

ProcessState ProcessState::now() {
  ProcessState out;
  out.threads = static_cast<int>(numbers_in("/proc/self/task").size());
  out.timers = running_timers();
  out.descriptors = open_descriptors();
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  out.most_descriptors = files.rlim_cur;
  std::error_code error;
  out.folder = fs::current_path(error).string();
  for (int number = 1; number < static_cast<int>(out.handlers.size()); ++number) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0) continue;
    const auto handler = (action.sa_flags & SA_SIGINFO) != 0 ? reinterpret_cast<std::uintptr_t>(action.sa_sigaction)
                                                             : reinterpret_cast<std::uintptr_t>(action.sa_handler);
    out.handlers[static_cast<std::size_t>(number)] = handler;
  }
  out.locale = std::setlocale(LC_ALL, nullptr);
  out.blocked = blocked_signals();
  out.environment = variables();
  out.file_mode = present_file_mode();
  out.has_children = has_children_now();
  return out;
}

void keep_orphans() { ::prctl(PR_SET_CHILD_SUBREAPER, 1); }

std::string changes(const ProcessState& before, const ProcessState& after) {
  std::vector<std::string> out;
  if (const int more = after.threads - before.threads; more > 0) {
    out.push_back(
        fmt::format("left {} running", texts::counted(static_cast<std::uint64_t>(more), "thread", "threads")));
  }
  if (after.has_children && !before.has_children) out.push_back("left a process running");
  if (after.timers > before.timers) out.push_back("left a timer running");
  if (before.most_descriptors != after.most_descriptors) {
    out.push_back("changed the limit of open files");
  } else if (const auto closed = without(before.descriptors, after.descriptors); !closed.empty()) {
    out.push_back(fmt::format("closed file descriptor{} {}", closed.size() == 1 ? "" : "s", fmt::join(closed, ", ")));
  }
  if (const auto open = without(after.descriptors, before.descriptors); !open.empty()) {
    out.push_back(open.size() == 1 ? fmt::format("left file descriptor {} open", open.front())
                                   : fmt::format("left {} file descriptors open", open.size()));
  }
  if (before.folder != after.folder) out.push_back("changed the working folder");
  if (before.locale != after.locale) out.push_back("changed the locale");
  if (const auto changed = changed_variables(before, after); !changed.empty()) {
    out.push_back(changed.size() == 1
                      ? fmt::format("changed the environment variable {}", texts::in_quotes(changed.front()))
                      : fmt::format("changed {} variables of the environment", changed.size()));
  }
  if (before.file_mode != after.file_mode) out.push_back("changed the mode of new files (umask)");
  if (before.blocked != after.blocked) out.push_back("changed which signals are blocked");
  for (std::size_t number = 1; number < before.handlers.size(); ++number) {
    if (before.handlers[number] == after.handlers[number]) continue;
    const ObjectName* const object = object_at(after.handlers[number]);
    out.push_back(fmt::format("changed the handler of {}{}", signal_name(static_cast<int>(number)),
                              object == nullptr ? "" : fmt::format(" to one in {}", object->data())));
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

std::string changes_since(const ProcessState& before) {
  ProcessState now = ProcessState::now();
  for (int i = 0; i < 20 && now.threads > before.threads; ++i) {
    usleep(5000);
    now = ProcessState::now();
  }
  return changes(before, now);
}

}  // namespace regista::plugin
