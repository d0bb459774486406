// SPDX-License-Identifier: MIT
#include "mcap/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace regista::mcap {
namespace {

constexpr std::uint64_t always = std::numeric_limits<std::uint64_t>::max();

std::string in_ascii(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    text += c >= 0x20 && c < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return text;
}

Error damaged_at(const InputFile& file, std::uint64_t byte, const std::string& why) {
  return {file.path(), "is damaged at byte " + std::to_string(byte) + ": " + why};
}

// Throws Error unless the file begins like an MCAP file of version 0.
void check_magic(const InputFile& file) {
  if (file.size() == 0) throw Error(file.path(), "is empty");
  std::string begin;
  file.read(0, static_cast<std::size_t>(std::min<std::uint64_t>(file.size(), magic.size())), begin);
  if (magic.starts_with(begin)) {
    if (begin.size() == magic.size()) return;
    throw Error(file.path(), "is cut off at byte " + std::to_string(begin.size()) + ", before its header");
  }
  std::string with_our_version = begin;
  if (begin.size() > version_in_magic) with_our_version[version_in_magic] = magic[version_in_magic];
  if (magic.starts_with(with_our_version)) {
    throw Error(file.path(), fmt::format("is an MCAP file of version {}; this program reads version 0",
                                         in_ascii(begin.substr(version_in_magic, 1))));
  }
  throw Error(file.path(), "is not an MCAP file; it begins with \"" + in_ascii(begin) + "\"");
}

std::string number(SchemaId id) { return std::to_string(static_cast<unsigned>(id)); }
std::string number(ChannelId id) { return std::to_string(static_cast<unsigned>(id)); }

constexpr std::size_t ending = footer_record + magic.size();

void read_record(const RawRecord& record, Summary& summary) {
  switch (record.opcode) {
    case Opcode::schema:
      summary.schemas.push_back(decode<Schema>(record.content));
      break;
    case Opcode::channel:
      summary.channels.push_back(decode<Channel>(record.content));
      break;
    case Opcode::chunk_index:
      summary.chunks.push_back(decode<ChunkIndex>(record.content));
      break;
    case Opcode::metadata_index:
      summary.metadata.push_back(decode<MetadataIndex>(record.content));
      break;
    case Opcode::statistics:
      summary.statistics = decode<Statistics>(record.content);
      break;
    default:
      break;  // ignores attachments, summary offsets and records of later versions
  }
}

// Throws Malformed unless all places are between `begin` and `end` and do not overlap. Sorts the places by offset.
template <class Index>
void check_places(std::vector<Index>& places, std::uint64_t begin, std::uint64_t end) {
  std::ranges::sort(places, {}, &Index::offset);
  for (const Index& place : places) {
    if (place.offset < begin || place.offset > end || place.length < record_prefix ||
        place.length > end - place.offset) {
      throw Malformed{"the summary names a place that cannot be"};
    }
    begin = place.offset + place.length;
  }
}

bool leads_to_all_messages(const Summary& summary) {
  if (!summary.statistics) return !summary.chunks.empty();
  if (summary.statistics->chunks != summary.chunks.size()) return false;
  return !summary.chunks.empty() || summary.statistics->messages == 0;
}

// Returns whether the file ends with a footer, as a finished file does.
bool has_footer(const InputFile& file) {
  if (file.size() < magic.size() + ending) return false;
  std::string bytes;
  file.read(file.size() - ending, ending, bytes);
  Decoder in(bytes);
  return in.next<Opcode>() == Opcode::footer && in.next<std::uint64_t>() == footer_content && bytes.ends_with(magic);
}

}  // namespace

void Definitions::define(Schema&& schema) {
  if (schema.id == SchemaId::none) return;  // the format requires readers to ignore such schemas
  if (const auto known = schemas_.find(schema.id); known != schemas_.end()) {
    if (known->second != schema) throw Malformed{"schema " + number(schema.id) + " is given twice and differs"};
    return;
  }
  take(schema.name.size() + schema.encoding.size() + schema.data.size());
  const SchemaId id = schema.id;
  schemas_.emplace(id, std::move(schema));
}

bool Definitions::define(Channel&& channel) {
  if (const auto known = channels_.find(channel.id); known != channels_.end()) {
    if (known->second != channel) throw Malformed{"channel " + number(channel.id) + " is given twice and differs"};
    return false;
  }
  if (channel.schema != SchemaId::none && !schemas_.contains(channel.schema)) {
    throw Malformed{"channel " + number(channel.id) + " names schema " + number(channel.schema) + ", which is missing"};
  }
  take(channel.topic.size() + channel.message_encoding.size());
  const ChannelId id = channel.id;
  channels_.emplace(id, std::move(channel));
  return true;
}

