// SPDX-License-Identifier: MIT
// Numbers of few bits each in as few bytes as they need: what negotiating assigners say in segments of packets. The
// first number stands in the lowest bits of the first byte.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace negotiation {

// Fills a buffer of its caller from the beginning; allocates only beyond its capacity.
class BitWriter {
 public:
  explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) { bytes_.clear(); }
  // value < 2^bits, bits <= 32.
  void put(std::uint32_t value, unsigned bits) {
    assert(bits <= 32 && (bits == 32 || value >> bits == 0));
    for (unsigned bit = 0; bit < bits; ++bit, ++at_) {
      if (at_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | (value >> bit & 1u) << at_ % 8);
    }
  }

 private:
  std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;  // bits
};

// Reads whatever was sent: beyond the end all is 0, and complete() tells.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t get(unsigned bits) {
    assert(bits <= 32);
    std::uint32_t value = 0;
    for (unsigned bit = 0; bit < bits; ++bit, ++at_) {
      if (at_ / 8 < bytes_.size()) value |= (bytes_[at_ / 8] >> at_ % 8 & 1u) << bit;
    }
    return value;
  }
  // Nothing was read beyond the end, and what is left are less than eight bits, all 0.
  bool complete() const {
    if ((at_ + 7) / 8 != bytes_.size()) return false;
    return at_ % 8 == 0 || bytes_.back() >> at_ % 8 == 0;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;  // bits
};

}  // namespace negotiation
