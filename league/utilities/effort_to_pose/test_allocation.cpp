// SPDX-License-Identifier: MIT
// A score allocates nothing, in the plugin either: what a call needs is reserved when an instance is made.
#include <gtest/gtest.h>
#include <regista/testkit/count_allocations.hpp>

#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/loaded.hpp>
#include <regista/testkit/recording_host.hpp>

#include <vector>

namespace {

using namespace regista::testkit;

std::vector<double> kept;  // outside of functions, so that no compiler leaves an allocation out

TEST(EffortToPosePlugin, ACallAllocatesNothing) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "effort_to_pose");
  const regista_descriptor& descriptor = plugin.descriptor();
  const auto* calls = static_cast<const regista_utility*>(descriptor.table(REGISTA_KIND_UTILITY));
  const Setting setting = EnvironmentBuilder{}.own(2).build();
  RecordingHost host;
  std::vector<regista_value> raw;
  for (std::uint32_t k = 0; k < descriptor.parameter_count; ++k)
    raw.push_back({descriptor.parameters[k].initial, nullptr, 0});
  regista_error error{};
  void* const instance = descriptor.create(
      &setting.raw(), host.raw(), {raw.data(), static_cast<std::uint32_t>(raw.size()), sizeof(regista_value)}, &error);
  ASSERT_NE(instance, nullptr) << error.text;
  FrameBuilder frame;
  frame.own(2);
  for (int number = 1; number <= 7; ++number) frame.robot(number).at(0.3 * number, 0.1);
  for (int k = 0; k < 11; ++k) frame.opponent(0.5 * k - 2.0, 0.2);
  for (int id = 0; id < 11; ++id) frame.task(id).at(0.4 * id - 2.0, -1.0);
  const Scene scene = frame.build();
  std::vector<double> out(7 * 11);
  const regista_matrix_room room{out.data(), 7, 11, 11, 0};
  std::int32_t status = REGISTA_FAILED;
  EXPECT_EQ(allocations_during([&] { status = calls->score(instance, &scene.raw(), &room, &error); }), 0u);
  EXPECT_EQ(status, REGISTA_OK) << error.text;
  descriptor.destroy(instance);
  EXPECT_GT(allocations_during([] { kept = std::vector<double>(1000); }), 0u);  // it does count
}

}  // namespace
