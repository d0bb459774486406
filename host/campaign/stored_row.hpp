// SPDX-License-Identifier: MIT
// Rows of a file of results: functions that write a row, the checksum of a row, and the error for a damaged row.
#pragma once

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mcap/encoding.hpp"

namespace regista::campaign {

// Computes the CRC-32 of a row from a text with a line for each column. docs/results.md describes the text.
class RowChecksum {
 public:
  RowChecksum& whole(std::int64_t value) { return append(value, '\n'); }
  // Appends the bits of the number as 16 hexadecimal digits.
  RowChecksum& real(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (int shift = 60; shift >= 0; shift -= 4) text_ += "0123456789abcdef"[bits >> shift & 0xf];
    text_ += '\n';
    return *this;
  }
  // Appends the length and the bytes, so that two different rows never give the same text. Null counts as empty.
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

// Error for a row with a wrong checksum, or with values that this program never writes.
struct DamagedRow : std::invalid_argument {
  DamagedRow(std::int64_t at, const std::string& why) : std::invalid_argument(why), row(at) {}
  std::int64_t row;
};

// Returns the result of `read`. Converts a std::invalid_argument into a DamagedRow, whose text begins with `what`.
template <class Read>
auto reading_row(std::int64_t row, const std::string& what, Read read) {
  try {
    return read();
  } catch (const std::invalid_argument& error) {
    throw DamagedRow(row, what + error.what());
  }
}

// The bytes of a BLOB column. The view is valid while the statement stays at its row.
struct Blob {
  std::string_view bytes;
};
template <class Column>
std::string_view blob_of(const Column& column) {
  return {static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

// Binds a value to parameter `at` of an SQLite::Statement. Texts and blobs are not copied. An empty optional is null.
template <class Statement, class Value>
void bind(Statement& statement, int at, const Value& value) {
  statement.bind(at, value);
}
template <class Statement>
void bind(Statement& statement, int at, const std::string& text) {
  statement.bindNoCopy(at, text);
}
template <class Statement>
void bind(Statement& statement, int at, const Blob& blob) {
  statement.bindNoCopy(at, blob.bytes.data(), static_cast<int>(blob.bytes.size()));
}
template <class Statement, class Value>
void bind(Statement& statement, int at, const std::optional<Value>& value) {
  if (value)
    bind(statement, at, *value);
  else
    statement.bind(at);
}

// Executes `statement` with these values, in order. Returns whether it wrote a row. Throws SQLite::Exception.
template <class Statement, class... Values>
bool put(Statement& statement, const Values&... values) {
  statement.tryReset();  // reset() would report the error of the last execution again
  int place = 0;
  (bind(statement, ++place, values), ...);
  const bool written = statement.exec() == 1;
  statement.reset();
  return written;
}

}  // namespace regista::campaign
