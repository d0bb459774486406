// SPDX-License-Identifier: MIT
// What an MCAP file holds (https://mcap.dev/spec), as plain values. All times are nanoseconds since a beginning that
// the writer chooses (for a match: its kick-off). Bytes of any kind travel as strings; names and metadata are UTF-8.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regista::mcap {

enum class SchemaId : std::uint16_t { none = 0 };
enum class ChannelId : std::uint16_t {};

using Pairs = std::map<std::string, std::string>;

struct Header {
  std::string library;  // what wrote the file
};

// How the messages of some channels are built.
struct Schema {
  SchemaId id = SchemaId::none;
  std::string name;
  std::string encoding;  // "jsonschema", "protobuf", ...; empty: there is no schema
  std::string data;
  bool operator==(const Schema&) const = default;
};

// A stream of messages of one kind.
struct Channel {
  ChannelId id{};
  SchemaId schema = SchemaId::none;
  std::string topic;
  std::string message_encoding;  // "json", "protobuf", ...
  bool operator==(const Channel&) const = default;
};

struct Message {
  ChannelId channel{};
  std::uint32_t sequence = 0;  // counts the messages of a channel, so that gaps are seen; 0 where nobody counts
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::string_view data;  // belongs to whoever made the message
};

struct Metadata {
  std::string name;
  Pairs pairs;
  bool operator==(const Metadata&) const = default;
};

// Places of records are byte offsets from the start of the file, lengths count the whole record.
struct ChunkIndex {
  std::uint64_t first_time = 0, last_time = 0;  // of its messages; both 0 where it has none
  std::uint64_t offset = 0, length = 0;
  std::vector<std::pair<ChannelId, std::uint64_t>> message_indexes;  // of which channels it has messages; ascending
  std::uint64_t message_index_length = 0;
  std::string compression;  // "zstd", "lz4" or ""
  std::uint64_t compressed_size = 0, uncompressed_size = 0;
};

struct MetadataIndex {
  std::uint64_t offset = 0, length = 0;
  std::string name;
};

struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, metadata = 0, chunks = 0;
  std::uint64_t first_time = 0, last_time = 0;     // of all messages; both 0 where there is none
  std::map<ChannelId, std::uint64_t> messages_of;  // only channels that have messages
  bool operator==(const Statistics&) const = default;
};

}  // namespace regista::mcap
