// SPDX-License-Identifier: MIT
// The contents of an MCAP file (https://mcap.dev/spec) as plain values. All times are nanoseconds since a beginning
// that the writer chooses (for a match: its start). Binary data is held in strings; names and metadata are UTF-8. This
// is version 0 of the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regista::mcap {

// The first and the last bytes of a file. The byte at version_in_magic is the major version.
inline constexpr std::string_view magic{"\x89MCAP0\r\n", 8};
inline constexpr std::size_t version_in_magic = 5;

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0a,
  statistics = 0x0b,
  metadata = 0x0c,
  metadata_index = 0x0d,
  summary_offset = 0x0e,
  data_end = 0x0f,
};

inline constexpr std::size_t record_prefix = 1 + 8;  // opcode, length of the content
inline constexpr std::size_t message_fields = 2 + 4 + 8 + 8;
inline constexpr std::size_t footer_content = 8 + 8 + 4;
inline constexpr std::size_t footer_record = record_prefix + footer_content;
inline constexpr std::size_t data_end_record = record_prefix + 4;

// Limits in bytes. largest_item: one message, schema, channel or metadata record of a writer. largest_chunk_size: a
// chunk of a writer before its last message. The sum of both is below largest_record, the default limit of a reader.
inline constexpr std::size_t largest_item = std::size_t{32} << 20;
inline constexpr std::size_t largest_chunk_size = std::size_t{16} << 20;
inline constexpr std::size_t largest_record = std::size_t{64} << 20;

enum class SchemaId : std::uint16_t { none = 0 };
enum class ChannelId : std::uint16_t {};

using Pairs = std::map<std::string, std::string>;

struct Header {
  static constexpr Opcode opcode = Opcode::header;
  std::string library;  // program that wrote the file
};

// The format of the messages of some channels.
struct Schema {
  static constexpr Opcode opcode = Opcode::schema;
  SchemaId id = SchemaId::none;
  std::string name;
  std::string encoding;  // "jsonschema", "protobuf", ...; empty: no schema
  std::string data;
  bool operator==(const Schema&) const = default;
};

// A stream of messages of one kind.
struct Channel {
  static constexpr Opcode opcode = Opcode::channel;
  ChannelId id{};
  SchemaId schema = SchemaId::none;
  std::string topic;
  std::string message_encoding;  // "json", "protobuf", ...
  bool operator==(const Channel&) const = default;
};

struct Message {
  ChannelId channel{};
  std::uint32_t sequence = 0;  // counts the messages of a channel, so that gaps are visible; 0: no counting
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::string_view data;  // the creator of the message owns the bytes
};

struct Metadata {
  static constexpr Opcode opcode = Opcode::metadata;
  std::string name;
  Pairs pairs;
  bool operator==(const Metadata&) const = default;
};

// Offsets are in bytes from the start of the file. Lengths include the whole record.
struct ChunkIndex {
  static constexpr Opcode opcode = Opcode::chunk_index;
  std::uint64_t first_time = 0, last_time = 0;  // log times of the chunk's messages; both 0 without messages
  std::uint64_t offset = 0, length = 0;
  std::vector<std::pair<ChannelId, std::uint64_t>> message_indexes;  // offset of the index of each channel, ascending
  std::uint64_t message_index_length = 0;
  std::string compression;  // "zstd", "lz4" or ""
  std::uint64_t compressed_size = 0, uncompressed_size = 0;
};

struct MetadataIndex {
  static constexpr Opcode opcode = Opcode::metadata_index;
  std::uint64_t offset = 0, length = 0;
  std::string name;
};

struct Statistics {
  static constexpr Opcode opcode = Opcode::statistics;
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0, metadata = 0, chunks = 0;
  std::uint64_t first_time = 0, last_time = 0;     // log times of all messages; both 0 without messages
  std::map<ChannelId, std::uint64_t> messages_of;  // only channels with messages
  bool operator==(const Statistics&) const = default;
};

// The fields of each record in the order of the format, for Encoder and Decoder (encoding.hpp). Local variables are
// fields that this library writes empty and ignores when it reads.
template <class Fields>
void visit(Fields& fields, Header& header) {
  std::string profile;
  fields(profile, header.library);
}
template <class Fields>
void visit(Fields& fields, Schema& schema) {
  fields(schema.id, schema.name, schema.encoding, schema.data);
}
template <class Fields>
void visit(Fields& fields, Channel& channel) {
  Pairs metadata;
  fields(channel.id, channel.schema, channel.topic, channel.message_encoding, metadata);
}
template <class Fields>
void visit(Fields& fields, Metadata& metadata) {
  fields(metadata.name, metadata.pairs);
}
template <class Fields>
void visit(Fields& fields, ChunkIndex& index) {
  fields(index.first_time, index.last_time, index.offset, index.length, index.message_indexes,
         index.message_index_length, index.compression, index.compressed_size, index.uncompressed_size);
}
template <class Fields>
void visit(Fields& fields, MetadataIndex& index) {
  fields(index.offset, index.length, index.name);
}
template <class Fields>
void visit(Fields& fields, Statistics& s) {
  std::uint32_t attachments = 0;
  fields(s.messages, s.schemas, s.channels, attachments, s.metadata, s.chunks, s.first_time, s.last_time,
         s.messages_of);
}

}  // namespace regista::mcap
