// SPDX-License-Identifier: MIT
// The checksum that a row of a file of results carries: CRC-32 over its columns, each as a line of text.
// docs/results.md says it for other programs.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mcap/checksum.hpp"

namespace regista::campaign {

class RowChecksum {
 public:
  RowChecksum& whole(std::int64_t value) { return append(value, '\n'); }
  // By its bits: 16 hexadecimal digits.
  RowChecksum& real(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 60; shift >= 0; shift -= 4) text_ += "0123456789abcdef"[bits >> shift & 0xf];
    text_ += '\n';
    return *this;
  }
  // With its length, so that no two rows read alike. Empty: null.
  RowChecksum& bytes(std::string_view value) {
    append(value.size(), ' ').text_ += value;
    text_ += '\n';
    return *this;
  }
  std::int64_t value() const { return mcap::checksum(text_); }

 private:
  template <class Whole>
  RowChecksum& append(Whole value, char end) {
    std::array<char, 24> digits{};
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text_.append(digits.data(), written.ptr);
    text_ += end;
    return *this;
  }

  std::string text_;
};

// A row whose checksum does not fit, or that holds what nobody wrote.
class DamagedRow : public std::invalid_argument {
 public:
  DamagedRow(std::int64_t row, const std::string& why) : std::invalid_argument(why), row_(row) {}
  std::int64_t row() const { return row_; }

 private:
  std::int64_t row_;
};

}  // namespace regista::campaign
