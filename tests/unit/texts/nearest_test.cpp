// SPDX-License-Identifier: MIT
#include "texts/message.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace regista::texts {
namespace {

// The recurrence of the optimal string alignment distance, written down as it is defined.
std::size_t by_definition(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string_view a1 = a.substr(0, a.size() - 1), b1 = b.substr(0, b.size() - 1);
  std::size_t least = std::min(by_definition(a1, b) + 1, by_definition(a, b1) + 1);
  least = std::min(least, by_definition(a1, b1) + (a.back() == b.back() ? 0u : 1u));
  if (a.size() > 1 && b.size() > 1 && a.back() == b[b.size() - 2] && a[a.size() - 2] == b.back()) {
    least = std::min(least, by_definition(a.substr(0, a.size() - 2), b.substr(0, b.size() - 2)) + 1);
  }
  return least;
}

TEST(EditDistance, IsWhatItsRecurrenceSays) {
  std::mt19937 random(1);
  const auto word = [&] {
    std::string text(random() % 6, 'a');
    for (char& c : text) c = static_cast<char>('a' + random() % 3);
    return text;
  };
  for (int i = 0; i < 500; ++i) {
    const std::string a = word();
    const std::string b = word();
    EXPECT_EQ(edit_distance(a, b), by_definition(a, b)) << a << ' ' << b;
    EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << ' ' << b;
  }
}

TEST(EditDistance, KnownPairs) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // 2 for the unrestricted distance
  EXPECT_EQ(edit_distance("lenght", "length"), 1u);
  EXPECT_EQ(edit_distance("Length", "lENGTH"), 0u);
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> known{"length", "width", "goal_width", "goal_depth"};
  EXPECT_EQ(nearest("lenght", known), "length");
  EXPECT_EQ(nearest("goalwidth", known), "goal_width");
  EXPECT_EQ(nearest("widht", known), "width");
  EXPECT_EQ(nearest("temperature", known), "");
  // A mistake for each three letters begun.
  EXPECT_EQ(nearest("wodht", known), "width") << "two in five letters";
  EXPECT_EQ(nearest("wodu", known), "") << "three in four";
  EXPECT_EQ(nearest("lonhgt", known), "") << "three in six";
  EXPECT_EQ(nearest("", known), "");
  EXPECT_EQ(nearest("x", std::vector<std::string>{"y", "ab"}), "");
  EXPECT_EQ(nearest("cat", std::vector<std::string>{"bat", "hat"}), "bat") << "the first of equals";
  EXPECT_EQ(nearest(std::string(1000000, 'a'), known), "");
}

}  // namespace
}  // namespace regista::texts
