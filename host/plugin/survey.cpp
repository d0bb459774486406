// SPDX-License-Identifier: MIT
#include "plugin/survey.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "config/bytes.hpp"
#include "config/sanitized.hpp"
#include "config/text.hpp"
#include "plugin/descendants.hpp"
#include "plugin/idle_process.hpp"
#include "plugin/shared_object.hpp"

namespace regista::plugin {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr rlim_t most_processor_seconds = 2;  // that opening one file may take
constexpr rlim_t most_memory = rlim_t{2} << 30;
constexpr double most_idle_seconds = 2.0;  // s, for a file that sleeps
constexpr double most_seconds = 10.0;      // s of wall time, on a machine that has much else to do
constexpr int patience = 100;              // ms between two looks at a child that says nothing
constexpr std::uint32_t most_bytes = 16u << 20;

// --- In the child ----------------------------------------------------------------------------------------------------

void put(int pipe, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(pipe, bytes.data(), bytes.size());
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) _exit(1);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void put_frame(int pipe, const config::BytesOut& frame) {
  const auto size = static_cast<std::uint32_t>(frame.bytes().size());
  std::array<std::uint8_t, sizeof size> head;
  std::memcpy(head.data(), &size, sizeof size);
  put(pipe, head);
  put(pipe, frame.bytes());
}

int threads() {
  int count = 0;
  DIR* const folder = ::opendir("/proc/self/task");
  if (folder == nullptr) return 1;
  while (const dirent* entry = ::readdir(folder)) {
    if (entry->d_name[0] != '.') ++count;
  }
  ::closedir(folder);
  return count;
}

// What it may not leave behind when it has been opened; empty when it does not.
std::string left_running(int threads_before) {
  // One that has been joined may still be listed for a moment.
  for (int i = 0; threads() > threads_before; ++i) {
    if (i == 20) return "starts a thread when it is opened";
    ::usleep(5000);
  }
  for (const __itimer_which timer : {ITIMER_REAL, ITIMER_VIRTUAL, ITIMER_PROF}) {
    itimerval now{};
    if (::getitimer(timer, &now) == 0 && (now.it_value.tv_sec != 0 || now.it_value.tv_usec != 0))
      return "starts a timer when it is opened";
  }
  return {};
}

void limit_processor_time() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  const rlim_t used = static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec);
  rlimit limit{};
  ::getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = std::min(used + 1 + most_processor_seconds, limit.rlim_max);
  ::setrlimit(RLIMIT_CPU, &limit);
}

void limit_memory() {
  if (addresses_are_reserved()) return;  // more than there is memory
  rlimit limit{};
  ::getrlimit(RLIMIT_AS, &limit);
  limit.rlim_cur = std::min(most_memory, limit.rlim_max);
  ::setrlimit(RLIMIT_AS, &limit);
}

[[noreturn]] void look(std::span<const fs::path> files, std::size_t first, int pipe, pid_t parent) noexcept {
  ::setpgid(0, 0);  // a signal to the group of a plugin is not for us
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) _exit(1);
  // What it prints when it is opened is no answer of ours.
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, standard);
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  limit_memory();
  for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGPIPE, SIGXCPU}) std::signal(each, SIG_DFL);
  const int threads_before = threads();
  for (std::size_t i = first; i < files.size(); ++i) {
    config::BytesOut frame;
    const auto begun = static_cast<std::uint32_t>(i);
    frame(begun);
    put_frame(pipe, frame);
    limit_processor_time();
    const SharedObject object = open_shared_object(files[i]);
    const std::string running = object.refusal.empty() ? left_running(threads_before) : "";
    const std::string refusal = running.empty() ? object.refusal : running;
    frame.clear();
    const std::string remark = object.remark;
    const auto count = static_cast<std::uint32_t>(object.descriptors.size());
    frame(begun, refusal, remark, count);
    for (const regista_descriptor* each : object.descriptors) Description(*each).write(frame);
    put_frame(pipe, frame);
    if (!running.empty()) break;  // the next file would be blamed for what is still there
  }
  _exit(0);
}

// --- In the parent ---------------------------------------------------------------------------------------------------

