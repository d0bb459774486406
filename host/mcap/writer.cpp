// SPDX-License-Identifier: MIT
#include "mcap/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace regista::mcap {
namespace {

constexpr std::size_t most_ids = std::numeric_limits<std::uint16_t>::max();

// Length of a chunk's fields without compression name and records.
constexpr std::size_t chunk_fields = 8 + 8 + 8 + 4 + 4 + 8;

}  // namespace

Writer::Writer(const std::filesystem::path& file, const WriterOptions& options)
    : file_(file, options.replace), chunk_size_(options.chunk_size) {
  assert(chunk_size_ >= 1 && chunk_size_ <= largest_chunk_size);
  check_text("the name of the library", options.library);
  std::string begin(magic);
  append_record(begin, Header{options.library});
  file_.append(begin);
  if (options.background) background_.emplace();
}

Writer::~Writer() = default;

SchemaId Writer::add_schema(std::string_view name, std::string_view encoding, std::string_view data) {
  check_open();
  check_text("the name of a schema", name);
  check_text("the encoding of a schema", encoding);
  check_size("a schema", name.size() + encoding.size() + data.size());
  if (schemas_.size() == most_ids) throw Error(file_.path(), "cannot hold more than 65535 schemas");
  const auto id = static_cast<SchemaId>(schemas_.size() + 1);
  schemas_.push_back({id, std::string(name), std::string(encoding), std::string(data)});
  append_record(filling_.records, schemas_.back());
  statistics_.schemas = static_cast<std::uint16_t>(schemas_.size());
  if (filling_.records.size() >= chunk_size_) finish_chunk();
  return id;
}

ChannelId Writer::add_channel(std::string_view topic, std::string_view message_encoding, SchemaId schema) {
  check_open();
  assert(static_cast<std::size_t>(schema) <= schemas_.size());
  check_text("a topic", topic);
  check_text("the encoding of messages", message_encoding);
  check_size("a channel", topic.size() + message_encoding.size());
  if (channels_.size() == most_ids) throw Error(file_.path(), "cannot hold more than 65535 channels");
  const auto id = static_cast<ChannelId>(channels_.size() + 1);
  channels_.push_back({id, schema, std::string(topic), std::string(message_encoding)});
  filling_.places.emplace_back();
  append_record(filling_.records, channels_.back());
  statistics_.channels = static_cast<std::uint32_t>(channels_.size());
  if (filling_.records.size() >= chunk_size_) finish_chunk();
  return id;
}

void Writer::write(const Message& message) {
  check_open();
  check_size("a message", message.data.size());
  const auto channel = static_cast<std::size_t>(message.channel) - 1;
  assert(channel < channels_.size());
  filling_.records.reserve(filling_.records.size() + record_prefix + message_fields + message.data.size());
  filling_.places[channel].emplace_back(message.log_time, filling_.records.size());
  append_record(filling_.records, message);

  const auto count = [time = message.log_time](auto& in) {
    in.first_time = in.messages == 0 ? time : std::min(in.first_time, time);
    in.last_time = std::max(in.last_time, time);
    ++in.messages;
  };
  count(filling_);
  count(statistics_);
  ++statistics_.messages_of[message.channel];
  if (filling_.records.size() >= chunk_size_) finish_chunk();
}

void Writer::write(const Metadata& metadata) {
  check_open();
  settle();
  check_text("the name of metadata", metadata.name);
  std::size_t size = 0;
  for (const auto& [key, value] : metadata.pairs) {
    check_text("metadata", key);
    check_text("metadata", value);
    size += 4 + key.size() + 4 + value.size();
  }
  check_size("metadata", size);
  std::string record;
  append_record(record, metadata);
  metadata_.push_back({file_.size(), record.size(), metadata.name});
  file_.append(record);
  ++statistics_.metadata;
}

void Writer::finish_chunk() {
  check_open();
  if (filling_.records.empty()) return;
  if (!background_) return store(filling_);
  background_->wait();
  std::swap(filling_, finished_);
  filling_.places.resize(channels_.size());
  background_->begin([this] { store(finished_); });
}

void Writer::store(Chunk& chunk) {
  ChunkIndex index;
  index.first_time = chunk.first_time;
  index.last_time = chunk.last_time;
  index.offset = file_.size();
  index.compression = "zstd";
  index.uncompressed_size = chunk.records.size();

  // The fields come before the records but contain the compressed size, so they are filled in when this size is known.
  const std::size_t prefix = record_prefix + chunk_fields + index.compression.size();
  bytes_.assign(prefix, '\0');
  compressor_.append(bytes_, chunk.records);
  index.length = bytes_.size();
  index.compressed_size = bytes_.size() - prefix;
  std::string fields;
  append_chunk_fields(fields, index, checksum(chunk.records));
  assert(fields.size() == prefix);
  bytes_.replace(0, prefix, fields);

  for (std::size_t i = 0; i < chunk.places.size(); ++i) {
    if (chunk.places[i].empty()) continue;
    const auto channel = static_cast<ChannelId>(i + 1);
    index.message_indexes.emplace_back(channel, index.offset + bytes_.size());
    append_fields(bytes_, Opcode::message_index, channel, chunk.places[i]);
  }
  index.message_index_length = bytes_.size() - index.length;

  file_.append(bytes_);
  chunks_.push_back(std::move(index));
  chunk.records.clear();
  for (std::vector<MessagePlace>& places : chunk.places) places.clear();
  chunk.messages = chunk.first_time = chunk.last_time = 0;
}

void Writer::close() {
  if (closed_) return;
  settle();
  finish_chunk();
  settle();
  std::string end;
  append_data_end(end, file_.checksum());
  file_.append(end);
  statistics_.chunks = static_cast<std::uint32_t>(chunks_.size());
  file_.append(summary());
  file_.close();
  closed_ = true;
}

void Writer::settle() {
  if (background_) background_->wait();
}

std::string Writer::summary() const {
  std::string bytes, offsets;
  const std::uint64_t start = file_.size();
  const auto append_group = [&](Opcode opcode, const auto& records) {
    if (records.empty()) return;
    const std::size_t before = bytes.size();
    for (const auto& record : records) append_record(bytes, record);
    append_fields(offsets, Opcode::summary_offset, opcode, start + before, bytes.size() - before);
  };
  append_group(Opcode::schema, schemas_);
  append_group(Opcode::channel, channels_);
  append_group(Opcode::statistics, std::vector<Statistics>{statistics_});
  append_group(Opcode::chunk_index, chunks_);
  append_group(Opcode::metadata_index, metadata_);
  const std::uint64_t offset_start = start + bytes.size();
  bytes += offsets;
  append_footer_fields(bytes, start, offset_start);
  append_integer(bytes, checksum(bytes));
  bytes += magic;
  return bytes;
}

void Writer::check_open() {
  assert(!closed_);
  background_ ? background_->throw_if_failed() : file_.throw_if_failed();
}

void Writer::check_text(std::string_view what, std::string_view text) const {
  if (!is_utf8(text)) throw Error(file_.path(), fmt::format("cannot hold {} that is not UTF-8", what));
  check_size(what, text.size());
}

void Writer::check_size(std::string_view what, std::size_t bytes) const {
  if (bytes <= largest_item) return;
  throw Error(file_.path(),
              fmt::format("cannot hold {} of {} bytes; at most {} are possible", what, bytes, largest_item));
}

}  // namespace regista::mcap
