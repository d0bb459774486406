// SPDX-License-Identifier: MIT
#include "check/process_watch.hpp"

#include <sys/wait.h>

#include <clocale>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

#include "plugin/floating_point_state.hpp"
#include "plugin/process_state.hpp"

namespace regista::check {
namespace {

std::vector<int> blocked_signals() {
  sigset_t set;
  ::sigprocmask(SIG_BLOCK, nullptr, &set);
  std::vector<int> out;
  for (int number = 1; number < NSIG; ++number) {
    if (::sigismember(&set, number) == 1) out.push_back(number);
  }
  return out;
}

bool has_children() {
  siginfo_t none{};
  return ::waitid(P_ALL, 0, &none, WEXITED | WNOHANG | WNOWAIT) == 0;
}

}  // namespace

Outcome leaving_the_process_alone(const std::function<Outcome()>& check) {
  const std::string locale = std::setlocale(LC_ALL, nullptr);
  const auto numbers = plugin::FloatingPointState::now();
  const auto before = plugin::ProcessState::now();
  const std::vector<int> blocked = blocked_signals();
  const bool had_children = has_children();
  Outcome out = check();
  const auto add = [&out](std::string line) {
    out.status = Status::fail;
    out.lines.push_back(std::move(line));
  };
  if (const std::string changed = plugin::FloatingPointState::now().changed_from(numbers); !changed.empty())
    add(changed);
  if (const std::string changed = plugin::changes_since(before); !changed.empty()) add(changed);
  if (blocked != blocked_signals()) add("changed which signals are blocked");
  if (!had_children && has_children()) add("left a process running");
  if (locale != std::setlocale(LC_ALL, nullptr)) add("changed the locale");
  return out;
}

}  // namespace regista::check
