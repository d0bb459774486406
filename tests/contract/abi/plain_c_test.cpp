// SPDX-License-Identifier: MIT
// A plugin in plain C is as good as any other.
#include <gtest/gtest.h>

#include <regista/testkit/contract.hpp>

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "plain_c");

namespace {

using namespace regista::testkit;

TEST(PlainC, GivesEachTaskToItsBestFreeRobot) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "plain_c");
  const Scene scene = FrameBuilder{}.own(1).robot(1).at(0, 0).robot(4).at(1, 0).task(0).task(1).build();
  Matrix u(2, 2);
  u(0, 0) = 0.3;
  u(0, 1) = 0.9;
  u(1, 0) = 0.5;
  u(1, 1) = 0.8;
  Instance instance(plugin, EnvironmentBuilder{}.own(1));
  EXPECT_EQ(instance.assign(scene, u), (std::vector<std::int32_t>{1, 0}));
}

}  // namespace
