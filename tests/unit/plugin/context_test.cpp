// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <gtest/gtest.h>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

using ContextTest = PuppetTest;

TEST_F(ContextTest, HandsBackWhatThePluginSays) {
  const Scene scene;
  Context context(Puppet::instance());
  EXPECT_FALSE(context.holds(scene.frame));
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t* out, regista_error*) {
    *out = 1;
    return Puppet::ok;
  };
  EXPECT_TRUE(context.holds(scene.frame));
}

TEST_F(ContextTest, RefusesWhatIsNeitherYesNorNo) {
  const Scene scene;
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t* out, regista_error*) {
    *out = 2;
    return Puppet::ok;
  };
  EXPECT_EQ(message_of([&] { Context(Puppet::instance()).holds(scene.frame); }),
            Puppet::failure("holds: 2 is neither 0 nor 1"));
}

TEST_F(ContextTest, ReportsSharedObjectsByTheirFile) {
  const Scene scene;
  Context context(instance_of(open("throws")));
  EXPECT_EQ(message_of([&] { context.holds(scene.frame); }), failure("throws", "holds: fell in holds"));
}

}  // namespace
}  // namespace regista::plugin::test
