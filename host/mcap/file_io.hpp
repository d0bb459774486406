// SPDX-License-Identifier: MIT
// File access through system calls: files that are read at any position or record by record, and files that grow at the
// end. Functions throw Error with one line: "match.mcap: cannot be written: No space left on device".
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "mcap/encoding.hpp"

namespace regista::mcap {

class Error : public std::runtime_error {
 public:
  // reason: text after the name of the file: "is empty", "cannot be opened: Permission denied".
  Error(const std::filesystem::path& file, const std::string& reason)
      : std::runtime_error(file.string() + ": " + reason) {}
};

// The system's text for an error number.
inline std::string reason(int error) { return std::generic_category().message(error); }

// A file descriptor that the destructor closes.
struct Descriptor {
  int number = -1;  // negative: no file
  Descriptor() = default;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
};

// A file of fixed size that is read at any position.
class InputFile {
 public:
  // Throws Error unless the path is a regular file that may be read.
  explicit InputFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  // Replaces `to` by the bytes [offset, offset + count), which must be within the file. Throws Error if reading fails
  // or the file has shrunk.
  void read(std::uint64_t offset, std::size_t count, std::string& to) const;

 private:
  std::filesystem::path path_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
};

// A file that grows at its end. When append() returns, the kernel has the bytes, so they survive a crash.
class OutputFile {
 public:
  // Creates the file. An existing file is an Error unless `replace` is true. All functions throw Error with the reason.
  OutputFile(std::filesystem::path path, bool replace);

  // After a failed append() the end of the file is unknown, so every later call throws an Error with the same text.
  void append(std::string_view bytes);
  void close();  // the destructor closes the file, too, but reports no errors
  void throw_if_failed() const;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }          // bytes appended
  std::uint32_t checksum() const { return checksum_; }  // of all appended bytes

 private:
  [[noreturn]] void fail(int error);
  std::filesystem::path path_;
  Descriptor descriptor_;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;
  std::string failure_;
};

struct RecordPlace {
  Opcode opcode{};
  std::uint64_t offset = 0;   // first byte of the record in the file
  std::uint64_t content = 0;  // bytes after the prefix; all are in the file
  std::uint64_t length() const { return record_prefix + content; }
};

// Visits the records of a file one after the other without reading their contents.
class RecordWalk {
 public:
  RecordWalk(const InputFile& file, std::uint64_t begin) : file_(&file), offset_(begin) {}  // file must outlive it

  // Returns the place of the next record; nothing if the rest of the file does not contain a complete record.
  std::optional<RecordPlace> next();

  // Offset of the next record in the file.
  std::uint64_t offset() const { return offset_; }

 private:
  const InputFile* file_;
  std::uint64_t offset_;
  std::string prefix_;
};

}  // namespace regista::mcap
