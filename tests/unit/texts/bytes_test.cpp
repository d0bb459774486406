// SPDX-License-Identifier: MIT
// Values that become bytes and come back: against the layout that the machine itself has, and with bytes that nobody
// wrote.
#include "texts/bytes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace regista::texts {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class... Values>
Bytes written(Values... values) {
  BytesOut out;
  out(values...);
  return {out.bytes().begin(), out.bytes().end()};
}

template <class T>
T read(const Bytes& bytes) {
  BytesIn in(bytes);
  T out{};
  in(out);
  EXPECT_TRUE(in.empty());
  return out;
}

TEST(Bytes, AreLaidOutAsTheHeadSays) {
  if constexpr (std::endian::native != std::endian::little) GTEST_SKIP() << "numbers lie the other way round here";
  EXPECT_EQ(written(std::uint32_t{0x01020304}), (Bytes{4, 3, 2, 1}));
  EXPECT_EQ(written(std::string("ab")), (Bytes{2, 0, 0, 0, 'a', 'b'}));
  EXPECT_EQ(written(std::vector<std::uint16_t>{7, 8}), (Bytes{2, 0, 0, 0, 7, 0, 8, 0}));
  EXPECT_EQ(written(std::optional<std::uint8_t>(9)), (Bytes{1, 9}));
  EXPECT_EQ(written(std::optional<std::uint8_t>()), (Bytes{0}));
  EXPECT_EQ(written(true, std::uint8_t{5}), (Bytes{1, 5}));
}

TEST(Bytes, NumbersKeepEveryBit) {
  for (const double each : {0.0, -0.0, 1.0 / 3, std::numeric_limits<double>::denorm_min(),
                            std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::max()}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read<double>(written(each))), std::bit_cast<std::uint64_t>(each));
  }
  EXPECT_TRUE(std::isnan(read<double>(written(std::nan("7")))));
}

TEST(Bytes, TextsAndListsComeBack) {
  const std::string text("nought \0 inside, \xff and all", 26);
  EXPECT_EQ(read<std::string>(written(text)), text);
  EXPECT_EQ(read<std::string>(written(std::string())), "");
  const std::vector<std::string> list{"", "a", text};
  EXPECT_EQ(read<std::vector<std::string>>(written(list)), list);
  const std::optional<std::vector<int>> some(std::vector<int>{1, -2});
  EXPECT_EQ(read<std::optional<std::vector<int>>>(written(some)), some);
}

// Whoever writes after the other has lost its mind.
TEST(Bytes, WhatEndsTooEarlyIsRefused) {
  const Bytes whole = written(std::vector<std::string>{"abc", "d"});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    BytesIn in{std::span<const std::uint8_t>(whole).first(length)};
    std::vector<std::string> out;
    EXPECT_THROW(in(out), std::out_of_range) << length;
  }
}

TEST(Bytes, LengthsThatNobodyHasAreRefusedWithoutTheirMemory) {
  std::mt19937 random(1);
  for (int i = 0; i < 2000; ++i) {
    Bytes noise(random() % 64);
    std::ranges::generate(noise, [&random] { return static_cast<std::uint8_t>(random()); });
    BytesIn in(noise);
    std::vector<std::string> out;
    try {
      in(out);
    } catch (const std::out_of_range&) {
    }
    // Every element has taken four bytes or more, save the one that was begun.
    EXPECT_LE(out.size(), noise.size() / 4 + 1);
  }
}

TEST(Bytes, ABoolIsOneOfTwo) {
  // Two bytes that are no bool: to read them as one would be undefined.
  const Bytes odd{2, 255};
  BytesIn in(odd);
  bool first = false, second = false;
  in(first, second);
  EXPECT_TRUE(first && second);
}

TEST(Bytes, RoomIsUsedAgain) {
  BytesOut out;
  const std::uint64_t number = 1;
  out(number);
  out.clear();
  EXPECT_TRUE(out.bytes().empty());
  out(number, number);
  EXPECT_EQ(out.bytes().size(), 16u);
}

}  // namespace
}  // namespace regista::texts
