// SPDX-License-Identifier: MIT
// Room for elements that a plugin writes, as a host of a later minor version would lay it out: elements farther apart
// than this plugin knows, the rest of each 0 and to stay so. Behind the last one lies memory that must stay as it is.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include <regista/abi.h>
#include <regista/testkit/storage.hpp>

namespace regista::testkit {

template <class T>
class WritableRoom {
 public:
  // An element that nobody wrote is all 0xFF: a double in it is NaN.
  explicit WritableRoom(std::uint32_t capacity, const Layout& layout = {})
      : capacity_(capacity),
        stride_(static_cast<std::uint32_t>(sizeof(T)) + layout.growth),
        behind_(layout.guarded ? 0 : 4),
        memory_((std::size_t{capacity} + behind_) * stride_, layout) {
    for (std::uint32_t i = 0; i < capacity_; ++i) std::memset(at(i) + sizeof(T), 0, stride_ - sizeof(T));
  }
  // Valid as long as *this stays where it is.
  regista_room raw() { return {memory_.data(), capacity_, 0, stride_, 0}; }

  // What is wrong with the memory around the elements and with `written`, the room that the plugin has filled.
  std::optional<std::string> damage(const regista_room& written, const char* what) const {
    const std::string name = std::string(what) + ": ";
    if (written.data != memory_.data() || written.capacity != capacity_ || written.stride != stride_ ||
        written.reserved != 0) {
      return name + "changed more of its room than the count";
    }
    for (std::uint32_t i = 0; i < capacity_; ++i) {
      for (std::uint32_t k = sizeof(T); k < stride_; ++k) {
        if (at(i)[k] != 0) return name + "wrote behind an element: step by stride, not by sizeof";
      }
    }
    for (std::size_t k = 0; k < behind_ * stride_; ++k) {
      if (at(capacity_)[k] != 0xff) return name + "wrote past the capacity of " + std::to_string(capacity_);
    }
    if (written.count > capacity_) {
      return name + "says " + std::to_string(written.count) + " of at most " + std::to_string(capacity_);
    }
    return std::nullopt;
  }
  // The first `count` elements.
  std::vector<T> take(std::uint32_t count) const {
    std::vector<T> out(count);
    for (std::uint32_t i = 0; i < count; ++i) std::memcpy(&out[i], at(i), sizeof(T));
    return out;
  }

 private:
  unsigned char* at(std::uint32_t index) {
    return reinterpret_cast<unsigned char*>(memory_.data()) + std::size_t{index} * stride_;
  }
  const unsigned char* at(std::uint32_t index) const {
    return reinterpret_cast<const unsigned char*>(memory_.data()) + std::size_t{index} * stride_;
  }

  std::uint32_t capacity_, stride_;
  std::size_t behind_;  // elements of memory that nobody may touch, where there is no guard
  Memory memory_;
};

}  // namespace regista::testkit
