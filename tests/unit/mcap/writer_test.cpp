// SPDX-License-Identifier: MIT
#include "mcap/writer.hpp"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <random>

#include "mcap/encoding.hpp"
#include "unit/mcap/fixture.hpp"

namespace regista::mcap {
namespace {

using testing::ElementsAreArray;

// Every kind of file holds the same.
class RoundTrip : public McapTest, public testing::WithParamInterface<WriterOptions> {};

INSTANTIATE_TEST_SUITE_P(Options, RoundTrip,
                         testing::Values(WriterOptions{}, WriterOptions{.chunk_size = 1},
                                         WriterOptions{.library = "y", .chunk_size = 300},
                                         WriterOptions{.chunk_size = 1, .background = true},
                                         WriterOptions{.chunk_size = 300, .background = true},
                                         WriterOptions{.chunk_size = largest_chunk_size}));

TEST_P(RoundTrip, GivesBackWhatWasWritten) {
  const Example example = write_example(path("a.mcap"), GetParam());
  const Contents contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.error, "");
  EXPECT_TRUE(contents.indexed);
  EXPECT_FALSE(contents.cut_off.has_value());
  EXPECT_EQ(contents.messages, example.messages);
  ASSERT_EQ(contents.channels.size(), example.channels.size());
  for (const Channel& channel : example.channels) EXPECT_EQ(contents.channels.at(channel.id), channel);
  EXPECT_EQ(contents.metadata, example.metadata);

  // What the reader does not tell.
  const std::string bytes = bytes_of(path("a.mcap"));
  const Summary summary = summary_of(path("a.mcap"));
  EXPECT_EQ(summary.schemas, example.schemas);
  Decoder in(std::string_view(bytes).substr(magic.size()));
  EXPECT_EQ(decode<Header>(take_record(in).content).library, GetParam().library);
  Decoder end(std::string_view(bytes).substr(summary.data_end));
  const RawRecord data_end = take_record(end);
  EXPECT_EQ(data_end.opcode, Opcode::data_end);
  EXPECT_EQ(Decoder(data_end.content).next<std::uint32_t>(),
            checksum(std::string_view(bytes).substr(0, summary.data_end)));
}

TEST_P(RoundTrip, CountsInItsStatistics) {
  const Example example = write_example(path("a.mcap"), GetParam());
  const Reader reader(path("a.mcap"));
  Statistics expected;
  expected.messages = example.messages.size();
  expected.schemas = static_cast<std::uint16_t>(example.schemas.size());
  expected.channels = static_cast<std::uint32_t>(example.channels.size());
  expected.metadata = static_cast<std::uint32_t>(example.metadata.size());
  expected.chunks = static_cast<std::uint32_t>(summary_of(path("a.mcap")).chunks.size());
  expected.first_time = 0;
  for (const Kept& message : example.messages) {
    expected.last_time = std::max(expected.last_time, message.log_time);
    ++expected.messages_of[message.channel];
  }
  ASSERT_NE(reader.statistics(), nullptr);
  EXPECT_EQ(*reader.statistics(), expected);
}

TEST_P(RoundTrip, GivesTheSameBytesAgain) {
  write_example(path("a.mcap"), GetParam());
  write_example(path("b.mcap"), GetParam());
  EXPECT_EQ(bytes_of(path("a.mcap")), bytes_of(path("b.mcap")));
}

using WriterTest = McapTest;

TEST_F(WriterTest, AChunkEndsWithTheMessageThatFillsIt) {
  Writer writer(path("a.mcap"), {.chunk_size = 1000});
  const ChannelId channel = writer.add_channel("/t", "json");
  const std::string data(100, 'x');
  for (std::uint32_t i = 0; i < 100; ++i) writer.write({channel, i, i, i, data});
  writer.close();
  const std::vector<ChunkIndex> chunks = summary_of(path("a.mcap")).chunks;
  ASSERT_GE(chunks.size(), 9u);
  for (const ChunkIndex& chunk : chunks) EXPECT_LT(chunk.uncompressed_size, 1000u + 131u);
  for (std::size_t i = 0; i + 1 < chunks.size(); ++i) EXPECT_GE(chunks[i].uncompressed_size, 1000u);
}

TEST_F(WriterTest, AFileWithoutMessagesIsWhole) {
  Writer(path("a.mcap")).close();
  const Contents contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.error, "");
  EXPECT_TRUE(contents.indexed);
  EXPECT_TRUE(contents.messages.empty());
  EXPECT_FALSE(contents.cut_off.has_value());
}

TEST_F(WriterTest, ABackgroundChangesNoByte) {
  for (const std::size_t chunk_size : {std::size_t{1}, std::size_t{300}, largest_chunk_size}) {
    write_example(path("plain.mcap"), {.chunk_size = chunk_size, .replace = true});
    write_example(path("background.mcap"), {.chunk_size = chunk_size, .replace = true, .background = true});
    EXPECT_EQ(bytes_of(path("plain.mcap")), bytes_of(path("background.mcap")));
  }
}

