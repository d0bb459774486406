// SPDX-License-Identifier: MIT
// The description of the contents of an MCAP file: schemas, channels, and the index at the end of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "mcap/file_io.hpp"
#include "mcap/records.hpp"

namespace regista::mcap {

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

// Returns whether the file ends with a footer, as a finished file does.
bool has_footer(const InputFile& file);

// Returns the summary of a file with a footer; nothing if the file has no summary, or if some messages are not in the
// summary's index. All offsets in the result lie between header_end (end of the header) and the summary. Throws Error
// if the summary is damaged, contradicts itself or is larger than `most_bytes`.
std::optional<Summary> read_summary(const InputFile& file, std::uint64_t header_end, std::size_t most_bytes);

}  // namespace regista::mcap
