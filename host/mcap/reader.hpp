// SPDX-License-Identifier: MIT
// Reads an MCAP file (https://mcap.dev/spec) from its first message to its last, with one chunk in memory.
//
//   mcap::Reader reader("match.mcap");
//   reader.select({.last_time = 462'000'000'000, .topics = {"/truth"}});
//   for (mcap::Message message; reader.next(message);) use(reader.channels().at(message.channel), message.data);
//   if (reader.cut_off()) warn(*reader.cut_off());
//
// A file with an intact summary is read through it: chunks that hold nothing of the selection are passed over. One that
// has none, because a crash or a full disk cut it off, is read from its beginning as far as its records are whole. The
// file is taken for hostile: no number in it is believed before the file has shown the bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mcap/compression.hpp"
#include "mcap/decode.hpp"
#include "mcap/definitions.hpp"
#include "mcap/format.hpp"
#include "mcap/input_file.hpp"
#include "mcap/record_walk.hpp"
#include "mcap/records.hpp"
#include "mcap/summary.hpp"

namespace regista::mcap {

struct Selection {
  std::uint64_t first_time = 0, last_time = std::numeric_limits<std::uint64_t>::max();  // log times, both included
  std::vector<std::string> topics = {};                                                 // none: all of them
};

class Reader {
 public:
  // Throws Error for a file that cannot be opened, is no MCAP file of version 0 or ends within its header, or whose
  // summary is damaged. `most_bytes` is the most of one chunk (plain or compressed), record, summary, of all metadata,
  // or of all schemas and channels: what is more is refused.
  explicit Reader(const std::filesystem::path& file, std::size_t most_bytes = largest_record);

  // Whether a summary leads to the messages. Then channels and metadata are known from the beginning, otherwise as far
  // as next() has come.
  bool indexed() const { return summary_.has_value(); }
  const std::map<ChannelId, Channel>& channels() const { return definitions_.channels(); }
  const std::vector<Metadata>& metadata() const { return metadata_; }
  const Statistics* statistics() const;  // null where no summary tells them

  // Starts again from the beginning of the file, with these messages only.
  void select(Selection selection);

  // The next message in the order of the file; false at its end. The message's data live until the next call. Throws
  // Error at a damaged chunk; the call after that goes on with what follows.
  bool next(Message& message);

  // After next() has returned false: where the file was cut off, if it was; for people, with the file's name.
  const std::optional<std::string>& cut_off() const { return cut_off_; }

 private:
  void open_summary();
  bool next_records();
  bool next_indexed_chunk();
  bool next_walked_record();
  void end_walk(bool after_footer);
  bool is_wanted(const ChunkIndex& chunk) const;
  void load_chunk(std::uint64_t offset, std::uint64_t length, const ChunkIndex* index);
  bool take_message(Message& message);
  void define(const RawRecord& record);
  void note_wanted(const Channel& channel);
  void keep_metadata(std::uint64_t offset, std::uint64_t length);
  std::string_view content(std::uint64_t offset, std::uint64_t length, std::string& to) const;
  [[noreturn]] void damaged(std::uint64_t byte, const std::string& why) const;

  InputFile file_;
  std::size_t most_bytes_;
  std::uint64_t header_end_ = 0;
  bool has_footer_ = false;
  std::optional<Summary> summary_;
  Definitions definitions_;
  std::size_t metadata_left_;  // bytes
  std::vector<Metadata> metadata_;
  std::uint64_t kept_until_ = 0;  // metadata before are known

  Selection selection_;
  enum class Wanted : std::uint8_t { unknown, no, yes };
  std::vector<Wanted> wanted_;  // by channel

  Decompressor decompressor_;
  std::size_t next_chunk_ = 0;  // with a summary
  RecordWalk walk_;             // without
  bool walk_is_over_ = false, in_summary_ = false;
  std::string stored_;   // a record as it stands in the file
  std::string records_;  // schemas, channels and messages of the current chunk
  Decoder rest_{{}};     // what of them has not been delivered
  std::uint64_t place_ = 0;
  std::optional<std::string> cut_off_;
};

}  // namespace regista::mcap
