// SPDX-License-Identifier: MIT
// The fixed bytes of MCAP files, version 0 (https://mcap.dev/spec).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace regista::mcap {

// First and last bytes of a file. The sixth is the major version.
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

// The most that is written as one message, schema or metadata record, and as one chunk before the message that fills
// it. Together they stay below what the reader takes for one record.
inline constexpr std::size_t largest_item = std::size_t{32} << 20;
inline constexpr std::size_t largest_chunk_size = std::size_t{16} << 20;
inline constexpr std::size_t largest_record = std::size_t{64} << 20;

}  // namespace regista::mcap
