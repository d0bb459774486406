// SPDX-License-Identifier: MIT
// What can be read back from a file, and a folder for files.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mcap/file_io.hpp"
#include "mcap/reader.hpp"
#include "mcap/writer.hpp"
#include "unit/mcap/example.hpp"

namespace regista::mcap {

// How GoogleTest tells the cases.
inline void PrintTo(const WriterOptions& options, std::ostream* out) {
  *out << "chunks of " << options.chunk_size << (options.background ? " in the background" : "");
}

// All that came out of a file, and the error that ended it.
struct Contents {
  std::map<ChannelId, Channel> channels;
  std::vector<Metadata> metadata;
  std::vector<Kept> messages;
  std::string error;
  bool indexed = false;
  std::optional<std::string> cut_off;
};

inline Contents read_all(const std::filesystem::path& file, const Selection& selection = {},
                         std::size_t most_bytes = largest_record) {
  Contents contents;
  try {
    Reader reader(file, most_bytes);
    contents.indexed = reader.indexed();
    reader.select(selection);
    for (Message message; reader.next(message);) contents.messages.push_back(kept(message));
    contents.channels = reader.channels();
    contents.metadata = reader.metadata();
    contents.cut_off = reader.cut_off();
  } catch (const Error& error) {
    contents.error = error.what();
  }
  return contents;
}

// The index at the end of a file that has one.
inline Summary summary_of(const std::filesystem::path& file) {
  const InputFile input(file);
  RecordWalk walk(input, magic.size());
  walk.next();  // the header
  return read_summary(input, walk.offset(), largest_record).value();
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Always a new file: some file systems wait for the disk where an old one is written over.
inline void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::remove(file);
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// For tests that write thousands of files: memory, where there is some to write to.
inline std::string quick_folder() { return access("/dev/shm", W_OK) == 0 ? "/dev/shm" : testing::TempDir(); }

class McapTest : public testing::Test {
 protected:
  explicit McapTest(const std::string& parent = testing::TempDir()) {
    std::string pattern = parent + "/mcap_XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~McapTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::filesystem::path path(std::string_view name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

}  // namespace regista::mcap
