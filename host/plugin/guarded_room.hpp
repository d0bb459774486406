// SPDX-License-Identifier: MIT
// Room that a plugin writes its answer to. Before its beginning and directly behind the promised size stands a pattern:
// whoever writes past the end of an answer writes over the pattern, not over what belongs to somebody else, and is
// found out when the call has returned.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace regista::plugin {

enum class Overflow { none, before_the_beginning, past_the_end };

// Holds plain values, all bytes zero at first. Allocates only while it grows.
template <class T>
class GuardedRoom {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 16);

 public:
  static constexpr std::size_t margin = 256;  // bytes of pattern behind the end, and at least as many before

  // Open for as many elements as it has room for.
  explicit GuardedRoom(std::size_t capacity) { open(capacity); }

  // From now on so many elements are promised; what is written behind them is an overflow.
  T* open(std::size_t count) {
    if (count != count_ || lines_.empty()) [[unlikely]]
      draw_pattern(count);
    return data();
  }

  T* data() { return reinterpret_cast<T*>(bytes() + before); }
  const T* data() const { return reinterpret_cast<const T*>(bytes() + before); }
  std::size_t size() const { return count_; }
  std::span<const T> first(std::size_t count) const {
    assert(count <= count_);
    return {data(), count};
  }

  // Draws the pattern again, whatever became of it.
  void mend() {
    draw(bytes(), before);
    draw(bytes() + before + count_ * sizeof(T), margin);
  }

  // Whether nobody wrote directly before the beginning or directly behind the end: where overflows begin.
  bool edges_are_whole() const {
    return (difference<edge>(bytes() + before - edge) | difference<edge>(bytes() + before + count_ * sizeof(T))) == 0;
  }

  // Looks at all of the pattern.
  Overflow overflow() const {
    if (difference<margin>(bytes() + before + count_ * sizeof(T)) != 0) return Overflow::past_the_end;
    return difference<before>(bytes()) != 0 ? Overflow::before_the_beginning : Overflow::none;
  }

 private:
  // No byte stands in it twice, so that no constant that memory is filled with equals it.
  static constexpr std::uint64_t pattern = 0xc5a35c3a96e7b14du;
  static constexpr std::size_t edge = 16;
  struct alignas(64) Line {
    std::byte bytes[64];
  };
  // So that the beginning and the pattern directly before it lie in one line of the cache.
  static constexpr std::size_t before = margin + edge;

  std::byte* bytes() { return lines_.data()->bytes; }
  const std::byte* bytes() const { return lines_.data()->bytes; }

  // 0 when so many bytes are the pattern's. Without a branch, so that the compiler compares many at once.
  template <std::size_t Size>
  static std::uint64_t difference(const std::byte* from) {
    static_assert(Size % sizeof pattern == 0);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < Size; i += sizeof pattern) {
      std::uint64_t word;
      std::memcpy(&word, from + i, sizeof word);
      seen |= word ^ pattern;
    }
    return seen;
  }

  static void draw(std::byte* from, std::size_t size) {
    for (std::size_t i = 0; i < size; i += sizeof pattern) std::memcpy(from + i, &pattern, sizeof pattern);
  }

  void draw_pattern(std::size_t count) {
    const std::size_t used = before + count * sizeof(T) + margin;
    if (used > lines_.size() * sizeof(Line)) {
      lines_.resize((used + sizeof(Line) - 1) / sizeof(Line));
      draw(bytes(), before);
    }
    count_ = count;
    draw(bytes() + before + count * sizeof(T), margin);
  }

  std::vector<Line> lines_;
  std::size_t count_ = 0;
};

}  // namespace regista::plugin
