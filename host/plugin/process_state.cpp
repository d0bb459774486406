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
#include <system_error>

#include "plugin/fatal_signal.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

constexpr const char* rounding_changed = "changed the rounding mode";
constexpr const char* small_numbers = "changed how small numbers are treated (flush to zero)";
constexpr const char* exceptions = "unmasked floating-point exceptions";

namespace fs = std::filesystem;

// Returns the names in a folder that are numbers, such as thread ids or descriptors.
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

// Returns the open descriptors, without the descriptor that numbers_in() used to read the folder and has closed.
std::vector<int> open_descriptors() {
  std::vector<int> out;
  for (const int each : numbers_in("/proc/self/fd")) {
    std::error_code error;
    if (fs::is_symlink(fs::symlink_status(fmt::format("/proc/self/fd/{}", each), error))) out.push_back(each);
  }
  return out;
}

int running_timers() {
  int out = interval_timers();
  std::ifstream list("/proc/self/timers");  // lists the timers of timer_create(); some kernels lack this file
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

// Returns the names of environment variables that `before` and `after` have with different values, or only one of them.
std::vector<std::string> changed_variables(const ProcessState& before, const ProcessState& after) {
  std::vector<std::string> out;
  std::ranges::set_symmetric_difference(before.environment, after.environment, std::back_inserter(out));
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

#if defined(__x86_64__)

// Intel 64 and IA-32 Architectures Software Developer's Manual, volume 1, describes the bits of MXCSR (section 10.2.3)
// and the bits of the x87 control word (section 8.1.5).
void FloatingPointState::restore() const {
  const auto x87 = static_cast<std::uint16_t>(x87_);
  // Clears pending exceptions. Otherwise the next instruction would raise the exceptions that the new state reports.
  __asm__ volatile("fnclex\n\tfldcw %0" : : "m"(x87));
  _mm_setcsr(sse_);
}

std::string FloatingPointState::changed_from(const FloatingPointState& earlier) const {
  const std::uint32_t sse = sse_ ^ earlier.sse_, x87 = x87_ ^ earlier.x87_;
  if ((sse & 0x6000) != 0 || (x87 & 0x0c00) != 0) return rounding_changed;
  if ((sse & 0x8040) != 0) return small_numbers;
  if ((sse & 0x1f80) != 0 || (x87 & 0x003f) != 0) {
    const bool fewer = (sse & earlier.sse_ & 0x1f80) != 0 || (x87 & earlier.x87_ & 0x003f) != 0;
    return fewer ? exceptions : "masked floating-point exceptions";
  }
  if ((x87 & 0x0300) != 0) return "changed the precision of floating-point arithmetic";
  return sse != 0 || x87 != 0 ? "changed the floating-point environment" : "";
}

#else

// Returns whether the processor sets denormal numbers to zero. No portable function returns this setting.
static bool flushes_to_zero() {
  volatile double least = std::numeric_limits<double>::min();
  least = least / 2;
  return least == 0.0;
}

std::uint32_t FloatingPointState::difference_for_numbers() {
  return std::fegetround() == FE_TONEAREST && !flushes_to_zero() ? 0 : 1;
}

FloatingPointState FloatingPointState::now() {
  FloatingPointState out;
  out.rounding_ = std::fegetround();
#if defined(__GLIBC__)
  out.unmasked_ = fegetexcept();
#endif
  out.flushes_ = flushes_to_zero();
  return out;
}

void FloatingPointState::restore() const {
  // Sets the default environment of the C library first, because no portable function sets only the flushing to zero.
  if (flushes_to_zero() != flushes_) std::fesetenv(FE_DFL_ENV);
  std::fesetround(rounding_);
#if defined(__GLIBC__)
  fedisableexcept(FE_ALL_EXCEPT);
  feenableexcept(unmasked_);
#endif
}

std::string FloatingPointState::changed_from(const FloatingPointState& earlier) const {
  if (rounding_ != earlier.rounding_) return rounding_changed;
  if (flushes_ != earlier.flushes_) return small_numbers;
  return unmasked_ != earlier.unmasked_ ? exceptions : "";
}

#endif

int running_threads() { return static_cast<int>(numbers_in("/proc/self/task").size()); }

int interval_timers() {
  return static_cast<int>(std::ranges::count_if(std::array{ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF}, [](auto each) {
    itimerval now{};
    return getitimer(each, &now) == 0 && (now.it_value.tv_sec != 0 || now.it_value.tv_usec != 0);
  }));
}

ProcessState ProcessState::now() {
  ProcessState out;
  out.threads = running_threads();
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
    out.push_back(fmt::format("left {} running", texts::plural(static_cast<std::uint64_t>(more), "thread", "threads")));
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