// A child that looks at files from `first` on, and what it says.
class Child {
 public:
  Child(std::span<const fs::path> files, std::size_t first) {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) == -1) throw std::system_error(errno, std::generic_category(), "pipe");
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ == 0) {
      ::close(ends[0]);
      look(files, first, ends[1], parent);
    }
    const int code = errno;
    ::close(ends[1]);
    pipe_ = ends[0];
    if (process_ == -1) {
      ::close(pipe_);
      throw std::system_error(code, std::generic_category(), "cannot look at plugins");
    }
    ::setpgid(process_, process_);  // whoever of the two comes first
  }
  ~Child() {
    ::close(pipe_);
    if (process_ != -1) end();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // The next frame; nothing when there is none any more, and why_not() then says why.
  std::optional<std::vector<std::uint8_t>> frame() {
    std::uint32_t size = 0;
    std::vector<std::uint8_t> out(sizeof size);
    if (!fill(out)) return std::nullopt;
    std::memcpy(&size, out.data(), sizeof size);
    if (size > most_bytes) return std::nullopt;
    out.resize(size);
    if (!fill(out)) return std::nullopt;
    return out;
  }

  // Ends the child. How it ended, in words.
  std::string why_not() {
    const int status = end();
    hung_ = late_ || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU);
    if (idle_) return fmt::format("slept for {:.0f} s when it was opened", most_idle_seconds);
    if (late_) return fmt::format("could not be opened within {:.0f} s", most_seconds);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
      return fmt::format("took more than {} s of processor time when it was opened", most_processor_seconds);
    }
    if (WIFSIGNALED(status)) return fmt::format("died when it was opened: {}", strsignal(WTERMSIG(status)));
    return fmt::format("ended the process when it was opened (exit code {})", WEXITSTATUS(status));
  }
  bool hung() const { return hung_; }  // that was why: it took too long

 private:
  bool fill(std::span<std::uint8_t> room) {
    const auto deadline = Clock::now() + std::chrono::duration<double>(most_seconds);
    IdleProcess idle(process_);
    while (!room.empty()) {
      pollfd watched{pipe_, POLLIN, 0};
      const int ready = ::poll(&watched, 1, patience);
      if (ready == -1 && errno == EINTR) continue;
      if (ready == 0) {
        idle_ = idle.idle_seconds() > most_idle_seconds;
        late_ = idle_ || Clock::now() > deadline;
        if (late_) return false;
        continue;
      }
      const ssize_t count = ::read(pipe_, room.data(), room.size());
      if (count == -1 && errno == EINTR) continue;
      if (count <= 0) return false;
      room = room.subspan(static_cast<std::size_t>(count));
    }
    return true;
  }

  int end() {
    int status = 0;
    // It may have closed the pipe and live on: then this ends it, and its exit is not asked for.
    if (late_) ::kill(-process_, SIGKILL);
    const auto deadline = Clock::now() + std::chrono::seconds(1);
    while (::waitpid(process_, &status, WNOHANG) == 0) {
      if (Clock::now() > deadline) ::kill(-process_, SIGKILL);
      ::poll(nullptr, 0, 1);
    }
    ::kill(-process_, SIGKILL);  // what a plugin may have started
    process_ = -1;
    return status;
  }

  pid_t process_ = -1;
  int pipe_ = -1;
  bool late_ = false, idle_ = false, hung_ = false;
};

Surveyed refused(const std::string& why) { return {{}, config::one_line(why), {}}; }

enum class Looked {
  at_all,     // nothing went wrong
  until_one,  // out[...] of the file that was being opened says why; an earlier one may have damaged the process
  until_one_that_hung,  // the same, and it is that file's own doing: the earlier ones were found sound
};

// Looks at files[first ... last).
Looked look_at(std::span<const fs::path> files, std::size_t first, std::vector<Surveyed>& out) {
  Child child(files, first);
  std::size_t next = first;
  try {
    while (next < files.size()) {
      std::uint32_t index = 0;
      const auto begun = child.frame();
      const auto told = begun ? child.frame() : std::nullopt;
      if (!told) break;
      config::BytesIn bytes(*told);
      Surveyed found;
      std::uint32_t count = 0;
      bytes(index, found.refusal, found.remark, count);
      if (index != next) throw std::out_of_range("another file");
      for (std::uint32_t i = 0; i < count; ++i) found.plugins.push_back(std::make_shared<const Description>(bytes));
      if (!found.refusal.empty()) found.plugins.clear();
      out[next++] = std::move(found);
    }
  } catch (const std::out_of_range&) {
    out[next] = refused("wrote to a file descriptor that is not its own when it was opened");
    return Looked::until_one;
  }
  if (next == files.size()) return Looked::at_all;
  const bool sound_so_far = std::all_of(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(next),
                                        [](const Surveyed& each) { return each.refusal.empty(); });
  out[next] = refused(child.why_not());
  return child.hung() && sound_so_far ? Looked::until_one_that_hung : Looked::until_one;
}

// What is said of each; all by one child, and each by one of its own where one ends it.
void look_at_each(std::span<const fs::path> files, std::vector<Surveyed>& out) {
  const Looked looked = look_at(files, 0, out);
  if (looked == Looked::at_all) return;
  // Nobody waits twice for the same file.
  const auto hung = looked == Looked::until_one_that_hung
                        ? std::ranges::find_if(out, [](const Surveyed& each) { return !each.refusal.empty(); })
                        : out.end();
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (out.begin() + static_cast<std::ptrdiff_t>(i) == hung) continue;
    std::vector<Surveyed> one(1);
    look_at(files.subspan(i, 1), 0, one);
    out[i] = std::move(one.front());
  }
}

}  // namespace

std::vector<Surveyed> survey(std::span<const fs::path> files) {
  std::vector<Surveyed> out(files.size());
  if (files.empty()) return out;
  const Descendants descendants;
  look_at_each(files, out);
  descendants.end_all();
  return out;
}

}  // namespace regista::plugin
