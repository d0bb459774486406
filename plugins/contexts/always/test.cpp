// SPDX-License-Identifier: MIT
// There is no algorithm to test here; the plugin itself is opened and asked.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <regista/abi.h>

namespace {

TEST(Always, HoldsInAnEmptyFrame) {
  void* object = dlopen(REGISTA_PLUGIN_FILE, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(object, nullptr) << dlerror();
  const auto entry = reinterpret_cast<decltype(&regista_plugin_entry)>(dlsym(object, REGISTA_ENTRY_NAME));
  ASSERT_NE(entry, nullptr);
  const regista_descriptor* descriptor = entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, 0);
  ASSERT_NE(descriptor, nullptr);
  EXPECT_STREQ(descriptor->id, "always");
  const auto* calls = static_cast<const regista_context*>(descriptor->table(REGISTA_KIND_CONTEXT));
  ASSERT_NE(calls, nullptr);
  regista_error error{};
  const regista_environment environment{};
  void* instance = descriptor->create(&environment, nullptr, nullptr, &error);
  ASSERT_NE(instance, nullptr) << error.text;
  const regista_frame frame{};
  std::int32_t out = 0;
  EXPECT_EQ(calls->holds(instance, &frame, &out, &error), REGISTA_OK);
  EXPECT_EQ(out, 1);
  descriptor->destroy(instance);
}

}  // namespace
