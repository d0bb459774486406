// SPDX-License-Identifier: MIT
// The bytes of MCAP records -> values. No length that stands in a record is believed beyond the record's end.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mcap/format.hpp"
#include "mcap/records.hpp"

namespace regista::mcap {

// Bytes that are no record. Who knows file and place turns it into an Error.
struct Malformed {
  std::string why;
};

// Reads from the front of `bytes`; every function throws Malformed where too few are left.
class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : rest_(bytes) {}
  std::string_view rest() const { return rest_; }
  std::uint8_t u8() { return integer<std::uint8_t>(); }
  std::uint16_t u16() { return integer<std::uint16_t>(); }
  std::uint32_t u32() { return integer<std::uint32_t>(); }
  std::uint64_t u64() { return integer<std::uint64_t>(); }
  std::string_view bytes(std::uint64_t count);
  std::string_view string() { return bytes(u32()); }  // length in 4 bytes, then the text
  Pairs pairs();

 private:
  template <class Integer>
  Integer integer() {
    const std::string_view from = bytes(sizeof(Integer));
    Integer value = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      value =
          static_cast<Integer>(value | static_cast<Integer>(Integer{static_cast<unsigned char>(from[i])} << (8 * i)));
    }
    return value;
  }

  std::string_view rest_;
};

// A record in memory, content without its prefix.
struct RawRecord {
  Opcode opcode{};
  std::string_view content;
};

// Takes the next record from the front.
RawRecord take_record(Decoder& from);

// Each takes the content of a record of that kind. Bytes after the known fields are ignored, as the format wants it.
Header decode_header(std::string_view content);
Schema decode_schema(std::string_view content);
Channel decode_channel(std::string_view content);
Message decode_message(std::string_view content);  // its data points into `content`
Metadata decode_metadata(std::string_view content);
ChunkIndex decode_chunk_index(std::string_view content);
MetadataIndex decode_metadata_index(std::string_view content);
Statistics decode_statistics(std::string_view content);

struct Chunk {
  std::uint64_t first_time = 0, last_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t checksum = 0;  // of the uncompressed bytes; 0: none
  std::string_view compression;
  std::string_view records;  // as they stand in the file
};
Chunk decode_chunk(std::string_view content);  // points into `content`

struct Footer {
  std::uint64_t summary_start = 0;
  std::uint32_t summary_checksum = 0;
};
Footer decode_footer(std::string_view content);

}  // namespace regista::mcap
