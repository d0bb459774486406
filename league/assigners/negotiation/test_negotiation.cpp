// SPDX-License-Identifier: MIT
// What all negotiating assigners build on: bits keep what is written, nonsense is noticed, epochs are in order.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "bits.hpp"
#include "epoch.hpp"

namespace {

using namespace negotiation;

TEST(Bits, KeepWhatIsWrittenAndTellWhatIsNot) {
  std::mt19937 random(11);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::uint8_t> bytes;
    BitWriter writer(bytes);
    std::vector<std::pair<std::uint32_t, unsigned>> numbers(random() % 20);
    unsigned all = 0;
    for (auto& [value, bits] : numbers) {
      bits = 1 + random() % 32;
      value = static_cast<std::uint32_t>(random()) & (bits == 32 ? ~0u : (1u << bits) - 1u);
      writer.put(value, bits);
      all += bits;
    }
    ASSERT_EQ(bytes.size(), (all + 7) / 8);
    BitReader reader(bytes);
    for (const auto& [value, bits] : numbers) ASSERT_EQ(reader.get(bits), value);
    EXPECT_TRUE(reader.complete());
    if (bytes.empty()) continue;
    BitReader cut(std::span<const std::uint8_t>(bytes).first(bytes.size() - 1));
    for (const auto& [value, bits] : numbers) cut.get(bits);
    EXPECT_FALSE(cut.complete());
    bytes.push_back(0);
    BitReader longer(bytes);
    for (const auto& [value, bits] : numbers) longer.get(bits);
    EXPECT_FALSE(longer.complete());
  }
}

TEST(Bits, ABitBehindTheLastNumberIsNoticed) {
  const std::vector<std::uint8_t> bytes{0b1000'0001};
  BitReader reader(bytes);
  EXPECT_EQ(reader.get(5), 1u);
  EXPECT_FALSE(reader.complete());
}

TEST(Epochs, AreSerialNumbers) {
  EXPECT_EQ(compare_epochs(3, 250), Order::later);
  EXPECT_EQ(compare_epochs(250, 3), Order::earlier);
  EXPECT_EQ(compare_epochs(7, 7), Order::same);
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const Order one = compare_epochs(static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b));
      const Order other = compare_epochs(static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(a));
      EXPECT_EQ(one == Order::later, other == Order::earlier) << a << ' ' << b;
    }
  }
}

Subject subject(std::initializer_list<int> robots, std::initializer_list<int> tasks) {
  Subject out;
  for (const int number : robots) out.add_robot(number);
  for (const int id : tasks) out.add_task(id);
  return out;
}

TEST(Epochs, BeginWhenRobotsOrTasksChangeAndAreJoined) {
  Epoch epoch;
  EXPECT_FALSE(epoch.about(subject({1, 2}, {3, 4})));
  EXPECT_FALSE(epoch.about(subject({2, 1}, {4, 3})));  // the order does not count
  EXPECT_EQ(epoch.number(), 0);
  EXPECT_TRUE(epoch.about(subject({1}, {3, 4})));
  EXPECT_TRUE(epoch.about(subject({1}, {3})));
  EXPECT_TRUE(epoch.about(subject({3}, {1})));  // a task is no robot
  EXPECT_EQ(epoch.number(), 3);
  Subject again = subject({3}, {1});
  again.add_round(0);
  EXPECT_FALSE(again == subject({3}, {1}));
  EXPECT_FALSE(again == subject({3}, {1, 0}));  // a round is no task
  EXPECT_FALSE(epoch.hear(2).counts);
  EXPECT_TRUE(epoch.hear(3).counts);
  const Epoch::Heard heard = epoch.hear(9);
  EXPECT_TRUE(heard.joined && heard.counts);
  EXPECT_EQ(epoch.number(), 9);
  EXPECT_FALSE(epoch.about(subject({3}, {1})));
}

}  // namespace
