// SPDX-License-Identifier: MIT
// Room that a plugin writes its answer to. Before its beginning and directly behind the promised size stands a pattern:
// whoever writes past the end of an answer writes over the pattern, not over what belongs to somebody else, and is
// found out when the call has returned.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace regista::plugin {

enum class Overflow { none, before_the_beginning, past_the_end };

// The pattern, around room of any kind.
struct Guard {
  static constexpr std::size_t margin = 256;  // bytes of pattern behind the end, and at least as many before
  // No byte stands in it twice, so that no constant that memory is filled with equals it.
  static constexpr std::uint64_t pattern = 0xc5a35c3a96e7b14du;
  static constexpr std::size_t edge = sizeof pattern;
  // So that the beginning and the pattern directly before it lie in one line of the cache.
  static constexpr std::size_t before = margin + 16;

  static void draw(std::byte* from, std::size_t size) {
    for (std::size_t i = 0; i < size; i += sizeof pattern) std::memcpy(from + i, &pattern, sizeof pattern);
  }

  // 0 when so many bytes are the pattern's. Without a branch, so that the compiler compares many at once.
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

  // 0 when nobody wrote directly before `begin` or directly behind `end`: where overflows begin.
  static std::uint64_t difference_at_edges(const std::byte* begin, const std::byte* end) {
    return difference<edge>(begin - edge) | difference<edge>(end);
  }

  // Looks at all of the pattern.
  static Overflow overflow(const std::byte* begin, const std::byte* end) {
    if (difference<margin>(end) != 0) return Overflow::past_the_end;
    return difference<before>(begin - before) != 0 ? Overflow::before_the_beginning : Overflow::none;
  }
};

// Room for one value, all bytes zero at first.
template <class T>
class GuardedValue {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);

 public:
  GuardedValue() { mend(); }

  T* data() { return reinterpret_cast<T*>(begin()); }
  const T* data() const { return reinterpret_cast<const T*>(begin()); }

  // Draws the pattern again, whatever became of it.
  void mend() {
    Guard::draw(bytes_.data(), Guard::before);
    Guard::draw(begin() + sizeof(T), Guard::margin);
  }
  std::uint64_t difference_at_edges() const { return Guard::difference_at_edges(begin(), begin() + sizeof(T)); }
  Overflow overflow() const { return Guard::overflow(begin(), begin() + sizeof(T)); }

 private:
  std::byte* begin() { return bytes_.data() + Guard::before; }
  const std::byte* begin() const { return bytes_.data() + Guard::before; }

  alignas(64) std::array<std::byte, Guard::before + sizeof(T) + Guard::margin> bytes_{};
};

// Room for as many values as a call may write, all bytes zero at first. Allocates only while it grows.
template <class T>
class GuardedRoom {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);

 public:
  // Open for as many elements as it has room for.
  explicit GuardedRoom(std::size_t capacity) { open(capacity); }

  // From now on so many elements are promised; what is written behind them is an overflow.
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

  // Draws the pattern again, whatever became of it.
  void mend() {
    Guard::draw(begin() - Guard::before, Guard::before);
    Guard::draw(begin() + count_ * sizeof(T), Guard::margin);
  }
  std::uint64_t difference_at_edges() const {
    return Guard::difference_at_edges(begin(), begin() + count_ * sizeof(T));
  }
  Overflow overflow() const { return Guard::overflow(begin(), begin() + count_ * sizeof(T)); }

 private:
  struct alignas(64) Line {
    std::byte bytes[64];
  };

  std::byte* begin() { return reinterpret_cast<std::byte*>(lines_.data()) + Guard::before; }
  const std::byte* begin() const { return reinterpret_cast<const std::byte*>(lines_.data()) + Guard::before; }

  void draw_pattern(std::size_t count) {
    const std::size_t used = Guard::before + count * sizeof(T) + Guard::margin;
    if (used > lines_.size() * sizeof(Line)) {
      lines_.resize((used + sizeof(Line) - 1) / sizeof(Line));
      Guard::draw(begin() - Guard::before, Guard::before);
    }
    count_ = count;
    Guard::draw(begin() + count * sizeof(T), Guard::margin);
  }

  std::vector<Line> lines_;
  std::size_t count_ = 0;
};

}  // namespace regista::plugin