void Definitions::take(std::size_t bytes) {
  if (bytes > left_) throw Malformed{"its schemas and channels are larger than this program reads"};
  left_ -= bytes;
}

Reader::Reader(const std::filesystem::path& file, std::size_t most_bytes)
    : file_(file),
      most_bytes_(most_bytes),
      definitions_(most_bytes),
      metadata_left_(most_bytes),
      walk_(file_, magic.size()) {
  check_magic(file_);
  const auto place = walk_.next();
  if (!place) throw Error(file_.path(), "is cut off at byte " + std::to_string(file_.size()) + ", within its header");
  if (place->opcode != Opcode::header) damaged(place->offset, "here the header has to stand");
  try {
    decode<Header>(content(place->offset, place->length(), stored_));  // throws for a damaged header
  } catch (const Malformed& malformed) {
    damaged(place->offset, malformed.why);
  }
  header_end_ = walk_.offset();
  has_footer_ = has_footer(file_);
  if (has_footer_) open_summary();
  select({});
}

void Reader::open_summary() {
  summary_ = read_summary(file_, header_end_, most_bytes_);
  if (!summary_) return;
  try {
    for (Schema& schema : summary_->schemas) definitions_.define(std::move(schema));
    for (Channel& channel : summary_->channels) definitions_.define(std::move(channel));
  } catch (const Malformed& malformed) {
    damaged(summary_->data_end, malformed.why);
  }
  summary_->schemas.clear();
  summary_->channels.clear();
  for (const MetadataIndex& index : summary_->metadata) keep_metadata(index.offset, index.length);
}

std::optional<Summary> read_summary(const InputFile& file, std::uint64_t header_end, std::size_t most_bytes) {
  const std::uint64_t footer_start = file.size() - ending;
  std::string footer_bytes;
  file.read(footer_start, footer_record, footer_bytes);
  const Footer footer = decode<Footer>(std::string_view(footer_bytes).substr(record_prefix));
  if (footer.summary_start == 0) return std::nullopt;
  if (footer.summary_start > footer_start || footer.summary_start < header_end ||
      footer.summary_start - header_end < data_end_record) {
    throw damaged_at(file, footer_start, "the footer names a summary that cannot be");
  }
  const std::uint64_t data_end = footer.summary_start - data_end_record;
  const std::uint64_t length = footer_start - data_end;
  if (length > most_bytes) {
    throw Error(file.path(), fmt::format("has a summary of {} bytes; at most {} can be read", length, most_bytes));
  }

  std::string bytes;
  file.read(data_end, length, bytes);
  const std::string_view summary_bytes = std::string_view(bytes).substr(data_end_record);
  if (footer.summary_checksum != 0) {
    const std::string_view covered = std::string_view(footer_bytes).substr(0, footer_record - 4);
    if (checksum(covered, checksum(summary_bytes)) != footer.summary_checksum) {
      throw damaged_at(file, footer.summary_start, "the checksum of the summary is wrong");
    }
  }
  Summary summary;
  summary.data_end = data_end;
  try {
    Decoder in(bytes);
    const RawRecord first = take_record(in);
    if (first.opcode != Opcode::data_end || in.rest().size() != summary_bytes.size()) {
      throw Malformed{"no end of data stands before the summary"};
    }
    while (!in.rest().empty()) read_record(take_record(in), summary);
    check_places(summary.chunks, header_end, data_end);
    check_places(summary.metadata, header_end, data_end);
  } catch (const Malformed& malformed) {
    throw damaged_at(file, data_end, malformed.why);
  }
  if (!leads_to_all_messages(summary)) return std::nullopt;
  return summary;
}

const Statistics* Reader::statistics() const {
  return summary_ && summary_->statistics ? &*summary_->statistics : nullptr;
}

void Reader::select(Selection selection) {
  selection_ = std::move(selection);
  wanted_.clear();
  for (const auto& [id, channel] : channels()) note_wanted(channel);
  chunks_.clear();
  // If the summary names no channels, a chunk must be read after earlier chunks, which may define its channels.
  const bool by_time = selection_.by_time && !channels().empty();
  if (summary_) {
    for (const ChunkIndex& chunk : summary_->chunks) chunks_.emplace_back(by_time ? chunk.first_time : 0, &chunk);
  }
  std::ranges::stable_sort(chunks_, {}, [](const auto& chunk) { return chunk.first; });
  next_chunk_ = 0;
  walk_ = RecordWalk(file_, header_end_);
  walk_is_over_ = in_summary_ = false;
  rest_ = Decoder({});
  cut_off_.reset();
  held_.clear();
  due_ = {};
  held_bytes_ = 0;
}

bool Reader::next(Message& message) {
  return selection_.by_time ? next_by_time(message) : next_in_file(message, always);
}

