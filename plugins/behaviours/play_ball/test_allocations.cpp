// SPDX-License-Identifier: MIT
// A decision in the steady state allocates nothing: it is asked ten times a second in each of fourteen robots.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include <regista/testkit/count_allocations.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;

// With every part of the behaviour: the choice of a kick, the search, the way along edges.
std::vector<Scene> course() {
  FrameBuilder scene = FrameBuilder{}.own(2).task("striker").at(3.2, 2.2).along_edges().ball(0.5, 0.3);
  for (int n = 1; n <= 7; ++n) scene.robot(n).at(0.5 * n - 3.0, 0.3 * n);
  for (int k = 0; k < 7; ++k) scene.opponent(0.6 * k - 1.0, 0.2 * k);
  scene.waypoint(-3, -2).waypoint(-3, 2).waypoint(3, 2).edge(0, 1).edge(1, 2);
  return {scene.build(), FrameBuilder(scene).set_play(REGISTA_SET_PLAY_KICK_IN, false).build(),
          FrameBuilder(scene).no_ball().build(), FrameBuilder(scene).phase(REGISTA_PHASE_READY).build()};
}

// values: of the parameters.
void expect_none(const Loaded& plugin, const Values& values) {
  const regista_descriptor& descriptor = plugin.descriptor();
  const auto* table = static_cast<const regista_behaviour*>(descriptor.table(REGISTA_KIND_BEHAVIOUR));
  const Setting setting = EnvironmentBuilder{}.own(2).build();
  const RecordingHost host;
  const std::vector<regista_value> raw = values.raw();
  regista_error error{};
  const regista_span all{raw.data(), static_cast<std::uint32_t>(raw.size()), sizeof(regista_value)};
  void* instance = descriptor.create(&setting.raw(), host.raw(), all, &error);
  ASSERT_NE(instance, nullptr) << error.text;
  ASSERT_EQ(descriptor.reset(instance, 1, &error), REGISTA_OK);
  const std::vector<Scene> scenes = course();
  const BodyBuilder body = BodyBuilder{}.at(-3, -1.9).task(0).sees_ball();
  const auto decide = [&] {
    std::int32_t status = REGISTA_OK;
    for (const Scene& scene : scenes) {
      regista_action action{};
      action.size = sizeof action;
      action.kick = REGISTA_NO_KICK;
      status |= table->act(instance, &scene.raw(), &body.raw(), &action, &error);
    }
    return status;
  };
  EXPECT_EQ(decide(), REGISTA_OK);
  EXPECT_EQ(allocations_during([&] { decide(); }), 0u);
  descriptor.destroy(instance);
}

TEST(PlayBallAllocations, NoneInADecision) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "play_ball");
  expect_none(plugin, Values(plugin));
  expect_none(plugin, Values(plugin).set("nearest_plays", 1).set("kick_rule", "expected_gain"));
}

}  // namespace
