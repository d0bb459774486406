// SPDX-License-Identifier: MIT
// What of a process is everybody's: threads, file descriptors, working folder, handlers of signals. Plugins are to
// leave it as it was.
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
  std::string folder;
  std::array<std::uintptr_t, 65> handlers{};  // by signal
};

// What was changed in between, in words: "left 2 threads running, changed the working folder". Empty when nothing was.
std::string changes(const ProcessState& before, const ProcessState& after);

// Until now. The kernel may still list a thread for a moment that has been joined: it is waited for.
std::string changes_since(const ProcessState& before);

}  // namespace regista::plugin
