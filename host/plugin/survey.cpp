// SPDX-License-Identifier: MIT
#include "plugin/survey.hpp"

#include <dirent.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "plugin/shared_object.hpp"
#include "process/child.hpp"
#include "process/descendants.hpp"
#include "process/descriptor.hpp"
#include "process/watch.hpp"
#include "texts/bytes.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int most_processor_seconds = 2;  // that opening one file may take
constexpr std::uint64_t most_memory = std::uint64_t{2} << 30;
constexpr double most_idle_seconds = 2.0;  // s, for a file that sleeps
constexpr double most_seconds = 10.0;      // s of wall time, on a machine that has much else to do
constexpr int patience = 100;              // ms between two looks at a child that says nothing
constexpr std::uint32_t most_bytes = 16u << 20;

// --- In the child ----------------------------------------------------------------------------------------------------

void put_frame(int pipe, const texts::BytesOut& frame) {
  const auto size = static_cast<std::uint32_t>(frame.bytes().size());
  std::array<std::uint8_t, sizeof size> head;
  std::memcpy(head.data(), &size, sizeof size);
  if (!process::write_all(pipe, head) || !process::write_all(pipe, frame.bytes())) ::_exit(1);
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

// Memory that copies of this process share and can write to.
int shared_mappings() {
  int count = 0;
  std::ifstream maps("/proc/self/maps");
  for (std::string line, range, rights; std::getline(maps, line);) {
    std::istringstream(line) >> range >> rights;
    if (rights.size() == 4 && rights[1] == 'w' && rights[3] == 's') ++count;
  }
  return count;
}

// What it may not leave behind when it has been opened; empty when it does not.
std::string left_running(int threads_before, int mappings_before) {
  // All robots of a match would share it, whose processes begin as copies of one that has opened the file.
  if (shared_mappings() > mappings_before) return "maps memory that processes share when it is opened";
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

// Returns the exit code.
int look(std::span<const fs::path> files, std::size_t first, int pipe) {
  const int threads_before = threads();
  for (std::size_t i = first; i < files.size(); ++i) {
    texts::BytesOut frame;
    const auto begun = static_cast<std::uint32_t>(i);
    frame(begun);
    put_frame(pipe, frame);
    process::limit_processor_time(1 + most_processor_seconds);
    const int mappings_before = shared_mappings();
    const SharedObject object = open_shared_object(files[i]);
    const std::string running = object.refusal.empty() ? left_running(threads_before, mappings_before) : "";
    const std::string refusal = running.empty() ? object.refusal : running;
    frame.clear();
    const std::string remark = object.remark;
    const auto count = static_cast<std::uint32_t>(object.descriptors.size());
    frame(begun, refusal, remark, count);
    for (const regista_descriptor* each : object.descriptors) Description(*each).write(frame);
    put_frame(pipe, frame);
    if (!running.empty()) break;  // the next file would be blamed for what is still there
  }
  return 0;
}

// --- In the parent ---------------------------------------------------------------------------------------------------

// A child that looks at files from `first` on, and what it says.
class Looker {
 public:
  Looker(std::span<const fs::path> files, std::size_t first) {
    process::Pipe answer = process::make_pipe();
    const process::Setting setting{.limits = {.memory = most_memory}};
    child_ = process::Child::copy(setting, [&] {
      answer.read.reset();
      return look(files, first, answer.write.number);
    });
    pipe_ = std::move(answer.read);
  }

  // The next frame; nothing when there is none any more, and why_not() then says why.
  std::optional<std::vector<std::uint8_t>> frame() {
    const auto deadline = Clock::now() + std::chrono::duration<double>(most_seconds);
    process::IdleProcess idle(child_.process());
    for (;;) {
      std::uint32_t size = 0;
      if (said_.size() >= sizeof size) {
        std::memcpy(&size, said_.data(), sizeof size);
        if (size > most_bytes) return std::nullopt;
        if (said_.size() >= sizeof size + size) {
          const auto begin = said_.begin() + sizeof size;
          std::vector<std::uint8_t> out(begin, begin + size);
          said_.erase(said_.begin(), begin + size);
          return out;
        }
      }
      if (!pipe_.is_open()) return std::nullopt;
      pollfd watched{pipe_.number, POLLIN, 0};
      if (::poll(&watched, 1, patience) == 1) {
        process::read_available(pipe_, [this](std::string_view piece) {
          said_ += piece;
          spoke_ = true;
        });
        continue;
      }
      idle_ = idle.idle_seconds() > most_idle_seconds;
      late_ = idle_ || Clock::now() > deadline;
      if (late_) return std::nullopt;
    }
  }

  // Ends the child. How it ended, in words. Throws std::system_error where it never looked at a file.
  std::string why_not() {
    const process::ProcessEnd end = ended();
    if (!spoke_ && end.exited_with(process::Child::never_began))
      throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again),
                              "no process can look at plugin files");
    hung_ = late_ || end.out_of_processor_time();
    killed_ = !ended_by_us_ && end.from_outside();
    if (idle_) return fmt::format("slept for {:.0f} s when it was opened", most_idle_seconds);
    if (late_) return fmt::format("could not be opened within {:.0f} s", most_seconds);
    if (end.out_of_processor_time())
      return process::used_processor_time(most_processor_seconds) + " when it was opened";
    if (end.signal_number()) return "died when it was opened: " + end.in_words();
    return fmt::format("ended the process when it was opened (exit code {})", WEXITSTATUS(end.status));
  }
  bool hung() const { return hung_; }      // that was why: it took too long
  bool killed() const { return killed_; }  // that was why: somebody else ended it, as a machine without memory does

 private:
  // It may have closed the pipe and live on: then its exit is not asked for.
  process::ProcessEnd ended() {
    ended_by_us_ = late_;
    if (late_) child_.kill();
    for (const auto deadline = Clock::now() + std::chrono::seconds(1); Clock::now() < deadline;) {
      const std::optional<process::ProcessEnd> end = child_.look();
      if (end && !end->was_stopped()) return *end;
      ::poll(nullptr, 0, 1);
    }
    ended_by_us_ = true;
    child_.kill();
    return child_.wait();
  }

  process::Child child_;
  process::FileDescriptor pipe_;
  std::string said_;  // of it, what has not been taken yet
  bool spoke_ = false, late_ = false, idle_ = false, hung_ = false, ended_by_us_ = false, killed_ = false;
};

