// SPDX-License-Identifier: MIT
// Box2D, as the program is linked with it, reads no clock: see the end of host/match/physics_world.cpp.
#include <box2d/box2d.h>
#include <gtest/gtest.h>

namespace regista::match {
namespace {

TEST(PhysicsClock, IsNotRead) {
  b2World world({0.0f, 0.0f});
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  b2CircleShape shape;
  shape.m_radius = 1.0f;
  for (const float x : {0.0f, 1.5f}) {
    definition.position = {x, 0.0f};
    world.CreateBody(&definition)->CreateFixture(&shape, 1.0f);
  }
  for (int i = 0; i < 100; ++i) world.Step(0.02f, 8, 3);
  EXPECT_EQ(world.GetProfile().step, 0.0f);
  EXPECT_EQ(world.GetProfile().solve, 0.0f);
  EXPECT_EQ(b2Timer().GetMilliseconds(), 0.0f);
}

}  // namespace
}  // namespace regista::match