bool Reader::next_by_time(Message& message) {
  // Reads until no unread chunk can contain an earlier message. Without a summary this is the whole file.
  while (next_in_file(message, held_.empty() ? always : std::get<0>(held_.begin()->first))) hold(message);
  if (held_.empty()) return false;
  due_ = std::move(held_.extract(held_.begin()).mapped());
  held_bytes_ -= sizeof(Held) + due_.data.size();
  message = due_.message;
  message.data = due_.data;
  return true;
}

void Reader::hold(const Message& message) {
  held_bytes_ += sizeof(Held) + message.data.size();
  if (message.log_time >= due_.message.log_time && held_bytes_ / 8 <= most_bytes_) {
    held_.emplace(std::tuple(message.log_time, message.channel, message.sequence),
                  Held{message, std::string(message.data)});
    return;
  }
  select({.first_time = 1, .last_time = 0});
  throw Unsortable(file_.path(),
                   fmt::format("{}; at most {} bytes can be sorted, and only by an index that is true",
                               summary_ ? "is not in the order of time" : "has no index", 8 * most_bytes_));
}

// Reads the next selected message in the order of the file. With a summary, stops at a chunk that begins after `until`.
bool Reader::next_in_file(Message& message, std::uint64_t until) {
  try {
    while (true) {
      if (take_message(message)) return true;
      if (!(summary_ ? next_indexed_chunk(until) : next_walked_record())) return false;
    }
  } catch (const Malformed& malformed) {
    rest_ = Decoder({});
    damaged(place_, malformed.why);
  } catch (...) {
    rest_ = Decoder({});
    throw;
  }
}

// Takes the next selected message from the current chunk; returns false if the chunk has no more.
bool Reader::take_message(Message& message) {
  while (!rest_.rest().empty()) {
    const RawRecord record = take_record(rest_);
    switch (record.opcode) {
      case Opcode::schema:
      case Opcode::channel:
        define(record);
        break;
      case Opcode::message: {
        message = decode_message(record.content);
        const auto channel = static_cast<std::size_t>(message.channel);
        const Wanted wanted = channel < wanted_.size() ? wanted_[channel] : Wanted::unknown;
        if (wanted == Wanted::unknown) {
          throw Malformed{"a message names channel " + std::to_string(channel) + ", which is missing"};
        }
        if (wanted == Wanted::yes && message.log_time >= selection_.first_time &&
            message.log_time <= selection_.last_time) {
          return true;
        }
        break;
      }
      default:
        break;  // ignores records of later versions
    }
  }
  return false;
}

void Reader::define(const RawRecord& record) {
  if (record.opcode == Opcode::schema) return definitions_.define(decode<Schema>(record.content));
  Channel channel = decode<Channel>(record.content);
  const ChannelId id = channel.id;
  if (definitions_.define(std::move(channel))) note_wanted(channels().at(id));
}

void Reader::note_wanted(const Channel& channel) {
  const auto index = static_cast<std::size_t>(channel.id);
  if (index >= wanted_.size()) wanted_.resize(index + 1, Wanted::unknown);
  const auto& topics = selection_.topics;
  const bool wanted = topics.empty() || std::ranges::find(topics, channel.topic) != topics.end();
  wanted_[index] = wanted ? Wanted::yes : Wanted::no;
}

// Loads the next chunk that may contain selected messages; returns false at the end and if it begins after `until`.
bool Reader::next_indexed_chunk(std::uint64_t until) {
  while (next_chunk_ < chunks_.size() && chunks_[next_chunk_].first <= until) {
    const ChunkIndex& chunk = *chunks_[next_chunk_++].second;
    if (!is_wanted(chunk)) continue;
    load_chunk(chunk.offset, chunk.length, &chunk);
    return true;
  }
  return false;
}

bool Reader::is_wanted(const ChunkIndex& chunk) const {
  if (chunk.first_time > selection_.last_time || chunk.last_time < selection_.first_time) return false;
  if (chunk.message_indexes.empty()) return true;  // the chunk has no index, so it must be read
  return std::ranges::any_of(chunk.message_indexes, [&](const auto& index) {
    const auto channel = static_cast<std::size_t>(index.first);
    return channel >= wanted_.size() || wanted_[channel] != Wanted::no;
  });
}

