// SPDX-License-Identifier: MIT
// Selections, files of other writers, files that are none.
#include "mcap/reader.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "mcap/encoding.hpp"
#include "unit/mcap/fixture.hpp"
#include "unit/mcap/plain_chunks.hpp"

namespace regista::mcap {
namespace {

using std::string_literals::operator""s;
using std::string_view_literals::operator""sv;

class ReaderTest : public McapTest {
 protected:
  std::string error_of(std::string_view bytes) {
    write_bytes(path("x.mcap"), bytes);
    const std::string error = read_all(path("x.mcap")).error;
    const std::string name = path("x.mcap").string() + ": ";
    EXPECT_TRUE(error.empty() || error.starts_with(name)) << error;
    return error.substr(std::min(error.size(), name.size()));
  }
};

std::string beginning() {
  std::string bytes(magic);
  append_record(bytes, Header{"elsewhere"});
  return bytes;
}

std::string ending() {
  std::string bytes;
  append_data_end(bytes, 0);
  append_footer_fields(bytes, 0, 0);
  append_integer(bytes, std::uint32_t{0});
  return bytes.append(magic);
}

std::string chunk_record(const std::string& compression, std::uint64_t uncompressed_size, const std::string& records) {
  ChunkIndex index;
  index.compression = compression;
  index.uncompressed_size = uncompressed_size;
  index.compressed_size = records.size();
  index.length = record_prefix + 40 + compression.size() + records.size();
  std::string bytes;
  append_chunk_fields(bytes, index, 0);
  return bytes + records;
}

TEST_F(ReaderTest, SelectsByTimeAndTopicWithAndWithoutASummary) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 400});
  const std::string bytes = bytes_of(path("a.mcap"));
  write_bytes(path("cut.mcap"), std::string_view(bytes).substr(0, bytes.size() - 1));
  std::map<ChannelId, std::string> topics;
  for (const Channel& channel : example.channels) topics[channel.id] = channel.topic;
  const std::vector<Selection> selections = {
      {},
      {.first_time = 1'000'000'000},
      {.last_time = 1'000'000'000},
      {.first_time = 500'000'000, .last_time = 500'000'000},
      {.first_time = 5, .last_time = 4},
      {.topics = {"/plain"}},
      {.topics = {"/plain", "/late"}},
      {.first_time = 900'000'000, .last_time = 2'000'000'000, .topics = {"/late", "/truth"}},
      {.topics = {"/silent"}},
      {.topics = {"/nobody"}},
  };
  for (const Selection& selection : selections) {
    std::vector<Kept> expected;
    for (const Kept& message : example.messages) {
      const bool in_time = message.log_time >= selection.first_time && message.log_time <= selection.last_time;
      const auto& wanted = selection.topics;
      const bool on_topic =
          wanted.empty() || std::find(wanted.begin(), wanted.end(), topics[message.channel]) != wanted.end();
      if (in_time && on_topic) expected.push_back(message);
    }
    EXPECT_EQ(read_all(path("a.mcap"), selection).messages, expected);
    const Contents cut = read_all(path("cut.mcap"), selection);
    EXPECT_EQ(cut.messages, expected);
    EXPECT_FALSE(cut.indexed);
  }
}

TEST_F(ReaderTest, PassesOverChunksThatTheSelectionDoesNotTouch) {
  write_example(path("a.mcap"), {.chunk_size = 400});
  std::string bytes = bytes_of(path("a.mcap"));
  const std::vector<ChunkIndex> chunks = summary_of(path("a.mcap")).chunks;
  // All chunks after the first are ruined; whoever opens one of them sees an error.
  for (std::size_t i = 1; i < chunks.size(); ++i) bytes[chunks[i].offset + chunks[i].length - 1] ^= '\xff';
  write_bytes(path("b.mcap"), bytes);
  EXPECT_NE(read_all(path("b.mcap")).error, "");
  const Contents first = read_all(path("b.mcap"), {.last_time = chunks[1].first_time - 1});
  EXPECT_EQ(first.error, "");
  EXPECT_GT(first.messages.size(), 0u);
  EXPECT_EQ(read_all(path("b.mcap"), {.topics = {"/silent"}}).error, "");
}

TEST_F(ReaderTest, ReadsFilesWithoutChunksAndWithoutSummary) {
  std::string bytes = beginning();
  append_record(bytes, Schema{SchemaId{9}, "s", "jsonschema", "{}"});
  append_record(bytes, Schema{SchemaId::none, "to be ignored", "", ""});
  append_record(bytes, Channel{ChannelId{0}, SchemaId{9}, "/zero", "json"});
  append_record(bytes, Message{ChannelId{0}, 1, 2, 3, "hello"});
  bytes += "\x7f\x03\0\0\0\0\0\0\0new"s;  // a kind of record that does not exist yet
  append_record(bytes, Message{ChannelId{0}, 2, 3, 4, ""});
  write_bytes(path("a.mcap"), bytes + ending());
  const Contents contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.error, "");
  EXPECT_FALSE(contents.indexed);
  EXPECT_FALSE(contents.cut_off.has_value());
  EXPECT_THAT(contents.messages,
              testing::ElementsAre(Kept{ChannelId{0}, 1, 2, 3, "hello"}, Kept{ChannelId{0}, 2, 3, 4, ""}));
}

TEST_F(ReaderTest, ReadsChunksThatAreNotCompressed) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 400});
  write_bytes(path("plain.mcap"), with_plain_chunks(bytes_of(path("a.mcap"))));
  for (const ChunkIndex& chunk : summary_of(path("plain.mcap")).chunks) EXPECT_EQ(chunk.compression, "");
  const Contents contents = read_all(path("plain.mcap"));
  EXPECT_EQ(contents.error, "");
  EXPECT_TRUE(contents.indexed);
  EXPECT_EQ(contents.messages, example.messages);
  EXPECT_EQ(contents.metadata, example.metadata);
}

