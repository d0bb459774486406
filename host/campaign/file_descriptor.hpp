// SPDX-License-Identifier: MIT
// A file descriptor that is closed at the end.
#pragma once

#include <unistd.h>

#include <utility>

namespace regista::campaign {

struct FileDescriptor {
  int number = -1;  // -1: none

  FileDescriptor() = default;
  explicit FileDescriptor(int opened) : number(opened) {}
  ~FileDescriptor() { reset(); }
  FileDescriptor(FileDescriptor&& other) noexcept : number(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    reset(other.release());
    return *this;
  }

  // To somebody else, who closes it.
  int release() { return std::exchange(number, -1); }
  void reset(int opened = -1) {
    if (number != -1) ::close(number);
    number = opened;
  }
};

}  // namespace regista::campaign
