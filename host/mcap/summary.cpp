// SPDX-License-Identifier: MIT
#include "mcap/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "mcap/encoding.hpp"

namespace regista::mcap {
namespace {

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

bool has_footer(const InputFile& file) {
  if (file.size() < magic.size() + ending) return false;
  std::string bytes;
  file.read(file.size() - ending, ending, bytes);
  Decoder in(bytes);
  return in.next<Opcode>() == Opcode::footer && in.next<std::uint64_t>() == footer_content && bytes.ends_with(magic);
}

std::optional<Summary> read_summary(const InputFile& file, std::uint64_t header_end, std::size_t most_bytes) {
  const std::uint64_t footer_start = file.size() - ending;
  const auto damaged = [&](std::uint64_t byte, const std::string& why) {
    return Error(file.path(), "is damaged at byte " + std::to_string(byte) + ": " + why);
  };
  std::string footer_bytes;
  file.read(footer_start, footer_record, footer_bytes);
  const Footer footer = decode_footer(std::string_view(footer_bytes).substr(record_prefix));
  if (footer.summary_start == 0) return std::nullopt;
  if (footer.summary_start > footer_start || footer.summary_start < header_end ||
      footer.summary_start - header_end < data_end_record) {
    throw damaged(footer_start, "the footer names a summary that cannot be");
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
      throw damaged(footer.summary_start, "the checksum of the summary is wrong");
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
    throw damaged(data_end, malformed.why);
  }
  if (!leads_to_all_messages(summary)) return std::nullopt;
  return summary;
}

}  // namespace regista::mcap
