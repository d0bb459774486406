// SPDX-License-Identifier: MIT
// The shared object of best_first, called as a host calls it, and by the installed testkit.
#include <dlfcn.h>
#include <gmock/gmock.h>

#include <array>

#include <regista/abi.h>
#include <regista/testkit/contract.hpp>

namespace {

const regista_descriptor* open_plugin() {
  void* library = dlopen(REGISTA_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
  if (!library) return nullptr;
  const auto entry = reinterpret_cast<decltype(&regista_plugin_entry)>(dlsym(library, REGISTA_ENTRY_NAME));
  return entry ? entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, 0) : nullptr;
}

TEST(BestFirst, GivesEachTaskInOrderToItsBestFreeRobot) {
  const regista_descriptor* plugin = open_plugin();
  ASSERT_NE(plugin, nullptr);
  EXPECT_STREQ(plugin->id, "best_first");
  ASSERT_EQ(plugin->parameter_count, 1u);
  EXPECT_STREQ(plugin->parameters->name, "least");

  const auto* assigner = static_cast<const regista_assigner*>(plugin->table(REGISTA_KIND_ASSIGNER));
  ASSERT_NE(assigner, nullptr);
  regista_error error{};
  const regista_environment environment{};
  const regista_host host{};
  const regista_value least{0.5, nullptr, 0};
  void* instance = plugin->create(&environment, &host, {&least, 1, sizeof least}, &error);
  ASSERT_NE(instance, nullptr) << error.text;

  // Robot 0 is best for both tasks; task 0 comes first and takes it, though the sum would be larger the other way.
  // Nobody is good enough for task 2.
  std::array<double, 9> utilities{0.9, 1.0, 0.1,  //
                                  0.8, 0.6, 0.1,  //
                                  0.7, 0.7, 0.2};
  const regista_matrix matrix{utilities.data(), 3, 3, 3, 0};
  regista_frame frame{};
  frame.size = sizeof frame;
  std::array<std::int32_t, 3> out{REGISTA_NO_TASK, REGISTA_NO_TASK, REGISTA_NO_TASK};
  ASSERT_EQ(assigner->assign(instance, &frame, &matrix, out.data(), &error), REGISTA_OK) << error.text;
  EXPECT_THAT(out, testing::ElementsAre(0, REGISTA_NO_TASK, 1));
  plugin->destroy(instance);
}

REGISTA_ASSIGNER_CONTRACT(REGISTA_PLUGIN_FILE, "best_first", {.may_idle = true});

}  // namespace
