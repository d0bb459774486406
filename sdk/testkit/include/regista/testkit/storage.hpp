// SPDX-License-Identifier: MIT
// Arrays and structs as a host of a later minor version would lay them out: elements farther apart and structs longer
// than this plugin knows. What a plugin must not read is filled with 0xFF, so that a double read from there is NaN.
//
// Room for elements that a plugin writes is in room.hpp.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <regista/abi.h>
#include <regista/testkit/memory.hpp>

namespace regista::testkit {

// A strided array. It remembers what it held, so that a plugin that writes to its input is found.
template <class T>
class Strided {
 public:
  Strided() = default;
  explicit Strided(std::span<const T> elements, const Layout& layout = {})
      : count_(static_cast<std::uint32_t>(elements.size())),
        stride_(static_cast<std::uint32_t>(sizeof(T)) + layout.growth),
        memory_(std::size_t{stride_} * elements.size(), layout) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      std::memcpy(reinterpret_cast<char*>(memory_.data()) + i * stride_, &elements[i], sizeof(T));
    }
    remember();
  }
  regista_span span() const { return {memory_.empty() ? nullptr : memory_.data(), count_, stride_}; }
  bool unchanged() const { return std::ranges::equal(memory_.words(), original_); }
  // Whoever still reads it, reads NaN, or is stopped.
  void scribble() {
    memory_.fill_with_ones();
    memory_.take_away();
  }
  // Becomes empty: whoever reads it nevertheless, reads NaN.
  void hide() {
    memory_.fill_with_ones();
    remember();
    count_ = 0;
  }

 private:
  void remember() {
    original_.assign(memory_.words().begin(), memory_.words().end());
    memory_.make_read_only();
  }

  std::uint32_t count_ = 0, stride_ = sizeof(T);
  Memory memory_;
  std::vector<std::uint64_t> original_;
};

// A struct whose first member is `size`.
template <class T>
class Grown {
 public:
  Grown() : Grown(T{}, Layout{}) {}
  explicit Grown(const T& value, const Layout& layout = {}) : memory_(sizeof(T) + layout.growth, layout) {
    T copy = value;
    copy.size = static_cast<std::uint32_t>(sizeof(T)) + layout.growth;
    std::memcpy(memory_.data(), &copy, sizeof(T));
    original_.assign(memory_.words().begin(), memory_.words().end());
  }
  const T& get() const { return *reinterpret_cast<const T*>(memory_.data()); }
  T& get() { return *reinterpret_cast<T*>(memory_.data()); }
  // An input is complete: nobody may write to it any more.
  void make_read_only() { memory_.make_read_only(); }
  bool unchanged() const { return std::ranges::equal(memory_.words(), original_); }
  bool tail_unchanged() const {
    return std::memcmp(reinterpret_cast<const char*>(memory_.data()) + sizeof(T),
                       reinterpret_cast<const char*>(original_.data()) + sizeof(T), memory_.bytes() - sizeof(T)) == 0;
  }
  void scribble() {
    memory_.fill_with_ones();
    memory_.take_away();
  }

 private:
  Memory memory_;
  std::vector<std::uint64_t> original_;
};

}  // namespace regista::testkit
