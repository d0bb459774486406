// SPDX-License-Identifier: MIT
// A recording with chunks as other writers may leave them. Without a compression in between a changed byte reaches what
// a chunk holds.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mcap/encoding.hpp"

namespace regista::mcap {

// How a chunk's records are stored, and the name of that.
struct Packing {
  std::string name;
  std::function<std::string(const std::string& records)> pack;
};

// `bytes` are a whole file of our writer.
inline std::string with_packed_chunks(std::string_view bytes, const Packing& packing) {
  Decompressor decompressor;
  std::string out(magic), records;
  std::vector<ChunkIndex> chunks;
  std::vector<MetadataIndex> metadata;
  bool in_summary = false;
  std::uint64_t summary_start = 0;
  for (Decoder in(bytes.substr(magic.size(), bytes.size() - 2 * magic.size())); !in.rest().empty();) {
    const std::string_view before = in.rest();
    const RawRecord record = take_record(in);
    const std::string_view as_it_was = before.substr(0, before.size() - in.rest().size());
    if (record.opcode == Opcode::data_end) {
      append_data_end(out, checksum(out));
      summary_start = out.size();
      in_summary = true;
    } else if (in_summary) {
      const bool kept =
          record.opcode == Opcode::schema || record.opcode == Opcode::channel || record.opcode == Opcode::statistics;
      if (kept) out += as_it_was;
    } else if (record.opcode == Opcode::chunk) {
      const Chunk chunk = decode_chunk(record.content);
      decompressor.decompress(chunk.records, chunk.uncompressed_size, records);
      const std::string packed = packing.pack(records);
      ChunkIndex& index = chunks.emplace_back();
      index.first_time = chunk.first_time;
      index.last_time = chunk.last_time;
      index.offset = out.size();
      index.compression = packing.name;
      index.compressed_size = packed.size();
      index.uncompressed_size = records.size();
      index.length = record_prefix + record.content.size() - chunk.compression.size() - chunk.records.size() +
                     packing.name.size() + packed.size();
      append_chunk_fields(out, index, chunk.checksum);
      out += packed;
    } else {
      if (record.opcode == Opcode::metadata) {
        metadata.push_back({out.size(), as_it_was.size(), decode<Metadata>(record.content).name});
      } else if (record.opcode == Opcode::message_index) {
        const auto channel = Decoder(record.content).next<ChannelId>();
        chunks.back().message_indexes.emplace_back(channel, out.size());
        chunks.back().message_index_length += as_it_was.size();
      }
      out += as_it_was;
    }
  }
  for (const ChunkIndex& index : chunks) append_record(out, index);
  for (const MetadataIndex& index : metadata) append_record(out, index);
  append_footer_fields(out, summary_start, 0);
  append_integer(out, checksum(std::string_view(out).substr(summary_start)));
  return out.append(magic);
}

inline std::string with_plain_chunks(std::string_view bytes) {
  return with_packed_chunks(bytes, {"", [](const std::string& records) { return records; }});
}

}  // namespace regista::mcap