Surveyed refused(const std::string& why) { return {{}, texts::one_line(why), {}}; }

enum class Looked {
  at_all,     // nothing went wrong
  until_one,  // out[...] of the file that was being opened says why; an earlier one may have damaged the process
  until_one_that_hung,  // the same, and it is that file's own doing: the earlier ones were found sound
  until_killed,         // the same, but it is nobody's doing
};

// Looks at files[first ... last).
Looked look_at(std::span<const fs::path> files, std::size_t first, std::vector<Surveyed>& out) {
  Looker child(files, first);
  std::size_t next = first;
  try {
    while (next < files.size()) {
      std::uint32_t index = 0;
      const auto begun = child.frame();
      const auto told = begun ? child.frame() : std::nullopt;
      if (!told) break;
      texts::BytesIn bytes(*told);
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
  if (child.killed()) return Looked::until_killed;
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
    if (look_at(files.subspan(i, 1), 0, one) == Looked::until_killed) look_at(files.subspan(i, 1), 0, one);
    out[i] = std::move(one.front());
  }
}

}  // namespace

std::vector<Surveyed> survey(std::span<const fs::path> files) {
  std::vector<Surveyed> out(files.size());
  if (files.empty()) return out;
  const process::Descendants descendants;
  look_at_each(files, out);
  descendants.end_all();
  return out;
}

}  // namespace regista::plugin
