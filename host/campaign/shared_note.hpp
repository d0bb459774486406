// SPDX-License-Identifier: MIT
// A plugin::CallNote in memory that coordinator and worker share, so that it outlives the worker.
#pragma once

#include "plugin/call_note.hpp"

namespace regista::campaign {

class SharedNote {
 public:
  // New, for a coordinator. Throws std::system_error.
  SharedNote();
  // A worker's view of one that it inherited, by its file descriptor. Throws std::system_error.
  explicit SharedNote(int descriptor);
  ~SharedNote();
  SharedNote(SharedNote&&) noexcept;
  SharedNote& operator=(SharedNote&&) = delete;

  plugin::CallNote& note() { return *note_; }
  const plugin::CallNote& note() const { return *note_; }
  int descriptor() const { return descriptor_; }  // closed at exec
  void clear() { *note_ = {}; }

 private:
  void map();
  int descriptor_;
  plugin::CallNote* note_ = nullptr;
};

}  // namespace regista::campaign
