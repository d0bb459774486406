// SPDX-License-Identifier: MIT
// Writer and reader hold one chunk, however long the file.
#include <malloc.h>

#include <algorithm>
#include <random>

#include "mcap/encoding.hpp"
#include "unit/mcap/fixture.hpp"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define REGISTA_HEAP_IS_NOT_MEASURED
#endif
#endif

namespace regista::mcap {
namespace {

std::size_t heap() {
  const struct mallinfo2 now = mallinfo2();
  return now.uordblks + now.hblkhd;
}

using MemoryTest = McapTest;

TEST_F(MemoryTest, OneChunkIsHeldWhileWritingAndReading) {
#ifdef REGISTA_HEAP_IS_NOT_MEASURED
  GTEST_SKIP() << "the sanitizer replaces the heap that is measured here";
#endif
  constexpr std::size_t chunk_size = std::size_t{1} << 20;
  constexpr std::uint32_t count = 60'000;
  std::mt19937 random(1);
  std::string data(1000, 'x');
  const std::size_t before = heap();
  std::size_t most = before;
  {
    Writer writer(path("a.mcap"), {.chunk_size = chunk_size});
    const ChannelId channel = writer.add_channel("/t", "json");
    for (std::uint32_t i = 0; i < count; ++i) {
      for (char& byte : data) byte = static_cast<char>(random());  // so that the compressed chunk is as large
      writer.write({channel, i, i, i, data});
      most = std::max(most, heap());
    }
    writer.close();
  }
  ASSERT_GT(std::filesystem::file_size(path("a.mcap")), 50 * chunk_size);
  EXPECT_LT(most - before, 6 * chunk_size);  // strings grow by doubling: up to 2 chunks plain, 2 finished

  most = before;
  Reader reader(path("a.mcap"));
  std::uint32_t read = 0;
  for (Message message; reader.next(message); ++read) {
    if (read % 16 == 0) most = std::max(most, heap());
  }
  EXPECT_EQ(read, count);
  EXPECT_LT(most - before, 4 * chunk_size);
}

TEST_F(MemoryTest, TwoGigabytesAreStreamed) {
  // An attachment of 2 GB, as a hole in the file, between two messages; then a schema of that size.
  constexpr std::uint64_t size = std::uint64_t{2} << 30;
  std::string front(magic);
  append_record(front, Header{"x"});
  append_record(front, Channel{ChannelId{1}, SchemaId::none, "/t", "json"});
  append_record(front, Message{ChannelId{1}, 0, 0, 0, "first"});
  const std::uint64_t hole_at = front.size();
  for (const Opcode opcode : {Opcode::attachment, Opcode::schema}) {
    std::string record = front;
    append_integer(record, static_cast<std::uint8_t>(opcode));
    append_integer(record, size);
    write_bytes(path("a.mcap"), record);
    std::filesystem::resize_file(path("a.mcap"), record.size() + size);
    std::string last;
    append_record(last, Message{ChannelId{1}, 1, 1, 1, "last"});
    std::ofstream(path("a.mcap"), std::ios::binary | std::ios::app)
        .write(last.data(), static_cast<std::streamsize>(last.size()));

    const std::size_t before = heap();
    Reader reader(path("a.mcap"));
    Message message;
    ASSERT_TRUE(reader.next(message));
    EXPECT_EQ(message.data, "first");
    if (opcode == Opcode::schema) {
      try {
        reader.next(message);
        FAIL() << "a schema of 2 GB was taken";
      } catch (const Error& error) {
        EXPECT_EQ(error.what(), path("a.mcap").string() + ": has a record of 2147483657 bytes at byte " +
                                    std::to_string(hole_at) + "; at most 67108864 can be read");
      }
    }
    ASSERT_TRUE(reader.next(message));
    EXPECT_EQ(message.data, "last");
    EXPECT_FALSE(reader.next(message));
    EXPECT_TRUE(reader.cut_off().has_value());
    EXPECT_LT(heap() - before, std::size_t{1} << 20);
  }
}

}  // namespace
}  // namespace regista::mcap
