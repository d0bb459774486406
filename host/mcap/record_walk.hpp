// SPDX-License-Identifier: MIT
// Steps through the records of a file from one to the next, without reading what they hold.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "mcap/format.hpp"
#include "mcap/input_file.hpp"

namespace regista::mcap {

struct RecordPlace {
  Opcode opcode{};
  std::uint64_t offset = 0;   // of the record
  std::uint64_t content = 0;  // bytes after the prefix; the file holds them
  std::uint64_t length() const { return record_prefix + content; }
};

class RecordWalk {
 public:
  RecordWalk(const InputFile& file, std::uint64_t begin) : file_(&file), offset_(begin) {}  // the file outlives it

  // The next record; none where what is left of the file does not hold it whole.
  std::optional<RecordPlace> next();

  // Where the next record begins.
  std::uint64_t offset() const { return offset_; }

 private:
  const InputFile* file_;
  std::uint64_t offset_;
  std::string prefix_;
};

}  // namespace regista::mcap
