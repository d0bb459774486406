// SPDX-License-Identifier: MIT
// This program is the shared object that is looked at.
#include "plugin/elf_file.hpp"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "process/sanitized.hpp"

namespace regista::plugin {

// Not in a namespace without a name: their names are in the file's table of symbols.
int changed_in_own_memory_test = 0;
std::array<int, 1000> zero_in_own_memory_test{};
thread_local int of_thread_in_own_memory_test = 1;

namespace {

const void* code() { return reinterpret_cast<const void*>(&variable_at); }

std::string variable(const OwnMemory& memory) {
  const auto change = memory.change();
  return change ? variable_at("/proc/self/exe", *change) : "none";
}

TEST(OwnMemory, NamesTheVariableThatWasChanged) {
  if (sanitized) GTEST_SKIP() << "a sanitizer has its own there";
  OwnMemory memory(code());
  memory.remember();
  EXPECT_EQ(variable(memory), "none");
  changed_in_own_memory_test = 1;
  EXPECT_EQ(variable(memory), "regista::plugin::changed_in_own_memory_test");
  changed_in_own_memory_test = 0;
  EXPECT_EQ(variable(memory), "none");
  zero_in_own_memory_test[999] = 1;
  EXPECT_EQ(variable(memory), "regista::plugin::zero_in_own_memory_test");
  zero_in_own_memory_test[999] = 0;
}

TEST(OwnMemory, KnowsVariablesOfItsThread) {
  if (sanitized) GTEST_SKIP() << "a sanitizer has its own there";
  OwnMemory memory(code());
  memory.remember();
  ++of_thread_in_own_memory_test;
  ASSERT_TRUE(memory.change());
  EXPECT_TRUE(memory.change()->of_thread);
  EXPECT_EQ(variable(memory), "regista::plugin::of_thread_in_own_memory_test");
  --of_thread_in_own_memory_test;
}

TEST(OwnMemory, OthersMemoryIsNotItsOwn) {
  OwnMemory memory(code());
  memory.remember();
  auto on_the_heap = std::make_unique<int>(1);
  *on_the_heap = 2;
  EXPECT_EQ(variable(memory), "none");
  OwnMemory nobodys(on_the_heap.get());
  nobodys.remember();
  ++changed_in_own_memory_test;
  EXPECT_FALSE(nobodys.change());
}

}  // namespace
}  // namespace regista::plugin
