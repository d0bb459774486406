// SPDX-License-Identifier: MIT
// Memory into which the plugins of one robot write their answers. All plugin instances of the robot share these
// buffers, so that the edges of the buffers stay in the processor's cache. A guard pattern lies before and behind each
// buffer. A plugin that writes outside of its buffer overwrites the pattern, and the host detects this after the call.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include <regista/abi.h>

#include "plugin/call_inputs.hpp"

namespace regista::plugin {

enum class Overflow { none, before_the_beginning, past_the_end };

// The guard pattern before and behind a buffer.
struct Guard {
  static constexpr std::size_t margin = 256;  // bytes of pattern behind the end
  // No two bytes of the pattern are equal, so memory that is filled with one byte value never equals the pattern.
  static constexpr std::uint64_t pattern = 0xc5a35c3a96e7b14du;
  static constexpr std::size_t edge = sizeof pattern;
  // Bytes of pattern before the buffer: 16 more than behind, so pattern and buffer meet inside of a cache line.
  static constexpr std::size_t before = margin + 16;

  static void draw(std::byte* from, std::size_t size) {
    for (std::size_t i = 0; i < size; i += sizeof pattern) std::memcpy(from + i, &pattern, sizeof pattern);
  }

  // Returns 0 if `size` bytes equal the pattern. Has no branch, so that the compiler can compare many bytes together.
  template <std::size_t size>
  static std::uint64_t difference(const std::byte* from) {
    static_assert(size % sizeof pattern == 0);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < size; i += sizeof pattern) {
      std::uint64_t word;
      std::memcpy(&word, from + i, sizeof word);
      seen |= word ^ pattern;
    }
    return seen;
  }
};

// A buffer for answers of type T. All bytes are zero at first. Allocates only when the number of answers grows.
template <class T>
class GuardedBuffer {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);

 public:
  explicit GuardedBuffer(std::size_t capacity) { open(capacity); }

  // Makes a buffer of `count` elements for the plugin. A write behind these elements is an overflow.
  T* open(std::size_t count) {
    if (count != count_ || lines_.empty()) [[unlikely]]
      draw_pattern(count);
    return data();
  }

  T* data() { return reinterpret_cast<T*>(begin()); }
  const T* data() const { return reinterpret_cast<const T*>(begin()); }
  std::size_t size() const { return count_; }
  std::span<const T> first(std::size_t count) const {
    assert(count <= count_);
    return {data(), count};
  }

  // Restores the guard pattern.
  void mend() {
    Guard::draw(begin() - Guard::before, Guard::before);
    Guard::draw(end(), Guard::margin);
  }
  // Returns 0 if the 8 bytes before the buffer and the 8 bytes behind it equal the pattern. Most overflows change them.
  std::uint64_t difference_at_edges() const {
    return Guard::difference<Guard::edge>(begin() - Guard::edge) | Guard::difference<Guard::edge>(end());
  }
  // Compares the whole pattern. Returns on which side it differs.
  Overflow overflow() const {
    if (Guard::difference<Guard::margin>(end()) != 0) return Overflow::past_the_end;
    const bool before = Guard::difference<Guard::before>(begin() - Guard::before) != 0;
    return before ? Overflow::before_the_beginning : Overflow::none;
  }

 private:
  struct alignas(64) Line {
    std::byte bytes[64];
  };

  std::byte* begin() { return reinterpret_cast<std::byte*>(lines_.data()) + Guard::before; }
  const std::byte* begin() const { return reinterpret_cast<const std::byte*>(lines_.data()) + Guard::before; }
  std::byte* end() { return begin() + count_ * sizeof(T); }
  const std::byte* end() const { return begin() + count_ * sizeof(T); }

  void draw_pattern(std::size_t count) {
    const std::size_t used = Guard::before + count * sizeof(T) + Guard::margin;
    if (used > lines_.size() * sizeof(Line)) {
      lines_.resize((used + sizeof(Line) - 1) / sizeof(Line));
      Guard::draw(begin() - Guard::before, Guard::before);
    }
    count_ = count;
    Guard::draw(end(), Guard::margin);
  }

  std::vector<Line> lines_;
  std::size_t count_ = 0;
};

struct AnswerBuffers {
  // After every call the host checks the bytes next to the buffers, and how the processor rounds. If `strict`, the host
  // also checks the whole pattern and the whole floating-point state.
  bool strict = true;

  CallNote unheard;                           // note that nobody reads: calls write to it if the caller has no CallNote
  GuardedBuffer<regista_error> error{1};      // for the error text of every call
  GuardedBuffer<regista_room> track_room{1};  // answer of a predictor
  GuardedBuffer<regista_track> tracks{1};     // answer of a predictor
  GuardedBuffer<std::int32_t> holds{1};       // answer of a context
  GuardedBuffer<regista_placement> placement{1};  // answer of a positioner
  GuardedBuffer<regista_waypoint> points{1};      // answer of a positioner
  GuardedBuffer<regista_edge> edges{1};           // answer of a positioner
  GuardedBuffer<regista_cell> cells{1};           // answer of a positioner
  GuardedBuffer<regista_vertex> vertices{1};      // answer of a positioner
  GuardedBuffer<double> utilities{1};             // answer of a utility
  GuardedBuffer<std::int32_t> columns{1};         // answer of an assigner
  GuardedBuffer<regista_action> action{1};        // answer of a behaviour
  GuardedBuffer<regista_send> send{1};            // answer of a sender
  GuardedBuffer<std::uint64_t> granted{1};        // answer of a sender
  GuardedBuffer<char> text{1};                    // answer of a mailbox
};

}  // namespace regista::plugin