// Whatever they hold, for nobody asks.
TEST_F(ReaderTest, PassesOverAttachments) {
  std::string records;
  append_record(records, Channel{ChannelId{1}, SchemaId::none, "/t", "json"});
  append_record(records, Message{ChannelId{1}, 1, 2, 3, "hello"});
  const std::string attachment = "\x09\x03\0\0\0\0\0\0\0abc"s;
  const std::string before = beginning() + attachment;
  std::string data = before + chunk_record("", records.size(), records) + attachment;
  write_bytes(path("walked.mcap"), data + ending());

  ChunkIndex index;
  index.offset = before.size();
  index.length = data.size() - before.size() - attachment.size();
  index.compressed_size = index.uncompressed_size = records.size();
  append_data_end(data, 0);
  const std::uint64_t summary_start = data.size();
  append_record(data, index);
  data += "\x0a\x03\0\0\0\0\0\0\0abc"s;  // an index of attachments
  append_footer_fields(data, summary_start, 0);
  append_integer(data, std::uint32_t{0});
  write_bytes(path("indexed.mcap"), data.append(magic));

  for (const char* file : {"walked.mcap", "indexed.mcap"}) {
    const Contents contents = read_all(path(file));
    EXPECT_EQ(contents.error, "");
    EXPECT_EQ(contents.indexed, file == "indexed.mcap"sv);
    EXPECT_THAT(contents.messages, testing::ElementsAre(Kept{ChannelId{1}, 1, 2, 3, "hello"}));
  }
}

TEST_F(ReaderTest, SaysInOneLineWhatIsNoRecordingOfOurs) {
  EXPECT_EQ(error_of(""), "is empty");
  EXPECT_EQ(error_of("PK\x03\x04 a zip file"), R"(is not an MCAP file; it begins with "PK\x03\x04 a z")");
  EXPECT_EQ(error_of("x"), R"(is not an MCAP file; it begins with "x")");
  EXPECT_EQ(error_of("\x89MCAP1\r\n and more"), "is an MCAP file of version 1; this program reads version 0");
  EXPECT_EQ(error_of("\x89MCAP"), "is cut off at byte 5, before its header");
  EXPECT_EQ(error_of("\x89MCAPx"), "is an MCAP file of version x; this program reads version 0");
  EXPECT_EQ(error_of(std::string(magic) + ending()), "is damaged at byte 8: here the header has to stand");
  const std::string bz2 = beginning() + chunk_record("bz2", 4, "abcd");
  EXPECT_EQ(error_of(bz2 + ending()),
            "has a chunk at byte 34 that is compressed by \"bz2\"; this program reads zstd, lz4 and "
            "uncompressed chunks");
  EXPECT_EQ(error_of(beginning() + ending()), "");
  EXPECT_EQ(error_of(beginning() + ending() + "more"), "is damaged at byte 76: here the file has to end");
}

