// SPDX-License-Identifier: MIT
// Statements as bytes: lengths by hand, there and back, and whatever strangers send.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "message.hpp"

namespace {

using namespace role_exchange;
using Bytes = std::vector<std::uint8_t>;

TEST(RoleExchangeMessage, Lengths) {
  EXPECT_EQ(message_bytes(19, 7), 11u);  // the league's teams of seven: 2 * 5 + 19 + 56 bits
  EXPECT_EQ(message_bytes(14, 7), 10u);
  EXPECT_EQ(message_bytes(64, 22), 32u);  // the largest there can be
}

TEST(RoleExchangeMessage, ByHand) {
  Statement said;
  said.forget(3);
  said.role = 1;
  said.utilities[2] = 255;
  Bytes bytes;
  write_statement(said, bytes);
  // Two bits each: role 1, wish 3 for none; bits 0 0 1; 255.
  EXPECT_EQ(bytes, (Bytes{0b1100'1101, 0b0111'1111}));
}

TEST(RoleExchangeMessage, ThereAndBack) {
  std::mt19937 random(9);
  Bytes bytes;
  for (int round = 0; round < 10000; ++round) {
    const std::size_t roles = 1 + random() % 64;
    Statement said, heard;
    said.forget(roles);
    said.role = static_cast<std::int32_t>(random() % (roles + 1)) - 1;
    said.wish = static_cast<std::int32_t>(random() % (roles + 1)) - 1;
    std::size_t told = 0;
    for (std::int16_t& each : said.utilities) {
      if (random() % 2 == 0) continue;
      each = static_cast<std::int16_t>(random() % 256);
      ++told;
    }
    write_statement(said, bytes);
    ASSERT_EQ(bytes.size(), message_bytes(roles, told));
    ASSERT_TRUE(read_statement(bytes, roles, heard));
    ASSERT_EQ(heard.role, said.role);
    ASSERT_EQ(heard.wish, said.wish);
    ASSERT_EQ(heard.utilities, said.utilities);
    bytes.push_back(0);
    ASSERT_FALSE(read_statement(bytes, roles, heard));
    bytes.resize(bytes.size() - 2);
    ASSERT_FALSE(read_statement(bytes, roles, heard));
  }
}

// What is read of any bytes is a statement about these roles, or refused.
TEST(RoleExchangeMessage, AnyBytes) {
  std::mt19937 random(10);
  int read = 0;
  for (int round = 0; round < 100000; ++round) {
    Bytes bytes(random() % 12);
    for (std::uint8_t& each : bytes) each = static_cast<std::uint8_t>(random());
    const std::size_t roles = 1 + random() % 20;
    Statement heard;
    if (!read_statement(bytes, roles, heard)) continue;
    ++read;
    for (const std::int32_t each : {heard.role, heard.wish}) {
      ASSERT_GE(each, no_role);
      ASSERT_LT(each, static_cast<std::int32_t>(roles));
    }
    ASSERT_EQ(heard.utilities.size(), roles);
    for (const std::int16_t each : heard.utilities) {
      ASSERT_GE(each, cannot);
      ASSERT_LE(each, 255);
    }
  }
  EXPECT_GT(read, 100);
}

}  // namespace
