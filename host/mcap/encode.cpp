// SPDX-License-Identifier: MIT
#include "mcap/encode.hpp"

namespace regista::mcap {
namespace {

void append_string(std::string& to, std::string_view text) {
  append_integer(to, static_cast<std::uint32_t>(text.size()));
  to.append(text);
}

void append_pairs(std::string& to, const Pairs& pairs) {
  std::size_t length = 0;
  for (const auto& [key, value] : pairs) length += 4 + key.size() + 4 + value.size();
  append_integer(to, static_cast<std::uint32_t>(length));
  for (const auto& [key, value] : pairs) {
    append_string(to, key);
    append_string(to, value);
  }
}

void append_id(std::string& to, SchemaId id) { append_integer(to, static_cast<std::uint16_t>(id)); }
void append_id(std::string& to, ChannelId id) { append_integer(to, static_cast<std::uint16_t>(id)); }

void append_prefix(std::string& to, Opcode opcode, std::uint64_t length) {
  append_integer(to, static_cast<std::uint8_t>(opcode));
  append_integer(to, length);
}

// A record whose length becomes known at its end.
class OpenRecord {
 public:
  OpenRecord(std::string& to, Opcode opcode) : to_(to), begin_(to.size()) { append_prefix(to, opcode, 0); }
  ~OpenRecord() {
    const std::uint64_t length = to_.size() - begin_ - record_prefix;
    for (std::size_t i = 0; i < 8; ++i) to_[begin_ + 1 + i] = static_cast<char>((length >> (8 * i)) & 0xff);
  }
  OpenRecord(const OpenRecord&) = delete;
  OpenRecord& operator=(const OpenRecord&) = delete;

 private:
  std::string& to_;
  std::size_t begin_;
};

}  // namespace

void append_record(std::string& to, const Header& header) {
  const OpenRecord record(to, Opcode::header);
  append_string(to, "");  // no profile
  append_string(to, header.library);
}

void append_record(std::string& to, const Schema& schema) {
  const OpenRecord record(to, Opcode::schema);
  append_id(to, schema.id);
  append_string(to, schema.name);
  append_string(to, schema.encoding);
  append_string(to, schema.data);
}

void append_record(std::string& to, const Channel& channel) {
  const OpenRecord record(to, Opcode::channel);
  append_id(to, channel.id);
  append_id(to, channel.schema);
  append_string(to, channel.topic);
  append_string(to, channel.message_encoding);
  append_pairs(to, {});  // its metadata
}

void append_record(std::string& to, const Message& message) {
  append_prefix(to, Opcode::message, message_fields + message.data.size());
  append_id(to, message.channel);
  append_integer(to, message.sequence);
  append_integer(to, message.log_time);
  append_integer(to, message.publish_time);
  to.append(message.data);
}

void append_record(std::string& to, const Metadata& metadata) {
  const OpenRecord record(to, Opcode::metadata);
  append_string(to, metadata.name);
  append_pairs(to, metadata.pairs);
}

void append_record(std::string& to, const ChunkIndex& index) {
  const OpenRecord record(to, Opcode::chunk_index);
  append_integer(to, index.first_time);
  append_integer(to, index.last_time);
  append_integer(to, index.offset);
  append_integer(to, index.length);
  append_integer(to, static_cast<std::uint32_t>(index.message_indexes.size() * (2 + 8)));
  for (const auto& [channel, offset] : index.message_indexes) {
    append_id(to, channel);
    append_integer(to, offset);
  }
  append_integer(to, index.message_index_length);
  append_string(to, index.compression);
  append_integer(to, index.compressed_size);
  append_integer(to, index.uncompressed_size);
}

void append_record(std::string& to, const MetadataIndex& index) {
  const OpenRecord record(to, Opcode::metadata_index);
  append_integer(to, index.offset);
  append_integer(to, index.length);
  append_string(to, index.name);
}

void append_record(std::string& to, const Statistics& statistics) {
  const OpenRecord record(to, Opcode::statistics);
  append_integer(to, statistics.messages);
  append_integer(to, statistics.schemas);
  append_integer(to, statistics.channels);
  append_integer(to, std::uint32_t{0});  // attachments
  append_integer(to, statistics.metadata);
  append_integer(to, statistics.chunks);
  append_integer(to, statistics.first_time);
  append_integer(to, statistics.last_time);
  append_integer(to, static_cast<std::uint32_t>(statistics.messages_of.size() * (2 + 8)));
  for (const auto& [channel, count] : statistics.messages_of) {
    append_id(to, channel);
    append_integer(to, count);
  }
}

void append_chunk_fields(std::string& to, const ChunkIndex& index, std::uint32_t checksum) {
  append_prefix(to, Opcode::chunk, index.length - record_prefix);
  append_integer(to, index.first_time);
  append_integer(to, index.last_time);
  append_integer(to, index.uncompressed_size);
  append_integer(to, checksum);
  append_string(to, index.compression);
  append_integer(to, index.compressed_size);
}

void append_message_index(std::string& to, ChannelId channel, const std::vector<MessagePlace>& places) {
  const OpenRecord record(to, Opcode::message_index);
  append_id(to, channel);
  append_integer(to, static_cast<std::uint32_t>(places.size() * 16));
  for (const auto& [time, offset] : places) {
    append_integer(to, time);
    append_integer(to, offset);
  }
}

void append_summary_offset(std::string& to, Opcode group, std::uint64_t start, std::uint64_t length) {
  const OpenRecord record(to, Opcode::summary_offset);
  append_integer(to, static_cast<std::uint8_t>(group));
  append_integer(to, start);
  append_integer(to, length);
}

void append_data_end(std::string& to, std::uint32_t checksum) {
  append_prefix(to, Opcode::data_end, 4);
  append_integer(to, checksum);
}

void append_footer_fields(std::string& to, std::uint64_t summary_start, std::uint64_t summary_offset_start) {
  append_prefix(to, Opcode::footer, footer_content);
  append_integer(to, summary_start);
  append_integer(to, summary_offset_start);
}

}  // namespace regista::mcap
