// SPDX-License-Identifier: MIT
// Reads an MCAP file (https://mcap.dev/spec) from its first message to its last, and keeps one chunk in memory. MCAP
// files may have any order of messages, so a reader that needs the order of time selects it.
//
//   mcap::Reader reader("match.mcap");
//   reader.select({.last_time = 462'000'000'000, .topics = {"/truth"}});
//   for (mcap::Message message; reader.next(message);) use(reader.channels().at(message.channel), message.data);
//   if (reader.cut_off()) warn(*reader.cut_off());
//
// If the file has an intact summary, the reader uses the summary and skips chunks without selected messages. A crash or
// a full disk leaves a file without a summary: the reader reads this file up to its last complete record. The reader
// does not trust lengths in the file, but checks that the file contains the bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "mcap/encoding.hpp"
#include "mcap/file_io.hpp"

namespace regista::mcap {

struct Selection {
  std::uint64_t first_time = 0, last_time = std::numeric_limits<std::uint64_t>::max();  // log times, inclusive
  std::vector<std::string> topics = {};                                                 // empty: all topics
  // Sorts messages by log time, channel and sequence. The reader then keeps in memory the chunks that overlap in time;
  // without a summary, all selected messages.
  bool by_time = false;
};

// Sorting would need too much memory, or the summary contains wrong times. The reader delivers no further message.
struct Unsortable : Error {
  using Error::Error;
};

// The schemas and channels that were read from a file so far.
class Definitions {
 public:
  // Keeps at most most_bytes bytes, so that a file cannot exhaust the memory with names.
  explicit Definitions(std::size_t most_bytes) : left_(most_bytes) {}

  // Throws Malformed if a definition differs from an earlier one with the same id, or if a channel comes before its
  // schema. Equal definitions may be repeated, as in summaries and chunks.
  void define(Schema&& schema);
  bool define(Channel&& channel);  // true if the channel is new

  const std::map<ChannelId, Channel>& channels() const { return channels_; }

 private:
  void take(std::size_t bytes);
  std::size_t left_;
  std::map<SchemaId, Schema> schemas_;
  std::map<ChannelId, Channel> channels_;
};

// The index at the end of an MCAP file.
struct Summary {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<ChunkIndex> chunks;  // ascending by offset, without overlaps
  std::vector<MetadataIndex> metadata;
  std::optional<Statistics> statistics;
  std::uint64_t data_end = 0;  // offset of the record that ends the messages
};

// Returns the summary of a file with a footer; nothing if the file has no summary, or if some messages are not in the
// summary's index. All offsets in the result lie between header_end (end of the header) and the summary. Throws Error
// if the summary is damaged, contradicts itself or is larger than `most_bytes`.
std::optional<Summary> read_summary(const InputFile& file, std::uint64_t header_end, std::size_t most_bytes);

class Reader {
 public:
  // Throws Error for a file that cannot be opened, is not an MCAP file of version 0, ends within its header, or has a
  // damaged summary. most_bytes: limit of each of these: one chunk (plain or compressed), one record, the summary, all
  // metadata, all schemas and channels. Larger items are an Error. Sorting uses at most 8 * most_bytes.
  explicit Reader(const std::filesystem::path& file, std::size_t most_bytes = largest_record);

  // Returns whether the file has a usable summary. If so, all channels and metadata are known from the beginning.
  // Otherwise, only the channels and metadata before the position of next() are known.
  bool indexed() const { return summary_.has_value(); }
  const std::map<ChannelId, Channel>& channels() const { return definitions_.channels(); }
  const std::vector<Metadata>& metadata() const { return metadata_; }
  const Statistics* statistics() const;  // null if the file has no summary with statistics

  // Starts again from the beginning of the file and delivers only the selected messages.
  void select(Selection selection);

  // Reads the next selected message; returns false at the end. Message::data is valid until the next call. Throws
  // Error at a damaged chunk; the following call continues after this chunk.
  bool next(Message& message);

  bool has_lz4() const { return has_lz4_; }  // whether LZ4 compresses a chunk that was read

  // Says where the file was cut off; nothing for a complete file. Known after next() has returned false.
  const std::optional<std::string>& cut_off() const { return cut_off_; }

 private:
  struct Held {
    Message message;
    std::string data;  // of this message
  };

  void open_summary();
  bool next_in_file(Message& message, std::uint64_t until);
  bool next_by_time(Message& message);
  void hold(const Message& message);
  bool next_indexed_chunk(std::uint64_t until);
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
  std::uint64_t kept_until_ = 0;  // offset up to which metadata is known

  Selection selection_;
  enum class Wanted : std::uint8_t { unknown, no, yes };
  std::vector<Wanted> wanted_;  // by channel

  Decompressor decompressor_;
  // Chunks in the order of reading, each with the earliest possible time of its messages; used only with a summary.
  std::vector<std::pair<std::uint64_t, const ChunkIndex*>> chunks_;
  std::size_t next_chunk_ = 0;  // index of the next chunk
  RecordWalk walk_;             // used only without a summary
  bool walk_is_over_ = false, in_summary_ = false;
  std::string stored_;   // a record as stored in the file
  std::string records_;  // schemas, channels and messages of the current chunk
  Decoder rest_{{}};     // the part of records_ that has not been delivered
  std::uint64_t place_ = 0;
  bool has_lz4_ = false;
  std::optional<std::string> cut_off_;

  std::multimap<std::tuple<std::uint64_t, ChannelId, std::uint32_t>, Held> held_;  // by time, channel, sequence
  std::size_t held_bytes_ = 0;
  Held due_;  // the last message delivered by time
};

}  // namespace regista::mcap
