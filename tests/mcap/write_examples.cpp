// SPDX-License-Identifier: MIT
// Writes recordings into a folder, each with what it must hold as JSON beside it, for viewer/test/official_reader.mjs.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "unit/mcap/example.hpp"

namespace regista::mcap {
namespace {

using Json = nlohmann::json;

std::string hex(std::string_view bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += digits[byte / 16];
    text += digits[byte % 16];
  }
  return text;
}

template <class Id>
unsigned number(Id id) {
  return static_cast<unsigned>(id);
}

// Numbers of 64 bits as text: JSON's readers round them.
Json as_json(const Example& example, const WriterOptions& options) {
  Json json;
  json["library"] = options.library;
  for (const char* list : {"schemas", "channels", "metadata", "messages"}) json[list] = Json::array();
  for (const Schema& schema : example.schemas) {
    json["schemas"].push_back(
        {{"id", number(schema.id)}, {"name", schema.name}, {"encoding", schema.encoding}, {"data", hex(schema.data)}});
  }
  for (const Channel& channel : example.channels) {
    json["channels"].push_back({{"id", number(channel.id)},
                                {"schema", number(channel.schema)},
                                {"topic", channel.topic},
                                {"encoding", channel.message_encoding}});
  }
  for (const Metadata& metadata : example.metadata) {
    json["metadata"].push_back({{"name", metadata.name}, {"pairs", metadata.pairs}});
  }
  for (const Kept& message : example.messages) {
    json["messages"].push_back({{"channel", number(message.channel)},
                                {"sequence", message.sequence},
                                {"log_time", std::to_string(message.log_time)},
                                {"publish_time", std::to_string(message.publish_time)},
                                {"data", hex(message.data)}});
  }
  return json;
}

void save(const std::filesystem::path& file, const Json& json) { std::ofstream(file) << json.dump(1) << '\n'; }

// Greatest and smallest numbers, every byte in a message, names beyond ASCII.
Example write_extremes(const std::filesystem::path& file) {
  Example example;
  Writer writer(file, {.replace = true});
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  const SchemaId schema = writer.add_schema("na\xc3\xafve \xe2\x9a\xbd", "none of the known", bytes);
  example.schemas.push_back({schema, "na\xc3\xafve \xe2\x9a\xbd", "none of the known", bytes});
  const ChannelId channel = writer.add_channel("/\xf0\x9f\xa4\x96", "bytes", schema);
  example.channels.push_back({channel, schema, "/\xf0\x9f\xa4\x96", "bytes"});
  const std::uint64_t latest = std::numeric_limits<std::uint64_t>::max();
  example.messages = {{channel, 0, 0, latest, bytes}, {channel, 0xffffffff, latest, 0, ""}, {channel, 1, 1, 1, bytes}};
  for (const Kept& message : example.messages) writer.write(message_of(message));
  writer.close();
  return example;
}

void write_all(const std::filesystem::path& folder) {
  const std::vector<std::pair<std::string, WriterOptions>> files = {
      {"default", {}},
      {"named", {.library = "regista test"}},
      {"small_chunks", {.chunk_size = 400}},
      {"chunk_of_each", {.chunk_size = 1}},
  };
  for (const auto& [name, options] : files) {
    save(folder / (name + ".json"), as_json(write_example(folder / (name + ".mcap"), options), options));
  }
  const WriterOptions large{.chunk_size = 100'000};
  save(folder / "large.json", as_json(write_example(folder / "large.mcap", large, 20'000), large));
  save(folder / "extremes.json", as_json(write_extremes(folder / "extremes.mcap"), {}));
  Writer(folder / "empty.mcap", {.replace = true}).close();
  save(folder / "empty.json", as_json({}, {}));

  // Never closed: its last chunk is missing, and the file has no end.
  Example kept;
  Writer writer(folder / "unfinished.mcap", {.replace = true});
  const ChannelId channel = writer.add_channel("/t", "json");
  kept.channels.push_back({channel, SchemaId::none, "/t", "json"});
  kept.messages.push_back({channel, 0, 5, 6, "{}"});
  writer.write(message_of(kept.messages.back()));
  writer.finish_chunk();
  writer.write({channel, 1, 7, 8, "lost"});
  save(folder / "unfinished.json", as_json(kept, {}));
}

}  // namespace
}  // namespace regista::mcap

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: write_mcap_examples FOLDER\n", stderr);
    return 2;
  }
  regista::mcap::write_all(arguments[1]);
  return 0;
}
