// SPDX-License-Identifier: MIT
// A file that ends anywhere yields all of its complete chunks and says where it is cut off.
#include <algorithm>
#include <random>

#include "unit/mcap/fixture.hpp"

namespace regista::mcap {
namespace {

struct Boundaries {
  std::vector<std::uint64_t> records;  // where each record outside of chunks begins, ascending, and where the last ends
  std::uint64_t data_end = 0;          // where the end of the data begins
};

Boundaries boundaries_of(const std::string& bytes) {
  Boundaries found;
  std::size_t at = 8;
  while (at + 8 < bytes.size()) {
    found.records.push_back(at);
    if (bytes[at] == '\x0f') found.data_end = at;
    std::uint64_t length = 0;
    for (std::size_t i = 0; i < 8; ++i)
      length |= std::uint64_t{static_cast<unsigned char>(bytes[at + 1 + i])} << (8 * i);
    at += 9 + length;
  }
  found.records.push_back(at);
  return found;
}

class CutOffTest : public McapTest {
 protected:
  CutOffTest() : McapTest(quick_folder()) {}

  // The file of `bytes`, cut at `length`, against the chunks that end before.
  void expect_whole_chunks(std::string_view bytes, std::size_t length, const Boundaries& boundaries,
                           const std::vector<ChunkIndex>& chunks, const std::vector<std::size_t>& messages_until,
                           const std::vector<Kept>& messages) {
    SCOPED_TRACE("cut at " + std::to_string(length) + " of " + std::to_string(bytes.size()));
    write_bytes(path("cut.mcap"), bytes.substr(0, length));
    const std::string name = path("cut.mcap").string();
    const Contents contents = read_all(path("cut.mcap"));
    const std::uint64_t header_end = boundaries.records[1];
    if (length == 0) {
      EXPECT_EQ(contents.error, name + ": is empty");
      return;
    }
    if (length < header_end) {
      EXPECT_EQ(contents.error, name + ": is cut off at byte " + std::to_string(length) +
                                    (length < 8 ? ", before its header" : ", within its header"));
      return;
    }
    ASSERT_EQ(contents.error, "");
    std::size_t expected = 0;
    for (std::size_t i = 0; i < chunks.size(); ++i) {
      if (chunks[i].offset + chunks[i].length <= length) expected = messages_until[i];
    }
    ASSERT_EQ(contents.messages.size(), expected);
    EXPECT_TRUE(std::equal(contents.messages.begin(), contents.messages.end(), messages.begin()));
    ASSERT_TRUE(contents.cut_off.has_value());
    const auto after = std::upper_bound(boundaries.records.begin(), boundaries.records.end(), length);
    EXPECT_EQ(*contents.cut_off, name + ": is cut off at byte " + std::to_string(*(after - 1)) +
                                     (length >= boundaries.data_end + 13 ? ", in its summary; no message is missing"
                                                                         : "; what stands before is whole"));
  }

  // Number of messages up to and with each chunk, read one chunk at a time by its times in the index.
  static std::vector<std::size_t> messages_until(const std::vector<ChunkIndex>& chunks, const std::string& bytes) {
    std::vector<std::size_t> until;
    std::size_t count = 0;
    for (const ChunkIndex& chunk : chunks) {
      // 16 bytes for each message in the message indexes, 15 bytes before them for each channel.
      count += (chunk.message_index_length - chunk.message_indexes.size() * 15) / 16;
      until.push_back(count);
    }
    EXPECT_LE(until.back(), bytes.size());
    return until;
  }
};

TEST_F(CutOffTest, AtEveryLengthOfASmallFile) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 400});
  const std::string bytes = bytes_of(path("a.mcap"));
  const std::vector<ChunkIndex> chunks = summary_of(path("a.mcap")).chunks;
  ASSERT_GE(chunks.size(), 5u);
  const std::vector<std::size_t> until = messages_until(chunks, bytes);
  ASSERT_EQ(until.back(), example.messages.size());
  const Boundaries boundaries = boundaries_of(bytes);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    expect_whole_chunks(bytes, length, boundaries, chunks, until, example.messages);
    if (HasFailure()) return;
  }
}

TEST_F(CutOffTest, AtAHundredRandomLengthsOfALargeFile) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 20'000}, 20'000);
  const std::string bytes = bytes_of(path("a.mcap"));
  const std::vector<ChunkIndex> chunks = summary_of(path("a.mcap")).chunks;
  ASSERT_GE(chunks.size(), 50u);
  const std::vector<std::size_t> until = messages_until(chunks, bytes);
  ASSERT_EQ(until.back(), example.messages.size());
  const Boundaries boundaries = boundaries_of(bytes);
  std::mt19937 random(20);
  for (int i = 0; i < 100; ++i) {
    expect_whole_chunks(bytes, random() % bytes.size(), boundaries, chunks, until, example.messages);
    if (HasFailure()) return;
  }
}

TEST_F(CutOffTest, MetadataBeforeTheCutAreThereOnce) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 400});
  const std::string bytes = bytes_of(path("a.mcap"));
  write_bytes(path("cut.mcap"), std::string_view(bytes).substr(0, boundaries_of(bytes).data_end));
  Reader reader(path("cut.mcap"));
  EXPECT_FALSE(reader.indexed());
  EXPECT_EQ(reader.statistics(), nullptr);
  Message message;
  for (int time = 0; time < 2; ++time) {
    reader.select({});
    std::size_t count = 0;
    while (reader.next(message)) ++count;
    EXPECT_EQ(count, example.messages.size());
    EXPECT_FALSE(reader.next(message));
    EXPECT_EQ(reader.metadata(), example.metadata);
  }
}

TEST_F(CutOffTest, ZerosAtTheEndAreReportedAfterWhatIsWhole) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 400});
  const std::string bytes = bytes_of(path("a.mcap"));
  const std::uint64_t end = boundaries_of(bytes).data_end;
  write_bytes(path("zeros.mcap"), bytes.substr(0, end) + std::string(4096, '\0'));
  const Contents contents = read_all(path("zeros.mcap"));
  EXPECT_EQ(contents.messages, example.messages);
  EXPECT_EQ(contents.error, path("zeros.mcap").string() + ": is damaged at byte " + std::to_string(end) +
                                ": here a record has to begin");
}

}  // namespace
}  // namespace regista::mcap
