// SPDX-License-Identifier: MIT
// Whoever declares what it reads is sound; whoever reads a part more is found, whatever part it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include <regista/testkit/checks.hpp>

namespace {

using namespace regista::testkit;

const Check& reads() {
  static const std::vector<Check> all = contract(REGISTA_KIND_UTILITY);
  for (const Check& check : all) {
    if (check.name == "reads") return check;
  }
  throw std::logic_error("no check of this name");
}

class Reads : public testing::TestWithParam<const char*> {};

TEST_P(Reads, WhatIsDeclaredIsAllThatIsNeeded) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, std::string("declares_") + GetParam());
  EXPECT_TRUE(reads().applies(plugin, {}));
  EXPECT_EQ(reads().run(plugin, {}).text(), "");
}

TEST_P(Reads, WhatIsNotDeclaredIsNotRead) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, std::string("hides_") + GetParam());
  EXPECT_TRUE(reads().applies(plugin, {}));
  EXPECT_THAT(reads().run(plugin, {}).lines(),
              testing::Contains(testing::HasSubstr("parts of the frame that its `reads` do not name")));
}

INSTANTIATE_TEST_SUITE_P(Parts, Reads,
                         testing::Values("opponents_mine", "opponents_common", "covariance_of_robots",
                                         "covariance_of_opponents", "covariance_of_the_ball", "facings_before",
                                         "facings_after", "times", "size_of_times", "waypoints", "edges", "previous"),
                         [](const auto& part) { return std::string(part.param); });

// Truth: abi.h; what later versions add is read as well by whoever reads all.
TEST(Reads, WhoReadsAllHasNothingToHide) {
  regista_descriptor descriptor = Loaded(REGISTA_PLUGIN_FILE, "declares_times").descriptor();
  descriptor.reads = REGISTA_READS_ALL;
  EXPECT_FALSE(reads().applies(Loaded(descriptor), {}));
}

}  // namespace
