// SPDX-License-Identifier: MIT
// A file descriptor that is closed at the end.
#pragma once

#include <unistd.h>

#include <utility>

namespace regista::campaign {

struct Descriptor {
  int number = -1;  // -1: none

  Descriptor() = default;
  explicit Descriptor(int opened) : number(opened) {}
  ~Descriptor() { reset(); }
  Descriptor(Descriptor&& other) noexcept : number(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
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
