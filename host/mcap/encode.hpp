// SPDX-License-Identifier: MIT
// Values -> the bytes of MCAP records, appended to a string. Integers are little-endian.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mcap/format.hpp"
#include "mcap/records.hpp"

namespace regista::mcap {

template <class Integer>
void append_integer(std::string& to, Integer value) {
  char bytes[sizeof(Integer)];
  for (std::size_t i = 0; i < sizeof(Integer); ++i) bytes[i] = static_cast<char>((value >> (8 * i)) & 0xff);
  to.append(bytes, sizeof(Integer));
}

void append_record(std::string& to, const Header& header);
void append_record(std::string& to, const Schema& schema);
void append_record(std::string& to, const Channel& channel);
void append_record(std::string& to, const Message& message);
void append_record(std::string& to, const Metadata& metadata);
void append_record(std::string& to, const ChunkIndex& index);
void append_record(std::string& to, const MetadataIndex& index);
void append_record(std::string& to, const Statistics& statistics);

// A chunk's record up to its compressed bytes, which follow.
void append_chunk_fields(std::string& to, const ChunkIndex& index, std::uint32_t checksum);

// Time of a message and its place among the uncompressed bytes of a chunk.
using MessagePlace = std::pair<std::uint64_t, std::uint64_t>;
void append_message_index(std::string& to, ChannelId channel, const std::vector<MessagePlace>& places);

void append_summary_offset(std::string& to, Opcode group, std::uint64_t start, std::uint64_t length);
void append_data_end(std::string& to, std::uint32_t checksum);

// The footer up to its checksum, which covers these bytes too.
void append_footer_fields(std::string& to, std::uint64_t summary_start, std::uint64_t summary_offset_start);

}  // namespace regista::mcap
