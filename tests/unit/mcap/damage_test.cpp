// SPDX-License-Identifier: MIT
// Every byte of a file changed: an error, or the content as it was.
#include <random>

#include "fuzz/mcap/examine.hpp"
#include "unit/mcap/fixture.hpp"
#include "unit/mcap/plain_chunks.hpp"

namespace regista::mcap {
namespace {

// With chunks as the writer compresses them, and with plain ones, where changes reach what a chunk holds.
class DamageTest : public McapTest, public testing::WithParamInterface<bool> {
 protected:
  DamageTest() : McapTest(quick_folder()) {}

  // The bytes of a.mcap.
  std::string write(int messages, Example* example = nullptr) {
    const Example written = write_example(path("a.mcap"), {.chunk_size = 400}, messages);
    if (example != nullptr) *example = written;
    if (GetParam()) write_bytes(path("a.mcap"), with_plain_chunks(bytes_of(path("a.mcap"))));
    return bytes_of(path("a.mcap"));
  }
};

INSTANTIATE_TEST_SUITE_P(Plain, DamageTest, testing::Bool());

TEST_P(DamageTest, EveryByteChangedIsAnErrorOrChangesNothing) {
  const std::string bytes = write(12);
  const Contents whole = read_all(path("a.mcap"));
  const std::uint64_t header_end = 8 + 9 + 4 + 4 + std::string_view("regista").size();
  std::size_t errors = 0;
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const char change : {'\x01', '\x80', '\xff'}) {
      SCOPED_TRACE("byte " + std::to_string(at) + " changed by " + std::to_string(change));
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ change);
      write_bytes(path("b.mcap"), changed);
      const Contents contents = read_all(path("b.mcap"));
      if (!contents.error.empty()) {
        ++errors;
        ASSERT_TRUE(contents.error.starts_with(path("b.mcap").string() + ": ")) << contents.error;
        ASSERT_EQ(contents.error.find('\n'), std::string::npos);
        continue;
      }
      ASSERT_GE(at, 8u);
      ASSERT_EQ(contents.messages, whole.messages);
      if (contents.indexed || at >= header_end) {
        ASSERT_EQ(contents.channels, whole.channels);
      }
    }
  }
  EXPECT_GT(errors, bytes.size());  // far more than half of it is guarded when it is read
}

TEST_P(DamageTest, ADamagedChunkCostsOnlyItself) {
  Example example;
  std::string bytes = write(40, &example);
  const std::vector<ChunkIndex> chunks = summary_of(path("a.mcap")).chunks;
  ASSERT_GE(chunks.size(), 4u);
  const ChunkIndex& damaged = chunks[2];
  char& byte = bytes[damaged.offset + damaged.length - 3];
  byte = static_cast<char>(byte ^ 1);
  // With the summary, and without it.
  for (const std::string& file : {bytes, bytes.substr(0, bytes.size() - 100)}) {
    write_bytes(path("b.mcap"), file);
    Reader reader(path("b.mcap"));
    std::size_t count = 0;
    std::vector<std::string> errors;
    Message message;
    while (true) {
      try {
        if (!reader.next(message)) break;
        ++count;
      } catch (const Error& error) {
        errors.emplace_back(error.what());
      }
    }
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_TRUE(errors[0].starts_with(path("b.mcap").string() + ": is damaged at byte " +
                                      std::to_string(damaged.offset) + ": "))
        << errors[0];
    const std::size_t lost = (damaged.message_index_length - damaged.message_indexes.size() * 15) / 16;
    EXPECT_EQ(count, example.messages.size() - lost);
  }
}

// Behind the checksums: whatever a hostile file says, the reader ends with an error or with messages.
TEST_P(DamageTest, WithoutChecksumsNothingBreaksEither) {
  const std::string bytes = without_checksums(write(12));
  write_bytes(path("b.mcap"), bytes);
  const std::size_t messages = examine(path("b.mcap"));
  EXPECT_GT(messages, 15u);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const char change : {'\x01', '\x80', '\xff'}) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ change);
      write_bytes(path("b.mcap"), changed);
      examine(path("b.mcap"));
    }
  }
  std::mt19937 random(5);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = bytes;
    for (std::size_t k = 0; k < 1 + random() % 8; ++k) changed[random() % changed.size()] = static_cast<char>(random());
    if (random() % 4 == 0) changed.erase(random() % changed.size(), random() % 40);
    write_bytes(path("b.mcap"), changed);
    examine(path("b.mcap"));
  }
}

}  // namespace
}  // namespace regista::mcap
