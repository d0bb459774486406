// SPDX-License-Identifier: MIT
// Chunks that LZ4's own library compressed, as other programs write them.
#include <gmock/gmock.h>
#include <lz4frame.h>

#include <random>

#include "mcap/encoding.hpp"
#include "unit/mcap/fixture.hpp"
#include "unit/mcap/plain_chunks.hpp"

namespace regista::mcap {
namespace {

std::string lz4_frame(std::string_view bytes, const LZ4F_preferences_t& preferences = {}) {
  std::string out(LZ4F_compressFrameBound(bytes.size(), &preferences), '\0');
  const std::size_t size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &preferences);
  if (LZ4F_isError(size) != 0) throw std::runtime_error(LZ4F_getErrorName(size));
  out.resize(size);
  return out;
}

// Everything that a frame may choose: sizes of blocks, linked or not, checksums, a size beforehand, degrees.
std::vector<LZ4F_preferences_t> all_preferences() {
  std::vector<LZ4F_preferences_t> out;
  for (const auto size : {LZ4F_max64KB, LZ4F_max4MB}) {
    for (const auto mode : {LZ4F_blockLinked, LZ4F_blockIndependent}) {
      for (const auto checksum : {LZ4F_noContentChecksum, LZ4F_contentChecksumEnabled}) {
        for (const int level : {0, 9}) {
          LZ4F_preferences_t each{};
          each.frameInfo.blockSizeID = size;
          each.frameInfo.blockMode = mode;
          each.frameInfo.contentChecksumFlag = checksum;
          each.frameInfo.blockChecksumFlag = level == 0 ? LZ4F_noBlockChecksum : LZ4F_blockChecksumEnabled;
          each.compressionLevel = level;
          out.push_back(each);
        }
      }
    }
  }
  return out;
}

std::string refusal(std::string_view frames, std::uint64_t size) {
  std::string to;
  try {
    decompress_lz4(frames, size, to);
  } catch (const Malformed& malformed) {
    return malformed.why;
  }
  return "";
}

TEST(Lz4, UnpacksWhatItsLibraryPacked) {
  std::mt19937 random(3);
  std::string noise(300'000, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += R"({"time":)" + std::to_string(i) + R"(,"ball":[1,2]})";
  const std::vector<std::string> samples{"", "a", "{\"ball\": [0, 0]}", noise, text, std::string(5'000'000, 'x')};
  std::string unpacked;
  for (const LZ4F_preferences_t& preferences : all_preferences()) {
    for (const std::string& bytes : samples) {
      const std::string frame = lz4_frame(bytes, preferences);
      decompress_lz4(frame, bytes.size(), unpacked);
      EXPECT_EQ(unpacked, bytes);
      // Frames may follow each other.
      decompress_lz4(frame + frame, 2 * bytes.size(), unpacked);
      EXPECT_EQ(unpacked, bytes + bytes);
    }
  }
}

TEST(Lz4, DoesNotTrustSizes) {
  const std::string bytes(100'000, 'x'), frame = lz4_frame(bytes);
  EXPECT_EQ(refusal(frame, bytes.size()), "");
  EXPECT_EQ(refusal(frame, bytes.size() + 1), "a chunk holds fewer bytes than it claims");
  EXPECT_EQ(refusal(frame, std::uint64_t{1} << 40), "a chunk claims more bytes than it can hold");
  EXPECT_EQ(refusal("", 1), "a chunk holds fewer bytes than it claims");
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, bytes.size() - 1}) {
    EXPECT_EQ(refusal(frame, size), "a chunk holds more bytes than it claims") << size;
  }
  for (std::size_t length = 0; length < frame.size(); ++length) {
    EXPECT_THAT(
        refusal(frame.substr(0, length), bytes.size()),
        testing::AnyOf("a chunk holds fewer bytes than it claims", "a chunk claims more bytes than it can hold"));
  }
}

TEST(Lz4, WhateverStandsInAFrameItEnds) {
  std::mt19937 random(4);
  std::string text;
  for (int i = 0; i < 500; ++i) text += std::to_string(random() % 1000) + ", ";
  const std::string frame = lz4_frame(text);
  int refused = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string changed = frame;
    for (std::size_t k = 0; k < 1 + random() % 4; ++k) changed[random() % changed.size()] = static_cast<char>(random());
    refused += refusal(changed, text.size()).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 1000);
  EXPECT_EQ(refusal("no frame at all", 15), "a chunk cannot be decompressed: ERROR_frameType_unknown");
}

class Lz4Test : public McapTest {};

TEST_F(Lz4Test, AFileHoldsTheSameHoweverItIsPacked) {
  const Example example = write_example(path("a.mcap"), {.chunk_size = 400});
  const std::string packed = with_packed_chunks(bytes_of(path("a.mcap")),
                                                {"lz4", [](const std::string& records) { return lz4_frame(records); }});
  // With the summary, and as a crash leaves it.
  for (const std::size_t cut : {0u, 1u}) {
    write_bytes(path("b.mcap"), std::string_view(packed).substr(0, packed.size() - cut));
    const Contents contents = read_all(path("b.mcap"));
    EXPECT_EQ(contents.error, "");
    EXPECT_EQ(contents.indexed, cut == 0);
    EXPECT_EQ(contents.messages, example.messages);
    EXPECT_EQ(contents.metadata, example.metadata);
  }
  Reader reader(path("b.mcap"));
  EXPECT_FALSE(reader.has_lz4());
  for (Message message; reader.next(message);) EXPECT_TRUE(reader.has_lz4());
}

TEST_F(Lz4Test, ADamagedChunkIsNamed) {
  write_example(path("a.mcap"), {.chunk_size = 400});
  std::string bytes = with_packed_chunks(bytes_of(path("a.mcap")),
                                         {"lz4", [](const std::string& records) { return lz4_frame(records); }});
  write_bytes(path("b.mcap"), bytes);
  const ChunkIndex chunk = summary_of(path("b.mcap")).chunks.at(1);
  int named = 0;
  for (std::size_t at = chunk.offset + chunk.length - chunk.compressed_size; at < chunk.offset + chunk.length; ++at) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    write_bytes(path("b.mcap"), changed);
    const std::string error = read_all(path("b.mcap")).error;
    if (error.empty()) continue;  // a bit of the frame that says nothing of the content
    EXPECT_THAT(error, testing::HasSubstr(": is damaged at byte " + std::to_string(chunk.offset) + ": ")) << at;
    named += error.ends_with(": the checksum of a chunk is wrong") ? 1 : 0;
  }
  EXPECT_GT(named, 20);
}

}  // namespace
}  // namespace regista::mcap
