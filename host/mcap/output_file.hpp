// SPDX-License-Identifier: MIT
// A file that grows at its end, through the system's own calls: what append() has returned from is with the kernel and
// survives the death of this process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace regista::mcap {

class OutputFile {
 public:
  // Creates the file. One that exists is an Error unless `replace`. Every function throws Error with the system's
  // reason.
  OutputFile(std::filesystem::path path, bool replace);
  ~OutputFile();  // closes; what could not be written has been reported before
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // After a failure the end of the file is unknown: every later call fails with the same line.
  void append(std::string_view bytes);
  void close();
  void throw_if_failed() const;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }          // bytes appended
  std::uint32_t checksum() const { return checksum_; }  // of all of them

 private:
  [[noreturn]] void fail(int error);
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint32_t checksum_ = 0;
  std::string failure_;
};

}  // namespace regista::mcap
