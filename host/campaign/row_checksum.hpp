// SPDX-License-Identifier: MIT
// The checksum that a row of a file of results carries: CRC-32 over its columns, each as a line of text.
// docs/results.md says it for other programs.
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mcap/checksum.hpp"

namespace regista::campaign {

class RowChecksum {
 public:
  RowChecksum& whole(std::int64_t value) { return line(fmt::format("{}\n", value)); }
  RowChecksum& real(double value) { return line(fmt::format("{:016x}\n", std::bit_cast<std::uint64_t>(value))); }
  // With its length, so that no two rows read alike. Empty: null.
  RowChecksum& bytes(std::string_view value) { return line(fmt::format("{} ", value.size())).line(value).line("\n"); }
  std::int64_t value() const { return sum_; }

 private:
  RowChecksum& line(std::string_view text) {
    sum_ = mcap::checksum(text, sum_);
    return *this;
  }

  std::uint32_t sum_ = 0;
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
