// SPDX-License-Identifier: MIT
// Encodes MCAP records into bytes and decodes bytes into records. Integers are little-endian. A decoder refuses a
// length that reaches beyond the end of its record. Chunks have checksums and are compressed with Zstandard (RFC 8878).
// Other programs also use LZ4. All chunks of a file use the same Compressor or Decompressor.
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

#include "mcap/records.hpp"

struct ZSTD_CCtx_s;  // from <zstd.h>, which only encoding.cpp includes
struct ZSTD_DCtx_s;

namespace regista::mcap {

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
void append_message_index(std::string& to, ChannelId channel, const std::vector<MessagePlace>& places);

void append_summary_offset(std::string& to, Opcode group, std::uint64_t start, std::uint64_t length);
void append_data_end(std::string& to, std::uint32_t checksum);

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
Footer decode_footer(std::string_view content);

}  // namespace regista::mcap
