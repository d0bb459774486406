// SPDX-License-Identifier: MIT
#include "process/watch.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <optional>
#include <sstream>

namespace regista::process {
namespace {

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

}  // namespace

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

}  // namespace regista::process
