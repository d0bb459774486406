// SPDX-License-Identifier: MIT
// A shared object of plugins: which file it was when it was looked at, and its code once it is needed. Loading runs
// whatever the file wants to run, so it is put off until an instance is created.
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <utility>

#include <regista/abi.h>

#include "plugin/shared_object.hpp"

namespace regista::plugin {

// What tells that a file is still the same, without reading it.
struct FileStamp {
  std::uint64_t device = 0, number = 0;  // what the file system knows it by
  std::int64_t bytes = -1;               // -1: there is no such file
  std::int64_t changed_s = 0, changed_ns = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

FileStamp stamp_of(const std::filesystem::path& file);

class PluginFile {
 public:
  explicit PluginFile(std::filesystem::path file);

  const std::filesystem::path& file() const { return file_; }
  const FileStamp& stamp() const { return stamp_; }  // when it was looked at
  // Written to, replaced or removed since: what was looked at is not what is there.
  bool has_changed() const;

  // Loads it at the first call. Never throws for what is wrong with the file.
  const SharedObject& load();
  // Loads it at the first call. Throws std::runtime_error with one line that says why it cannot be.
  const regista_descriptor& descriptor(std::uint32_t index);

 private:
  std::filesystem::path file_;
  std::filesystem::path absolute_;  // the folder may be left before the file is loaded
  FileStamp stamp_;
  std::optional<SharedObject> loaded_;
};

}  // namespace regista::plugin
