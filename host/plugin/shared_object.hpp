// SPDX-License-Identifier: MIT
// Opens shared objects and reads the descriptors of their plugins. libelf examines a file first, so the host refuses a
// broken file, or a text file named .so, without running its code. Opening a file runs the constructors of the file in
// this process. scan_files() examines untrusted files in a separate process.
#pragma once

#include <regista/abi.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plugin/description.hpp"

namespace regista::plugin {

struct SharedObject {
  std::vector<const regista_descriptor*> descriptors;  // checked; they live until the process ends
  std::string refusal;                                 // one line: why the file must not be used; empty: it may be used
  std::string remark;  // one line about a side effect of loading that the host has undone; empty: no side effect
};

// Opens the file. If the file has a mistake, `refusal` gives the reason, and the function throws nothing.
SharedObject open_shared_object(const std::filesystem::path& file);

// Data about a file from the file system. If two stamps of a path are equal, the file has not changed in between.
struct FileStamp {
  std::uint64_t device = 0, number = 0;  // identity of the file in the file system
  std::int64_t bytes = -1;               // -1: the file does not exist
  std::int64_t changed_s = 0, changed_ns = 0;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

FileStamp stamp_of(const std::filesystem::path& file);

// A shared object with plugins: the file's stamp (FileStamp), and its code, which is loaded for the first instance of a
// plugin. The constructor takes the stamp when the file is examined.
class PluginFile {
 public:
  explicit PluginFile(std::filesystem::path file);

  const std::filesystem::path& file() const { return file_; }
  const FileStamp& stamp() const { return stamp_; }  // stamp that the constructor took
  // Returns whether the file was written to, replaced or removed after the constructor took the stamp.
  bool has_changed() const;

  // Loads the file at the first call. For a mistake in the file, sets SharedObject::refusal and throws nothing.
  const SharedObject& load();
  // Loads the file if necessary. Returns descriptor number `index`. Throws std::runtime_error with a one-line reason if
  // the file cannot be used.
  const regista_descriptor& descriptor(std::uint32_t index);

 private:
  std::filesystem::path file_;
  std::filesystem::path absolute_;  // absolute path, because the working folder may change before the file is loaded
  FileStamp stamp_;
  std::optional<SharedObject> loaded_;
};

struct ScannedFile {
  std::vector<std::shared_ptr<const Description>> plugins;  // in the file's order
  std::string refusal;  // one line: why the file must not be used; empty: it may be used
  std::string remark;   // one line with a remark for the file's author; empty: no remark
};

// Examines files that may contain anything. Returns one result for each file. If opening a file crashes, exits or
// hangs, the result refuses this file and has the reason. At first one process opens all files. After a failure, each
// file gets a process of its own, because a part of one file may still run and disturb the examination of the next
// file. Throws std::system_error if no process can be started.
std::vector<ScannedFile> scan_files(std::span<const std::filesystem::path> files);

// --- A hash of a file's content: XXH3 with 128 bits, as 32 hexadecimal digits in canonical (big-endian) order, as
// `xxh128sum` prints it. Detects accidental differences, not forgeries.

std::string content_hash(std::string_view bytes);
// Returns the first 32 bits of content_hash(), as a part of seeds.
std::uint32_t content_hash_32(std::string_view bytes);

}  // namespace regista::plugin
