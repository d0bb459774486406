// SPDX-License-Identifier: MIT
// The records of an MCAP file (https://mcap.dev/spec, version 0) as plain values, and their encoding as bytes. All
// times are nanoseconds since a beginning that the writer chooses (for a match: its start). Binary data is held in
// strings; names and metadata are UTF-8. Integers are little-endian. A decoder refuses a length that reaches beyond the
// end of its record. Chunks have checksums and are compressed with Zstandard (RFC 8878). Other programs also use LZ4.
// All chunks of a file use the same Compressor or Decompressor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

struct ZSTD_CCtx_s;  // from <zstd.h>, which only encoding.cpp includes
struct ZSTD_DCtx_s;

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

// --- Bytes

// CRC-32 of MCAP (the polynomial of IEEE 802.3, as in zip and gzip). before: checksum of the preceding bytes.
std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

class Compressor {
 public:
  // level: of zstd, 1 to 19. Levels 2, 3, 5 and 7 compress numbers in text worse than 1 (benchmarks/README.md).
  explicit Compressor(int level = 1);
  // Compresses `bytes` and appends them as one frame. The frame depends only on `bytes` and on the version of zstd.
  void append(std::string& to, std::string_view bytes);

 private:
  std::unique_ptr<ZSTD_CCtx_s, std::size_t (*)(ZSTD_CCtx_s*)> context_;
};

class Decompressor {
 public:
  Decompressor();
  // Replaces `to` by the content of the frames. Throws Malformed unless the content has exactly `size` bytes. Memory is
  // allocated only if the frames are long enough to contain `size` bytes.
  void decompress(std::string_view frames, std::uint64_t size, std::string& to);

 private:
  std::unique_ptr<ZSTD_DCtx_s, std::size_t (*)(ZSTD_DCtx_s*)> context_;
};

// Does the same for frames of LZ4 (https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md).
void decompress_lz4(std::string_view frames, std::uint64_t size, std::string& to);

template <class T>
concept Number = std::is_integral_v<T> || std::is_enum_v<T>;

template <class Integer>
void append_integer(std::string& to, Integer value) {
  char bytes[sizeof(Integer)];
  for (std::size_t i = 0; i < sizeof(Integer); ++i) bytes[i] = static_cast<char>((value >> (8 * i)) & 0xff);
  to.append(bytes, sizeof(Integer));
}

// Appends fields: numbers, texts after their length in 4 bytes, and lists of pairs after their length in 4 bytes.
class Encoder {
 public:
  explicit Encoder(std::string& to) : to_(to) {}
  template <class... Values>
  void operator()(const Values&... values) {
    (put(values), ...);
  }

 private:
  template <Number T>
  void put(T value) {
    if constexpr (std::is_enum_v<T>) {
      append_integer(to_, static_cast<std::underlying_type_t<T>>(value));
    } else {
      append_integer(to_, value);
    }
  }
  void put(std::string_view text);
  template <class List>
  requires requires(const List& list) { list.begin()->second; }
  void put(const List& list) {
    std::string bytes;
    Encoder inside(bytes);
    for (const auto& [first, second] : list) inside(first, second);
    put(std::string_view(bytes));
  }

  std::string& to_;
};

// The constructor appends the prefix of a record. The destructor writes the length of the content into the prefix.
class OpenRecord {
 public:
  OpenRecord(std::string& to, Opcode opcode);
  ~OpenRecord();
  OpenRecord(const OpenRecord&) = delete;
  OpenRecord& operator=(const OpenRecord&) = delete;

 private:
  std::string& to_;
  std::size_t begin_;
};

template <class Record>
void append_record(std::string& to, const Record& record) {
  const OpenRecord open(to, Record::opcode);
  Encoder fields(to);
  visit(fields, const_cast<Record&>(record));  // visit() needs a mutable record; an encoder only reads it
}
void append_record(std::string& to, const Message& message);

// Appends a chunk record without the compressed bytes. The caller must append these bytes.
void append_chunk_fields(std::string& to, const ChunkIndex& index, std::uint32_t checksum);

// Log time of a message, and its offset in the uncompressed bytes of the chunk.
using MessagePlace = std::pair<std::uint64_t, std::uint64_t>;

// Appends a record of these fields.
template <class... Fields>
void append_fields(std::string& to, Opcode opcode, const Fields&... fields) {
  const OpenRecord record(to, opcode);
  Encoder{to}(fields...);
}
inline void append_data_end(std::string& to, std::uint32_t checksum) { append_fields(to, Opcode::data_end, checksum); }

// Appends the footer without its checksum. The caller must append the checksum, which also covers the appended bytes.
void append_footer_fields(std::string& to, std::uint64_t summary_start, std::uint64_t summary_offset_start);

// Returns whether the bytes are well-formed UTF-8 (RFC 3629, section 4), as MCAP requires for names and metadata.
bool is_utf8(std::string_view bytes);

// Thrown for bytes that are not a valid record. A caller that knows the file and the position throws an Error instead.
struct Malformed {
  std::string why;
};

// Reads from the front of `bytes`. Every function throws Malformed if too few bytes are left.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : rest_(bytes) {}
  std::string_view rest() const { return rest_; }
  std::string_view bytes(std::uint64_t count);
  template <class... Values>
  void operator()(Values&... values) {
    (take(values), ...);
  }
  template <class Value>
  Value next() {
    Value out{};
    take(out);
    return out;
  }

 private:
  template <Number T>
  void take(T& value) {
    const std::string_view from = bytes(sizeof(T));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) bits |= std::uint64_t{static_cast<unsigned char>(from[i])} << (8 * i);
    value = static_cast<T>(bits);
  }
  void take(std::string_view& text) { text = bytes(next<std::uint32_t>()); }
  void take(std::string& text) { text = next<std::string_view>(); }
  void take(Pairs& pairs);
  void take(std::vector<std::pair<ChannelId, std::uint64_t>>& list);
  void take(std::map<ChannelId, std::uint64_t>& counts);

  std::string_view rest_;
};

// A record in memory. `content` is the record without its prefix.
struct RawRecord {
  Opcode opcode{};
  std::string_view content;
};

// Removes the next record from the front of `from` and returns it.
RawRecord take_record(Decoder& from);

// Decodes the content of a record. Ignores bytes after the known fields, as the format requires.
template <class Record>
Record decode(std::string_view content) {
  Decoder fields(content);
  Record record;
  visit(fields, record);
  return record;
}
Message decode_message(std::string_view content);  // Message::data points into `content`

struct Chunk {
  std::uint64_t first_time = 0, last_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t checksum = 0;  // of the uncompressed bytes; 0: none
  std::string_view compression;
  std::string_view records;  // as stored in the file, possibly compressed
};
Chunk decode_chunk(std::string_view content);  // the views point into `content`

struct Footer {
  std::uint64_t summary_start = 0;
  std::uint32_t summary_checksum = 0;
};
template <class Fields>
void visit(Fields& fields, Footer& footer) {
  std::uint64_t offsets = 0;
  fields(footer.summary_start, offsets, footer.summary_checksum);
}

}  // namespace regista::mcap
