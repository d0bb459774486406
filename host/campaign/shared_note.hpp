// SPDX-License-Identifier: MIT
// What a worker notes in memory that it shares with its coordinator, so that it outlives the worker: the call that is
// under way, where a fatal signal struck, and the process groups it has started.
#pragma once

#include <sys/types.h>

#include <array>

#include "plugin/call_note.hpp"
#include "plugin/fatal_signal.hpp"

namespace regista::campaign {

// Plain bytes.
struct WorkerNote {
  plugin::CallNote call;
  plugin::FatalNote fatal;
  std::array<pid_t, 2> groups{};  // of the minds' processes of an isolated match, by side; 0: none
};

class SharedNote {
 public:
  // New, for a coordinator. Throws std::system_error.
  SharedNote();
  // A worker's view of one that it inherited, by its file descriptor. Throws std::system_error.
  explicit SharedNote(int descriptor);
  ~SharedNote();
  SharedNote(SharedNote&&) noexcept;
  SharedNote& operator=(SharedNote&&) = delete;

  WorkerNote& note() { return *note_; }
  const WorkerNote& note() const { return *note_; }
  int descriptor() const { return descriptor_; }  // closed at exec
  void clear() { *note_ = {}; }

 private:
  void map();
  int descriptor_;
  WorkerNote* note_ = nullptr;
};

}  // namespace regista::campaign