// Loads the next chunk, or the next record outside of chunks; returns false at the end.
bool Reader::next_walked_record() {
  while (!walk_is_over_) {
    const auto place = walk_.next();
    if (!place) {
      end_walk(false);
      return false;
    }
    place_ = place->offset;
    if (static_cast<std::uint8_t>(place->opcode) == 0) {
      walk_is_over_ = true;
      throw Malformed{"here a record has to begin"};
    }
    if (in_summary_ && place->opcode != Opcode::footer) continue;
    switch (place->opcode) {
      case Opcode::chunk:
        load_chunk(place->offset, place->length(), nullptr);
        return true;
      case Opcode::schema:
      case Opcode::channel:
      case Opcode::message:
        content(place->offset, place->length(), records_);
        rest_ = Decoder(records_);
        return true;
      case Opcode::metadata:
        if (place->offset < kept_until_) break;
        kept_until_ = place->offset + place->length();
        keep_metadata(place->offset, place->length());
        break;
      case Opcode::data_end:
        in_summary_ = true;
        break;
      case Opcode::footer:
        end_walk(true);
        return false;
      default:
        break;
    }
  }
  return false;
}

// Ends the walk, either after the footer or at a record that the file does not completely contain.
void Reader::end_walk(bool after_footer) {
  walk_is_over_ = true;
  const std::uint64_t byte = walk_.offset();
  const std::uint64_t left = file_.size() - byte;
  if (after_footer) {
    std::string end;
    file_.read(byte, static_cast<std::size_t>(std::min<std::uint64_t>(left, magic.size())), end);
    if (end == magic && left == magic.size()) return;
    if (left >= magic.size() || !magic.starts_with(end)) damaged(byte, "here the file has to end");
  } else if (has_footer_) {
    damaged(byte, "a record reaches beyond the end of the file");
  }
  const std::string where = in_summary_ ? ", in its summary; no message is missing" : "; what stands before is whole";
  cut_off_ = file_.path().string() + ": is cut off at byte " + std::to_string(byte) + where;
}

void Reader::load_chunk(std::uint64_t offset, std::uint64_t length, const ChunkIndex* index) {
  place_ = offset;
  const Chunk chunk = decode_chunk(content(offset, length, stored_));
  if (index != nullptr) {
    Decoder prefix(stored_);
    if (prefix.next<Opcode>() != Opcode::chunk || prefix.next<std::uint64_t>() != length - record_prefix ||
        chunk.first_time != index->first_time || chunk.last_time != index->last_time ||
        chunk.uncompressed_size != index->uncompressed_size || chunk.compression != index->compression ||
        chunk.records.size() != index->compressed_size) {
      throw Malformed{"this chunk is not the one that the summary describes"};
    }
  }
  if (chunk.uncompressed_size > most_bytes_) {
    throw Error(file_.path(), fmt::format("has a chunk of {} bytes at byte {}; at most {} can be read",
                                          chunk.uncompressed_size, offset, most_bytes_));
  }
  if (chunk.compression == "zstd") {
    decompressor_.decompress(chunk.records, chunk.uncompressed_size, records_);
  } else if (chunk.compression == "lz4") {
    has_lz4_ = true;
    decompress_lz4(chunk.records, chunk.uncompressed_size, records_);
  } else if (chunk.compression.empty()) {
    if (chunk.records.size() != chunk.uncompressed_size) throw Malformed{"a chunk claims another size than it has"};
    records_ = chunk.records;
  } else {
    throw Error(file_.path(),
                fmt::format("has a chunk at byte {} that is compressed by \"{}\"; this program reads zstd, lz4 "
                            "and uncompressed chunks",
                            offset, in_ascii(chunk.compression.substr(0, 32))));
  }
  if (chunk.checksum != 0 && checksum(records_) != chunk.checksum) throw Malformed{"the checksum of a chunk is wrong"};
  rest_ = Decoder(records_);
}

void Reader::keep_metadata(std::uint64_t offset, std::uint64_t length) {
  try {
    const std::string_view bytes = content(offset, length, stored_);
    if (bytes.size() > metadata_left_) throw Malformed{"its metadata are larger than this program reads"};
    metadata_left_ -= bytes.size();
    Decoder prefix(stored_);
    if (prefix.next<Opcode>() != Opcode::metadata || prefix.next<std::uint64_t>() != bytes.size()) {
      throw Malformed{"here metadata have to stand"};
    }
    metadata_.push_back(decode<Metadata>(bytes));
  } catch (const Malformed& malformed) {
    damaged(offset, malformed.why);
  }
}

// Reads the record at `offset` into `to` and returns its content.
std::string_view Reader::content(std::uint64_t offset, std::uint64_t length, std::string& to) const {
  if (length > most_bytes_) {
    throw Error(file_.path(), fmt::format("has a record of {} bytes at byte {}; at most {} can be read", length, offset,
                                          most_bytes_));
  }
  file_.read(offset, static_cast<std::size_t>(length), to);
  return std::string_view(to).substr(record_prefix);
}

void Reader::damaged(std::uint64_t byte, const std::string& why) const { throw damaged_at(file_, byte, why); }

}  // namespace regista::mcap
