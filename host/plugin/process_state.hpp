// SPDX-License-Identifier: MIT
// What of a process is everybody's: threads, child processes, file descriptors, working folder, locale, environment,
// handlers and mask of signals. Plugins are to leave it as it was. Functions that run at the end of the process are not
// among them: they cannot be told from destructors of static objects, and no process of a match runs them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace regista::plugin {

struct ProcessState {
  static ProcessState now();

  int threads = 1;
  int timers = 0;                // that will send a signal
  std::vector<int> descriptors;  // ascending
  std::uint64_t most_descriptors = 0;
  std::string folder, locale;
  std::array<std::uintptr_t, 65> handlers{};  // by signal
  std::vector<int> blocked;                   // signals, for this thread; ascending
  std::vector<std::string> environment;       // "NAME=VALUE", in alphabetical order
  unsigned file_mode = 0;                     // umask
  bool has_children = false;
};

// From now on what plugins start is found as a child of this process, even where its parent has ended.
void keep_orphans();

// What was changed in between, in words: "left 2 threads running, changed the working folder". Empty when nothing was.
std::string changes(const ProcessState& before, const ProcessState& after);

// Until now. The kernel may still list a thread for a moment that has been joined: it is waited for.
std::string changes_since(const ProcessState& before);

}  // namespace regista::plugin
