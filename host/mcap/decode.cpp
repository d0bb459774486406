// SPDX-License-Identifier: MIT
#include "mcap/decode.hpp"

namespace regista::mcap {

std::string_view Decoder::bytes(std::uint64_t count) {
  if (count > rest_.size()) throw Malformed{"a record ends within a field"};
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

Pairs Decoder::pairs() {
  Decoder in(string());
  Pairs pairs;
  while (!in.rest().empty()) {
    const std::string_view key = in.string();
    const std::string_view value = in.string();
    if (!pairs.emplace(key, value).second) throw Malformed{"a map has a key twice"};
  }
  return pairs;
}

RawRecord take_record(Decoder& from) {
  RawRecord record;
  record.opcode = static_cast<Opcode>(from.u8());
  const std::uint64_t length = from.u64();
  record.content = from.bytes(length);
  return record;
}

Header decode_header(std::string_view content) {
  Decoder in(content);
  Header header;
  in.string();  // the profile
  header.library = in.string();
  return header;
}

Schema decode_schema(std::string_view content) {
  Decoder in(content);
  Schema schema;
  schema.id = static_cast<SchemaId>(in.u16());
  schema.name = in.string();
  schema.encoding = in.string();
  schema.data = in.string();
  return schema;
}

Channel decode_channel(std::string_view content) {
  Decoder in(content);
  Channel channel;
  channel.id = static_cast<ChannelId>(in.u16());
  channel.schema = static_cast<SchemaId>(in.u16());
  channel.topic = in.string();
  channel.message_encoding = in.string();
  in.pairs();  // its metadata
  return channel;
}

Message decode_message(std::string_view content) {
  Decoder in(content);
  Message message;
  message.channel = static_cast<ChannelId>(in.u16());
  message.sequence = in.u32();
  message.log_time = in.u64();
  message.publish_time = in.u64();
  message.data = in.rest();
  return message;
}

Metadata decode_metadata(std::string_view content) {
  Decoder in(content);
  Metadata metadata;
  metadata.name = in.string();
  metadata.pairs = in.pairs();
  return metadata;
}

ChunkIndex decode_chunk_index(std::string_view content) {
  Decoder in(content);
  ChunkIndex index;
  index.first_time = in.u64();
  index.last_time = in.u64();
  index.offset = in.u64();
  index.length = in.u64();
  Decoder offsets(in.string());
  while (!offsets.rest().empty()) {
    const auto channel = static_cast<ChannelId>(offsets.u16());
    index.message_indexes.emplace_back(channel, offsets.u64());
  }
  index.message_index_length = in.u64();
  index.compression = in.string();
  index.compressed_size = in.u64();
  index.uncompressed_size = in.u64();
  return index;
}

MetadataIndex decode_metadata_index(std::string_view content) {
  Decoder in(content);
  MetadataIndex index;
  index.offset = in.u64();
  index.length = in.u64();
  index.name = in.string();
  return index;
}

Statistics decode_statistics(std::string_view content) {
  Decoder in(content);
  Statistics statistics;
  statistics.messages = in.u64();
  statistics.schemas = in.u16();
  statistics.channels = in.u32();
  in.u32();  // attachments
  statistics.metadata = in.u32();
  statistics.chunks = in.u32();
  statistics.first_time = in.u64();
  statistics.last_time = in.u64();
  Decoder counts(in.string());
  while (!counts.rest().empty()) {
    const auto channel = static_cast<ChannelId>(counts.u16());
    statistics.messages_of[channel] = counts.u64();
  }
  return statistics;
}

Chunk decode_chunk(std::string_view content) {
  Decoder in(content);
  Chunk chunk;
  chunk.first_time = in.u64();
  chunk.last_time = in.u64();
  chunk.uncompressed_size = in.u64();
  chunk.checksum = in.u32();
  chunk.compression = in.string();
  const std::uint64_t length = in.u64();
  chunk.records = in.bytes(length);
  return chunk;
}

Footer decode_footer(std::string_view content) {
  Decoder in(content);
  Footer footer;
  footer.summary_start = in.u64();
  in.u64();  // where the summary offsets stand
  footer.summary_checksum = in.u32();
  return footer;
}

}  // namespace regista::mcap
