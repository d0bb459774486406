// SPDX-License-Identifier: MIT
#include "plugin/idle_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace regista::plugin {
namespace {

struct Activity {
  char state = 'R';
  unsigned long long used = 0;
};

// proc(5): number, name in parentheses, state, ten fields, then the time in user mode and in the kernel. The name may
// hold anything.
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

double IdleProcess::idle_seconds() {
  const std::optional<Activity> now = activity_of(process_);
  const bool idle = now && now->state != 'R' && now->state != 'D' && now->used == used_;
  if (now) used_ = now->used;
  if (!idle) since_ = Clock::now();
  return std::chrono::duration<double>(Clock::now() - since_).count();
}

}  // namespace regista::plugin
