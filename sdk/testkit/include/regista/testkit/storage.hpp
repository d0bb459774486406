// SPDX-License-Identifier: MIT
// Memory as a host of a later minor version would lay it out: elements farther apart and structs longer than this
// plugin knows. What a plugin must not read is filled with 0xFF, so that a double read from there is NaN.
//
// Room for elements that a plugin writes is in room.hpp.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include <regista/abi.h>

namespace regista::testkit {

// Bytes by which everything is longer than in this version; a multiple of 8.
struct Growth {
  std::uint32_t bytes = 0;
};

namespace detail {

inline std::vector<std::uint64_t> words(std::size_t bytes) {
  return std::vector<std::uint64_t>((bytes + 7) / 8, ~std::uint64_t{0});
}

}  // namespace detail

// A strided array. It remembers what it held, so that a plugin that writes to its input is found.
template <class T>
class Strided {
 public:
  Strided() = default;
  explicit Strided(std::span<const T> elements, Growth growth = {})
      : count_(static_cast<std::uint32_t>(elements.size())),
        stride_(static_cast<std::uint32_t>(sizeof(T)) + growth.bytes),
        words_(detail::words(std::size_t{stride_} * elements.size())) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      std::memcpy(reinterpret_cast<char*>(words_.data()) + i * stride_, &elements[i], sizeof(T));
    }
    original_ = words_;
  }
  regista_span span() const { return {words_.empty() ? nullptr : words_.data(), count_, stride_}; }
  bool unchanged() const { return words_ == original_; }
  // Overwrites everything: whoever still reads it, reads NaN.
  void scribble() { words_.assign(words_.size(), ~std::uint64_t{0}); }
  // Becomes empty: whoever reads it nevertheless, reads NaN.
  void hide() {
    scribble();
    original_ = words_;
    count_ = 0;
  }

 private:
  std::uint32_t count_ = 0, stride_ = sizeof(T);
  std::vector<std::uint64_t> words_, original_;
};

// A struct whose first member is `size`.
template <class T>
class Grown {
 public:
  Grown() : Grown(T{}, Growth{}) {}
  explicit Grown(const T& value, Growth growth = {}) : words_(detail::words(sizeof(T) + growth.bytes)) {
    T copy = value;
    copy.size = static_cast<std::uint32_t>(sizeof(T)) + growth.bytes;
    std::memcpy(words_.data(), &copy, sizeof(T));
    original_ = words_;
  }
  const T& get() const { return *reinterpret_cast<const T*>(words_.data()); }
  T& get() { return *reinterpret_cast<T*>(words_.data()); }
  bool unchanged() const { return words_ == original_; }
  bool tail_unchanged() const {
    return std::memcmp(reinterpret_cast<const char*>(words_.data()) + sizeof(T),
                       reinterpret_cast<const char*>(original_.data()) + sizeof(T), words_.size() * 8 - sizeof(T)) == 0;
  }
  void scribble() { words_.assign(words_.size(), ~std::uint64_t{0}); }

 private:
  std::vector<std::uint64_t> words_, original_;
};

}  // namespace regista::testkit