TEST_F(WriterTest, FinishedChunksAreInTheFileAtOnce) {
  Writer writer(path("a.mcap"));
  const ChannelId channel = writer.add_channel("/t", "json");
  writer.write({channel, 0, 1, 1, "first"});
  writer.finish_chunk();
  writer.write({channel, 1, 2, 2, "second"});
  const std::uintmax_t finished = std::filesystem::file_size(path("a.mcap"));
  Contents contents = read_all(path("a.mcap"));
  ASSERT_EQ(contents.messages.size(), 1u);
  EXPECT_EQ(contents.messages[0].data, "first");
  EXPECT_EQ(contents.cut_off, path("a.mcap").string() + ": is cut off at byte " + std::to_string(finished) +
                                  "; what stands before is whole");
  writer.close();
  writer.close();
  contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.messages.size(), 2u);
  EXPECT_FALSE(contents.cut_off.has_value());
}

TEST_F(WriterTest, WithoutCloseTheFileIsAsAfterACrash) {
  {
    Writer writer(path("a.mcap"), {.chunk_size = 1});
    const ChannelId channel = writer.add_channel("/t", "json");
    writer.write({channel, 0, 1, 1, "first"});
  }
  const Contents contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.messages.size(), 1u);
  EXPECT_EQ(contents.cut_off, path("a.mcap").string() + ": is cut off at byte " +
                                  std::to_string(std::filesystem::file_size(path("a.mcap"))) +
                                  "; what stands before is whole");
}

std::string error_of(const auto& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(WriterTest, AnExistingFileIsKeptUnlessToldOtherwise) {
  write_bytes(path("a.mcap"), "precious");
  EXPECT_EQ(error_of([&] { Writer writer(path("a.mcap")); }), path("a.mcap").string() + ": exists already");
  EXPECT_EQ(bytes_of(path("a.mcap")), "precious");
  Writer(path("a.mcap"), {.replace = true}).close();
  EXPECT_EQ(read_all(path("a.mcap")).error, "");
}

TEST_F(WriterTest, SaysWhyAFileCannotBeCreated) {
  EXPECT_EQ(error_of([&] { Writer writer(path("none/a.mcap")); }),
            path("none/a.mcap").string() + ": cannot be created: No such file or directory");
}

TEST_F(WriterTest, AFullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(error_of([] { Writer writer("/dev/full", {.replace = true}); }),
            "/dev/full: cannot be written: No space left on device");
}

// With and without a background.
class FullDisk : public WriterTest, public testing::WithParamInterface<bool> {};

INSTANTIATE_TEST_SUITE_P(Background, FullDisk, testing::Bool());

TEST_P(FullDisk, LeavesWholeChunksAndFailsFromThenOn) {
  const std::string too_large = path("a.mcap").string() + ": cannot be written: File too large";
  struct rlimit before {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  struct rlimit small = before;
  small.rlim_cur = 5000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  std::uint32_t written = 0;
  {
    Writer writer(path("a.mcap"), {.chunk_size = 1000, .background = GetParam()});
    const ChannelId channel = writer.add_channel("/t", "json");
    std::mt19937 random(1);
    std::string data(200, 'x');
    for (char& byte : data) byte = static_cast<char>(random());
    const auto write = [&] { writer.write({channel, written, written, written, data}); };
    std::string error;
    while (error.empty() && written < 100) {
      error = error_of(write);
      ++written;
    }
    EXPECT_EQ(error, too_large);
    EXPECT_EQ(error_of(write), too_large);
    EXPECT_EQ(error_of([&] { writer.write(Metadata{"m", {}}); }), too_large);
    EXPECT_EQ(error_of([&] { writer.close(); }), too_large);
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  const Contents contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.error, "");
  EXPECT_TRUE(contents.cut_off.has_value());
  EXPECT_LT(contents.messages.size(), written);
  EXPECT_GE(contents.messages.size() * 231, 3000u);
}

TEST_F(WriterTest, RefusesWhatNoMcapFileCanHoldAndGoesOn) {
  Writer writer(path("a.mcap"));
  const std::string file = path("a.mcap").string();
  const ChannelId channel = writer.add_channel("/t", "json");
  EXPECT_EQ(error_of([&] { writer.add_channel("\xff", "json"); }), file + ": cannot hold a topic that is not UTF-8");
  EXPECT_EQ(error_of([&] {
              writer.write(Metadata{"m", {{"k", "\xc3"}}});
            }),
            file + ": cannot hold metadata that is not UTF-8");
  const std::string large(largest_item + 1, 'x');
  EXPECT_EQ(error_of([&] {
              writer.write({channel, 0, 0, 0, large});
            }),
            file + ": cannot hold a message of 33554433 bytes; at most 33554432 are possible");
  EXPECT_THROW(writer.add_schema("s", "e", large), Error);
  writer.write({channel, 7, 8, 9, "after"});
  writer.close();
  const Contents contents = read_all(file);
  EXPECT_THAT(contents.messages, ElementsAreArray({Kept{channel, 7, 8, 9, "after"}}));
  EXPECT_EQ(contents.channels.size(), 1u);
}

TEST_F(WriterTest, TheLargestItemCanBeReadAgain) {
  const std::string data(largest_item, 'x');
  Writer writer(path("a.mcap"), {.chunk_size = largest_chunk_size});
  const ChannelId channel = writer.add_channel("/t", "json");
  const std::string filling(largest_chunk_size - 1000, 'y');
  writer.write({channel, 0, 0, 0, filling});
  writer.write({channel, 1, 1, 1, data});
  writer.close();
  const Contents contents = read_all(path("a.mcap"));
  EXPECT_EQ(contents.error, "");
  ASSERT_EQ(contents.messages.size(), 2u);
  EXPECT_TRUE(contents.messages[1].data == data);
}

}  // namespace
}  // namespace regista::mcap
