// SPDX-License-Identifier: MIT
// A small recording that uses everything the writer has, and what it holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "mcap/writer.hpp"

namespace regista::mcap {

// A message with its own bytes.
struct Kept {
  ChannelId channel{};
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0, publish_time = 0;
  std::string data;
  bool operator==(const Kept&) const = default;
};

inline Kept kept(const Message& message) {
  return {message.channel, message.sequence, message.log_time, message.publish_time, std::string(message.data)};
}

inline Message message_of(const Kept& kept) {
  return {kept.channel, kept.sequence, kept.log_time, kept.publish_time, kept.data};
}

// What write_example() puts into its file.
struct Example {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<Metadata> metadata;
  std::vector<Kept> messages;
};

// Uses everything that the writer has: several chunks, definitions in the middle, metadata between chunks, a channel
// without schema and one without messages, an empty message, one larger than a chunk, times that go back.
inline Example write_example(const std::filesystem::path& file, WriterOptions options = {}, int count = 40) {
  options.replace = true;
  Example example;
  Writer writer(file, options);
  const auto add_schema = [&](const std::string& name, const std::string& encoding, const std::string& data) {
    const SchemaId id = writer.add_schema(name, encoding, data);
    example.schemas.push_back({id, name, encoding, data});
    return id;
  };
  const auto add_channel = [&](const std::string& topic, SchemaId schema) {
    const ChannelId id = writer.add_channel(topic, "json", schema);
    example.channels.push_back({id, schema, topic, "json"});
    return id;
  };
  const auto write = [&](ChannelId channel, std::uint64_t time, std::string data) {
    example.messages.push_back(
        {channel, static_cast<std::uint32_t>(example.messages.size()), time, time / 2, std::move(data)});
    writer.write(message_of(example.messages.back()));
  };
  const auto write_metadata = [&](const Metadata& metadata) {
    example.metadata.push_back(metadata);
    writer.write(metadata);
  };

  write_metadata({"match", {{"teams", "paper, fixed_rate"}, {"seed", "1"}, {"", "\xc3\xa9"}}});
  const SchemaId truth = add_schema("truth", "jsonschema", R"({"type": "object"})");
  const ChannelId ball = add_channel("/truth", truth);
  add_channel("/silent", truth);
  const ChannelId plain = add_channel("/plain", SchemaId::none);
  for (int i = 0; i < count; ++i) {
    const auto time = static_cast<std::uint64_t>(i) * 100'000'000;
    write(ball, time, R"({"ball": [)" + std::to_string(i) + ", " + std::to_string(i * i % 97) + "]}");
    if (i % 3 == 0) write(plain, time > 50'000'000 ? time - 50'000'000 : time, i % 2 == 0 ? "" : std::string(5, 'x'));
    if (i == count / 2) {
      const SchemaId late = add_schema("late", "jsonschema", "{}");
      const ChannelId late_channel = add_channel("/late", late);
      write(late_channel, time, std::string(700, static_cast<char>('a' + i % 26)));
      write_metadata({"half", {}});
    }
  }
  writer.close();
  return example;
}

}  // namespace regista::mcap