TEST_F(ReaderTest, SaysWhyAFileCannotBeOpened) {
  EXPECT_EQ(read_all(path("none")).error, path("none").string() + ": cannot be opened: No such file or directory");
  EXPECT_EQ(read_all(path("")).error, path("").string() + ": is a folder, not a recording");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(read_all(path("pipe")).error, path("pipe").string() + ": is not a regular file");
}

TEST_F(ReaderTest, RefusesContradictions) {
  std::string twice = beginning();
  append_record(twice, Schema{SchemaId{1}, "s", "", ""});
  append_record(twice, Schema{SchemaId{1}, "other", "", ""});
  EXPECT_THAT(error_of(twice + ending()), testing::EndsWith(": schema 1 is given twice and differs"));
  std::string orphan = beginning();
  append_record(orphan, Channel{ChannelId{1}, SchemaId{5}, "/t", "json"});
  EXPECT_THAT(error_of(orphan + ending()), testing::EndsWith(": channel 1 names schema 5, which is missing"));
  std::string stray = beginning();
  append_record(stray, Message{ChannelId{3}, 0, 0, 0, ""});
  EXPECT_THAT(error_of(stray + ending()), testing::EndsWith(": a message names channel 3, which is missing"));
  std::string outside = beginning();
  append_integer(outside, std::uint8_t{5});
  append_integer(outside, std::uint64_t{1} << 60);
  EXPECT_THAT(error_of(outside + ending()), testing::EndsWith(": a record reaches beyond the end of the file"));
}

TEST_F(ReaderTest, DoesNotTrustSizesOfChunks) {
  std::string honest;
  append_record(honest, Channel{ChannelId{1}, SchemaId::none, "/t", "json"});
  std::string frame;
  Compressor().append(frame, honest);
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", honest.size(), frame) + ending()), "");
  const std::string at_chunk = "is damaged at byte 34: ";
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", honest.size() - 1, frame) + ending()),
            at_chunk + "a chunk cannot be decompressed: Destination buffer is too small");
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", honest.size() + 1, frame) + ending()),
            at_chunk + "a chunk holds fewer bytes than it claims");
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", std::uint64_t{60} << 20, frame) + ending()),
            at_chunk + "a chunk claims more bytes than it can hold");
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", std::uint64_t{1} << 62, frame) + ending()),
            "has a chunk of 4611686018427387904 bytes at byte 34; at most 67108864 can be read");
  EXPECT_EQ(error_of(beginning() + chunk_record("", 1, "ab") + ending()),
            at_chunk + "a chunk claims another size than it has");
  // A bomb: 100 MiB of zeros.
  std::string bomb;
  Compressor().append(bomb, std::string(std::size_t{100} << 20, '\0'));
  EXPECT_LT(bomb.size(), 20'000u);
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", std::uint64_t{100} << 20, bomb) + ending()),
            "has a chunk of 104857600 bytes at byte 34; at most 67108864 can be read");
  EXPECT_EQ(error_of(beginning() + chunk_record("zstd", 1000, bomb) + ending()),
            at_chunk + "a chunk cannot be decompressed: Destination buffer is too small");
}

// Many large schemas from few bytes.
TEST_F(ReaderTest, DefinitionsAreBounded) {
  std::string bytes = beginning();
  for (std::uint16_t id = 1; id <= 9; ++id) {
    std::string records, frame;
    append_record(records, Schema{SchemaId{id}, "s", "e", std::string(1'000'000, 'x')});
    Compressor().append(frame, records);
    bytes += chunk_record("zstd", records.size(), frame);
  }
  write_bytes(path("a.mcap"), bytes + ending());
  EXPECT_EQ(read_all(path("a.mcap")).error, "");
  EXPECT_THAT(read_all(path("a.mcap"), {}, 8'000'000).error,
              testing::EndsWith(": its schemas and channels are larger than this program reads"));
}

}  // namespace
}  // namespace regista::mcap
