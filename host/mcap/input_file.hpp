// SPDX-License-Identifier: MIT
// A file of fixed size, read at any place.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace regista::mcap {

class InputFile {
 public:
  // Throws Error unless it is a regular file that may be read.
  explicit InputFile(std::filesystem::path path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  // Replaces `to` by the bytes [offset, offset + count), which lie within the file. Throws Error where the system fails
  // or the file has shrunk.
  void read(std::uint64_t offset, std::size_t count, std::string& to) const;

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace regista::mcap
