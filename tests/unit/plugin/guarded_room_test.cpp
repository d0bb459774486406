// SPDX-License-Identifier: MIT
#include "plugin/answer_buffers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace regista::plugin::test {
namespace {

// The bytes around an answer of three numbers.
struct Room {
  GuardedBuffer<std::int32_t> room{10};
  unsigned char* begin = reinterpret_cast<unsigned char*>(room.open(3));
  unsigned char* end = begin + 3 * sizeof(std::int32_t);
};

TEST(GuardedBuffer, BeginsWithZerosAndTakesAllThatIsPromised) {
  Room wrong;
  EXPECT_TRUE(std::all_of(wrong.begin, wrong.end, [](unsigned char byte) { return byte == 0; }));
  std::fill(wrong.begin, wrong.end, 0xff);
  EXPECT_EQ(wrong.room.difference_at_edges(), 0u);
  EXPECT_EQ(wrong.room.overflow(), Overflow::none);
  EXPECT_EQ(wrong.room.first(2).size(), 2u);
}

// Whatever memory is filled with, and however far.
TEST(GuardedBuffer, FindsOverflowsOfFourToAll) {
  for (const std::size_t bytes : {4u, 5u, 8u, 12u, 24u, 100u, 255u, 256u}) {
    for (int fill = 0; fill < 256; ++fill) {
      Room behind, before;
      std::fill_n(behind.end, bytes, static_cast<unsigned char>(fill));
      ASSERT_NE(behind.room.difference_at_edges(), 0u) << bytes << " of " << fill;
      ASSERT_EQ(behind.room.overflow(), Overflow::past_the_end);
      std::fill_n(before.begin - bytes, bytes, static_cast<unsigned char>(fill));
      ASSERT_NE(before.room.difference_at_edges(), 0u) << bytes << " of " << fill;
      ASSERT_EQ(before.room.overflow(), Overflow::before_the_beginning);
    }
  }
}

// Every single byte of the pattern is looked at.
TEST(GuardedBuffer, FindsWhatJumpsOverTheEdges) {
  for (std::size_t distance = 0; distance < Guard::margin; ++distance) {
    Room behind, before;
    behind.end[distance] ^= 1;
    ASSERT_EQ(behind.room.overflow(), Overflow::past_the_end) << distance;
    before.begin[-1 - static_cast<std::ptrdiff_t>(distance)] ^= 1;
    ASSERT_EQ(before.room.overflow(), Overflow::before_the_beginning) << distance;
    before.room.mend();
    ASSERT_EQ(before.room.overflow(), Overflow::none);
  }
}

// The pattern stands behind what is promised now, not behind all the memory there is.
TEST(GuardedBuffer, MovesItsEndWithThePromise) {
  GuardedBuffer<std::int32_t> room(10);
  for (const std::size_t count : {10u, 3u, 0u, 7u, 500u, 2u}) {
    std::int32_t* const data = room.open(count);
    EXPECT_EQ(room.overflow(), Overflow::none) << count;
    std::fill_n(data, count, 5);
    EXPECT_EQ(room.overflow(), Overflow::none) << count;
    data[count] = 5;
    EXPECT_NE(room.difference_at_edges(), 0u) << count;
    room.mend();
  }
}

}  // namespace
}  // namespace regista::plugin::test
