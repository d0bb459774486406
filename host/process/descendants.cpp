// SPDX-License-Identifier: MIT
#include "process/descendants.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

namespace regista::process {
namespace {

std::vector<pid_t> children() {
  std::vector<pid_t> out;
  std::ifstream list("/proc/thread-self/children");
  for (pid_t child = 0; list >> child;) out.push_back(child);
  return out;
}

bool holds(std::span<const pid_t> all, pid_t one) { return std::ranges::find(all, one) != all.end(); }

}  // namespace

Descendants::Descendants() : strangers_(children()), groups_{::getpgrp()} {
  for (const pid_t each : strangers_) {
    if (const pid_t group = ::getpgid(each); group > 0) groups_.push_back(group);
  }
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
}

void Descendants::end_all_but(std::span<const pid_t> those) const {
  // Killing one may hand over its own children.
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

}  // namespace regista::process
