// SPDX-License-Identifier: MIT
#include "mcap/writer.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "mcap/checksum.hpp"
#include "mcap/error.hpp"
#include "mcap/utf8.hpp"

namespace regista::mcap {
namespace {

constexpr std::size_t most_ids = std::numeric_limits<std::uint16_t>::max();

// Content of a chunk's record without compression name and records.
constexpr std::size_t chunk_fields = 8 + 8 + 8 + 4 + 4 + 8;

}  // namespace

Writer::Writer(const std::filesystem::path& file, const WriterOptions& options)
    : file_(file, options.replace), chunk_size_(options.chunk_size) {
  assert(chunk_size_ >= 1 && chunk_size_ <= largest_chunk_size);
  check_text("the profile", options.profile);
  check_text("the name of the library", options.library);
  if (options.compression == Compression::zstd) compressor_.emplace(options.level);
  std::string begin(magic);
  append_record(begin, Header{options.profile, options.library});
  file_.append(begin);
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
  append_record(records_, schemas_.back());
  statistics_.schemas = static_cast<std::uint16_t>(schemas_.size());
  if (records_.size() >= chunk_size_) finish_chunk();
  return id;
}

ChannelId Writer::add_channel(std::string_view topic, std::string_view message_encoding, SchemaId schema,
                              const Pairs& metadata) {
  check_open();
  assert(static_cast<std::size_t>(schema) <= schemas_.size());
  check_text("a topic", topic);
  check_text("the encoding of messages", message_encoding);
  check_pairs("the metadata of a channel", metadata);
  check_size("a channel", topic.size() + message_encoding.size());
  if (channels_.size() == most_ids) throw Error(file_.path(), "cannot hold more than 65535 channels");
  const auto id = static_cast<ChannelId>(channels_.size() + 1);
  channels_.push_back({id, schema, std::string(topic), std::string(message_encoding), metadata});
  places_.emplace_back();
  append_record(records_, channels_.back());
  statistics_.channels = static_cast<std::uint32_t>(channels_.size());
  if (records_.size() >= chunk_size_) finish_chunk();
  return id;
}

void Writer::write(const Message& message) {
  check_open();
  check_size("a message", message.data.size());
  const auto channel = static_cast<std::size_t>(message.channel) - 1;
  assert(channel < channels_.size());
  records_.reserve(records_.size() + record_prefix + message_fields + message.data.size());
  places_[channel].emplace_back(message.log_time, records_.size());
  append_record(records_, message);

  first_time_ = messages_ == 0 ? message.log_time : std::min(first_time_, message.log_time);
  last_time_ = messages_ == 0 ? message.log_time : std::max(last_time_, message.log_time);
  ++messages_;
  const bool is_first = statistics_.messages == 0;
  statistics_.first_time = is_first ? message.log_time : std::min(statistics_.first_time, message.log_time);
  statistics_.last_time = is_first ? message.log_time : std::max(statistics_.last_time, message.log_time);
  ++statistics_.messages;
  ++statistics_.messages_of[message.channel];
  if (records_.size() >= chunk_size_) finish_chunk();
}

void Writer::write(const Metadata& metadata) {
  check_open();
  check_text("the name of metadata", metadata.name);
  check_pairs("metadata", metadata.pairs);
  std::string record;
  append_record(record, metadata);
  metadata_.push_back({file_.size(), record.size(), metadata.name});
  file_.append(record);
  ++statistics_.metadata;
}

void Writer::write(const Attachment& attachment) {
  check_open();
  check_text("the name of an attachment", attachment.name);
  check_text("the media type of an attachment", attachment.media_type);
  check_size("an attachment", attachment.name.size() + attachment.media_type.size() + attachment.data.size());
  std::string record;
  append_record(record, attachment);
  attachments_.push_back({file_.size(), record.size(), attachment.log_time, attachment.create_time,
                          attachment.data.size(), attachment.name, attachment.media_type});
  file_.append(record);
  ++statistics_.attachments;
}

void Writer::finish_chunk() {
  check_open();
  if (records_.empty()) return;
  ChunkIndex index;
  index.first_time = messages_ == 0 ? 0 : first_time_;
  index.last_time = messages_ == 0 ? 0 : last_time_;
  index.offset = file_.size();
  index.compression = compressor_ ? "zstd" : "";
  index.uncompressed_size = records_.size();

  // The fields stand before the records and tell their compressed size; they are written over once it is known.
  const std::size_t prefix = record_prefix + chunk_fields + index.compression.size();
  finished_.assign(prefix, '\0');
  if (compressor_) {
    compressor_->append(finished_, records_);
  } else {
    finished_.append(records_);
  }
  index.length = finished_.size();
  index.compressed_size = finished_.size() - prefix;
  std::string fields;
  append_chunk_fields(fields, index, checksum(records_));
  assert(fields.size() == prefix);
  finished_.replace(0, prefix, fields);

  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].empty()) continue;
    index.message_indexes.emplace_back(channels_[i].id, index.offset + finished_.size());
    append_message_index(finished_, channels_[i].id, places_[i]);
  }
  index.message_index_length = finished_.size() - index.length;

  file_.append(finished_);
  chunks_.push_back(std::move(index));
  ++statistics_.chunks;
  records_.clear();
  for (std::vector<MessagePlace>& places : places_) places.clear();
  messages_ = 0;
}

void Writer::close() {
  if (!file_.is_open()) return;
  finish_chunk();
  std::string end;
  append_data_end(end, file_.checksum());
  file_.append(end);
  file_.append(summary());
  file_.close();
}

std::string Writer::summary() const {
  std::string bytes, offsets;
  const std::uint64_t start = file_.size();
  const auto append_group = [&](Opcode opcode, const auto& records) {
    if (records.empty()) return;
    const std::size_t before = bytes.size();
    for (const auto& record : records) append_record(bytes, record);
    append_summary_offset(offsets, opcode, start + before, bytes.size() - before);
  };
  append_group(Opcode::schema, schemas_);
  append_group(Opcode::channel, channels_);
  append_group(Opcode::statistics, std::vector<Statistics>{statistics_});
  append_group(Opcode::chunk_index, chunks_);
  append_group(Opcode::attachment_index, attachments_);
  append_group(Opcode::metadata_index, metadata_);
  const std::uint64_t offset_start = start + bytes.size();
  bytes += offsets;
  append_footer_fields(bytes, start, offset_start);
  append_integer(bytes, checksum(bytes));
  bytes += magic;
  return bytes;
}

void Writer::check_open() const {
  assert(file_.is_open());
  file_.throw_if_failed();
}

void Writer::check_text(std::string_view what, std::string_view text) const {
  if (!is_utf8(text)) throw Error(file_.path(), "cannot hold " + std::string(what) + " that is not UTF-8");
  check_size(what, text.size());
}

void Writer::check_size(std::string_view what, std::size_t bytes) const {
  if (bytes <= largest_item) return;
  throw Error(file_.path(), "cannot hold " + std::string(what) + " of " + std::to_string(bytes) + " bytes; at most " +
                                std::to_string(largest_item) + " are possible");
}

void Writer::check_pairs(std::string_view what, const Pairs& pairs) const {
  std::size_t size = 0;
  for (const auto& [key, value] : pairs) {
    check_text(what, key);
    check_text(what, value);
    size += 4 + key.size() + 4 + value.size();
  }
  check_size(what, size);
}

}  // namespace regista::mcap
