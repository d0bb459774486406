// SPDX-License-Identifier: MIT
// Small recordings and what can be read back from them.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mcap/error.hpp"
#include "mcap/reader.hpp"
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

// All that came out of a file, and the error that ended it.
struct Contents {
  std::map<SchemaId, Schema> schemas;
  std::map<ChannelId, Channel> channels;
  std::vector<Metadata> metadata;
  std::vector<Kept> messages;
  std::string error;
  bool indexed = false;
  std::optional<CutOff> cut_off;
};

inline Contents read_all(const std::filesystem::path& file, const Selection& selection = {},
                         const ReaderOptions& options = {}) {
  Contents contents;
  try {
    Reader reader(file, options);
    contents.indexed = reader.indexed();
    reader.select(selection);
    for (Message message; reader.next(message);) contents.messages.push_back(kept(message));
    contents.schemas = reader.schemas();
    contents.channels = reader.channels();
    contents.metadata = reader.metadata();
    contents.cut_off = reader.cut_off();
  } catch (const Error& error) {
    contents.error = error.what();
  }
  return contents;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Always a new file: some file systems wait for the disk where an old one is written over.
inline void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
  std::filesystem::remove(file);
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class McapTest : public testing::Test {
 protected:
  McapTest() {
    std::string pattern = testing::TempDir() + "mcap_XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = pattern;
  }
  ~McapTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  std::filesystem::path path(std::string_view name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

// What write_example() puts into its file.
struct Example {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<Metadata> metadata;
  std::vector<Attachment> attachments;
  std::vector<Kept> messages;
};

// Uses everything that the format has: several chunks, definitions in the middle, metadata between chunks, a channel
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
  const auto add_channel = [&](const std::string& topic, SchemaId schema, const Pairs& pairs) {
    const ChannelId id = writer.add_channel(topic, "json", schema, pairs);
    example.channels.push_back({id, schema, topic, "json", pairs});
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
  const ChannelId ball = add_channel("/truth", truth, {{"side", "both"}});
  add_channel("/silent", truth, {});
  const ChannelId plain = add_channel("/plain", SchemaId::none, {});
  for (int i = 0; i < count; ++i) {
    const auto time = static_cast<std::uint64_t>(i) * 100'000'000;
    write(ball, time, R"({"ball": [)" + std::to_string(i) + ", " + std::to_string(i * i % 97) + "]}");
    if (i % 3 == 0) write(plain, time > 50'000'000 ? time - 50'000'000 : time, i % 2 == 0 ? "" : std::string(5, 'x'));
    if (i == count / 2) {
      const SchemaId late = add_schema("late", "jsonschema", "{}");
      const ChannelId late_channel = add_channel("/late", late, {});
      write(late_channel, time, std::string(700, static_cast<char>('a' + i % 26)));
      example.attachments.push_back({time, 7, "team.yaml", "application/yaml", "team: paper\n"});
      writer.write(example.attachments.back());
      write_metadata({"half", {}});
    }
  }
  writer.close();
  return example;
}

}  // namespace regista::mcap
