// SPDX-License-Identifier: MIT
// Compared with the whole text, cut by hand.
#include "process/child.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace regista::process {
namespace {

constexpr std::size_t most = 4096;

std::string text_of(std::size_t length) {
  std::string out;
  for (std::size_t i = 0; out.size() < length; ++i) out += std::to_string(i) + ' ';
  return out.substr(0, length);
}

std::string expected(const std::string& whole) {
  if (whole.size() <= 2 * most) return whole;
  return whole.substr(0, most) + "\n[" + std::to_string(whole.size() - 2 * most) + " bytes are left out]\n" +
         whole.substr(whole.size() - most);
}

TEST(KeptOutput, KeepsAllOfALittle) {
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, most - 1, most, most + 1, 2 * most}) {
    KeptOutput kept;
    kept.add(text_of(length));
    EXPECT_EQ(kept.text(), text_of(length)) << length;
  }
}

TEST(KeptOutput, KeepsBeginningAndEndOfMuch) {
  for (const std::size_t length : {2 * most + 1, 3 * most, 100 * most + 17}) {
    KeptOutput kept;
    kept.add(text_of(length));
    EXPECT_EQ(kept.text(), expected(text_of(length))) << length;
  }
}

TEST(KeptOutput, ItDoesNotMatterInWhichPiecesItComes) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    const std::string whole = text_of(random() % (5 * most));
    KeptOutput kept;
    for (std::size_t done = 0; done < whole.size();) {
      const std::string piece = whole.substr(done, random() % (round % 2 == 0 ? 40 : 3 * most));
      kept.add(piece);
      done += piece.size();
    }
    EXPECT_EQ(kept.text(), expected(whole)) << whole.size();
  }
}

}  // namespace
}  // namespace regista::process
