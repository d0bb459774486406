// SPDX-License-Identifier: MIT
// Messages in the order of time, wherever they stand in the file: against sorting all of them.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "mcap/encoding.hpp"
#include "unit/mcap/fixture.hpp"

namespace regista::mcap {
namespace {

class OrderTest : public McapTest {
 protected:
  // Writes messages of three channels in this order.
  void write(const std::vector<Kept>& messages, std::size_t chunk_size = 2000) const {
    Writer writer(path("a.mcap"), {.chunk_size = chunk_size, .replace = true});
    for (const char* topic : {"/a", "/b", "/c"}) writer.add_channel(topic, "json");
    for (const Kept& each : messages) writer.write(message_of(each));
    writer.close();
  }
};

// `at_once`: how many messages share a time.
std::vector<Kept> made_up(std::size_t count, std::uint64_t at_once = 3, std::size_t size = 40) {
  std::vector<Kept> out;
  for (std::uint32_t i = 0; i < count; ++i) {
    out.push_back({static_cast<ChannelId>(1 + i % 3), i / 3, 1000 + i / at_once * 100, i, ""});
    out.back().data = std::to_string(i) + std::string(size, 'x');
  }
  return out;
}

// Moves messages by at most so many places.
void shuffle(std::vector<Kept>& messages, std::size_t reach, std::uint32_t seed) {
  std::mt19937 random(seed);
  for (std::size_t begin = 0; begin < messages.size(); begin += reach) {
    const std::size_t end = std::min(begin + reach, messages.size());
    for (std::size_t i = end - begin; i > 1; --i) std::swap(messages[begin + i - 1], messages[begin + random() % i]);
  }
}

std::vector<Kept> sorted(std::vector<Kept> messages) {
  std::ranges::stable_sort(messages, {},
                           [](const Kept& each) { return std::tuple(each.log_time, each.channel, each.sequence); });
  return messages;
}

TEST_F(OrderTest, IsThatOfTimeWhateverTheOrderOfTheFile) {
  for (const std::size_t reach : {1u, 10u, 60u, 600u}) {
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
      std::vector<Kept> messages = made_up(600);
      shuffle(messages, reach, seed);
      write(messages);
      EXPECT_EQ(read_all(path("a.mcap")).messages, messages);
      EXPECT_EQ(read_all(path("a.mcap"), {.by_time = true}).messages, sorted(messages));
      std::vector<Kept> some;
      for (const Kept& each : sorted(messages)) {
        if (each.channel == ChannelId{2} && each.log_time >= 4000 && each.log_time <= 15'000) some.push_back(each);
      }
      const Selection part{.first_time = 4000, .last_time = 15'000, .topics = {"/b"}, .by_time = true};
      EXPECT_EQ(read_all(path("a.mcap"), part).messages, some);
      // As a crash leaves it: without a summary.
      const std::string bytes = bytes_of(path("a.mcap"));
      write_bytes(path("cut.mcap"), std::string_view(bytes).substr(0, bytes.size() - 1));
      const Contents cut = read_all(path("cut.mcap"), {.by_time = true});
      EXPECT_EQ(cut.messages, sorted(messages));
      EXPECT_TRUE(cut.cut_off.has_value());
    }
  }
}

TEST_F(OrderTest, WithoutSequencesMessagesOfOneTimeKeepTheirOrder) {
  std::vector<Kept> messages = made_up(90, 30);
  for (Kept& each : messages) each.sequence = 0;
  shuffle(messages, 90, 1);
  write(messages);
  EXPECT_EQ(read_all(path("a.mcap"), {.by_time = true}).messages, sorted(messages));
}

// Only chunks that overlap in time are held, here of a file of 4 MB less than the 1.6 MB that are allowed.
TEST_F(OrderTest, TakesLittleMemoryWhereLittleIsOutOfOrder) {
  std::vector<Kept> messages = made_up(4000, 1, 1000);
  shuffle(messages, 6, 1);
  write(messages, 5000);
  const Contents contents = read_all(path("a.mcap"), {.by_time = true}, 200'000);
  EXPECT_EQ(contents.error, "");
  EXPECT_EQ(contents.messages, sorted(messages));
}

TEST_F(OrderTest, SaysWhenItWouldTakeTooMuch) {
  std::vector<Kept> messages = made_up(4000, 1, 1000);
  shuffle(messages, 4000, 1);
  write(messages, 5000);
  const std::string bytes = bytes_of(path("a.mcap"));
  write_bytes(path("cut.mcap"), std::string_view(bytes).substr(0, bytes.size() - 1));
  for (const auto& [file, why] : {std::pair("a.mcap", "is not in the order of time"), {"cut.mcap", "has no index"}}) {
    Reader reader(path(file), 200'000);
    reader.select({.by_time = true});
    Message message;
    try {
      while (reader.next(message)) continue;
      ADD_FAILURE() << file;
    } catch (const Unsortable& error) {
      EXPECT_EQ(error.what(), path(file).string() + ": " + why +
                                  "; at most 1600000 bytes can be sorted, and only by an index that is true");
    }
    EXPECT_FALSE(reader.next(message));
    // Another selection begins anew.
    reader.select({.topics = {"/b"}});
    EXPECT_TRUE(reader.next(message));
    EXPECT_EQ(message.data, std::ranges::find(messages, ChannelId{2}, &Kept::channel)->data);
  }
}

TEST_F(OrderTest, AnIndexWithWrongTimesIsNotBelieved) {
  std::string bytes(magic);
  append_record(bytes, Header{"elsewhere"});
  std::vector<ChunkIndex> chunks;
  const auto add = [&](std::uint64_t claimed, std::uint64_t time) {
    std::string records;
    append_record(records, Message{ChannelId{1}, 0, time, time, "x"});
    ChunkIndex& index = chunks.emplace_back();
    index.first_time = index.last_time = claimed;
    index.offset = bytes.size();
    index.compressed_size = index.uncompressed_size = records.size();
    index.length = record_prefix + 40 + records.size();
    append_chunk_fields(bytes, index, 0);
    bytes += records;
  };
  add(100, 100);
  add(200, 50);
  append_data_end(bytes, 0);
  const std::uint64_t summary_start = bytes.size();
  append_record(bytes, Channel{ChannelId{1}, SchemaId::none, "/t", "json"});
  for (const ChunkIndex& index : chunks) append_record(bytes, index);
  append_footer_fields(bytes, summary_start, 0);
  append_integer(bytes, std::uint32_t{0});
  write_bytes(path("a.mcap"), bytes.append(magic));
  EXPECT_EQ(read_all(path("a.mcap")).error, "");
  const Contents contents = read_all(path("a.mcap"), {.by_time = true});
  EXPECT_THAT(contents.error, testing::HasSubstr(": is not in the order of time; "));
  EXPECT_EQ(contents.messages.size(), 1u);
}

// Where the summary names no channels, a chunk may need what an earlier one defines.
TEST_F(OrderTest, ChannelsMayBeDefinedInAChunkThatIsLaterInTime) {
  std::string bytes(magic);
  append_record(bytes, Header{"elsewhere"});
  std::vector<ChunkIndex> chunks;
  for (const std::uint64_t time : {300u, 100u, 200u}) {
    std::string records;
    if (chunks.empty()) append_record(records, Channel{ChannelId{1}, SchemaId::none, "/t", "json"});
    append_record(records, Message{ChannelId{1}, 0, time, time, "x"});
    ChunkIndex& index = chunks.emplace_back();
    index.first_time = index.last_time = time;
    index.offset = bytes.size();
    index.compressed_size = index.uncompressed_size = records.size();
    index.length = record_prefix + 40 + records.size();
    append_chunk_fields(bytes, index, 0);
    bytes += records;
  }
  append_data_end(bytes, 0);
  const std::uint64_t summary_start = bytes.size();
  for (const ChunkIndex& index : chunks) append_record(bytes, index);
  append_footer_fields(bytes, summary_start, 0);
  append_integer(bytes, std::uint32_t{0});
  write_bytes(path("a.mcap"), bytes.append(magic));
  const Contents contents = read_all(path("a.mcap"), {.by_time = true});
  EXPECT_EQ(contents.error, "");
  EXPECT_TRUE(contents.indexed);
  std::vector<std::uint64_t> times;
  for (const Kept& each : contents.messages) times.push_back(each.log_time);
  EXPECT_THAT(times, testing::ElementsAre(100, 200, 300));
}

TEST_F(OrderTest, ADamagedChunkCostsOnlyItself) {
  std::vector<Kept> messages = made_up(300);
  shuffle(messages, 300, 1);
  write(messages);
  std::string bytes = bytes_of(path("a.mcap"));
  const ChunkIndex damaged = summary_of(path("a.mcap")).chunks.at(2);
  bytes[damaged.offset + damaged.length - 3] ^= '\1';
  write_bytes(path("b.mcap"), bytes);
  Reader reader(path("b.mcap"));
  reader.select({.by_time = true});
  std::vector<std::uint64_t> times;
  int errors = 0;
  for (Message message;;) {
    try {
      if (!reader.next(message)) break;
      times.push_back(message.log_time);
    } catch (const Error& error) {
      ++errors;
      EXPECT_THAT(error.what(), testing::HasSubstr(": is damaged at byte " + std::to_string(damaged.offset) + ": "));
    }
  }
  EXPECT_EQ(errors, 1);
  EXPECT_TRUE(std::ranges::is_sorted(times));
  EXPECT_EQ(times.size(), messages.size() - (damaged.message_index_length - damaged.message_indexes.size() * 15) / 16);
}

}  // namespace
}  // namespace regista::mcap
