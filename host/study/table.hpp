// SPDX-License-Identifier: MIT
// A table of plain comma-separated values, read line by line, compressed by gzip or not. Columns go by the names of the
// first line; nothing is quoted. (The CSV libraries of the distribution fix the columns when they are compiled, or do
// not say where in a line a value stands.)
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.hpp"

namespace regista::study {

// Called now and then while a file is read, with the lines so far; may throw to stop.
using Progress = std::function<void(std::size_t lines)>;

class Table {
 public:
  static constexpr std::size_t longest_line = 65'536;     // bytes
  static constexpr std::size_t most_lines = 100'000'000;  // a day of a 1 kHz camera

  // Opens the file and reads the names of its columns. Throws config::Error at the file, or at the place in it, for
  // everything that is wrong with it, as do all calls below.
  explicit Table(const std::filesystem::path& file, Progress progress = {});
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  // Index of a column; throws when the first line does not have it.
  std::size_t column(std::string_view name) const;
  bool has_column(std::string_view name) const;
  std::span<const std::string> columns() const { return columns_; }  // in their order

  // Reads the next line that is not empty; false at the end of the file.
  bool next();

  // Fields of the present line.
  std::string_view text(std::size_t column) const { return fields_[column]; }
  double number(std::size_t column) const;  // finite
  int integer(std::size_t column) const;
  std::int64_t count(std::size_t column, std::int64_t most) const;  // from 0 to `most`

  config::Location where(std::size_t column) const;  // before next(): of the column's name
  [[noreturn]] void refuse(std::size_t column, const std::string& message) const;  // throws Error at the field

 private:
  struct Stream;
  bool read_line();
  void split();
  [[noreturn]] void refuse_line(const std::string& message) const;

  std::string name_;
  Progress progress_;
  std::unique_ptr<Stream> stream_;
  std::string line_;
  std::size_t lines_ = 0;
  std::vector<std::string> columns_;
  std::vector<std::string_view> fields_;
};

}  // namespace regista::study
