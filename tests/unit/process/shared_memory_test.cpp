// SPDX-License-Identifier: MIT
#include "process/file_descriptor.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <system_error>
#include <utility>

namespace regista::process {
namespace {

struct Pair {
  int first = 3, second = 4;
};

TEST(SharedMemory, OutlivesTheProcessThatWroteIt) {
  SharedMemory<Pair> shared;
  EXPECT_EQ(shared->first, 3);
  const pid_t child = fork();
  if (child == 0) {
    const SharedMemory<Pair> inherited{FileDescriptor(dup(shared.descriptor()))};
    inherited->second = 417;
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(shared->second, 417);
  shared.clear();
  EXPECT_EQ(shared->second, 4);
}

// A copy of the process needs no descriptor, and what is forgotten there is still here.
TEST(SharedMemory, IsSeenByCopiesWithoutADescriptor) {
  SharedMemory<Pair> shared(for_copies), other(for_copies);
  EXPECT_EQ(shared->first, 3);
  const pid_t child = fork();
  if (child == 0) {
    shared->first = 5;
    shared.forget();
    _exit(0);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  EXPECT_EQ(shared->first, 5);
  EXPECT_EQ(other->first, 3);
}

TEST(SharedMemory, IsMoved) {
  SharedMemory<Pair> shared;
  shared->first = 9;
  const int number = shared.descriptor();
  SharedMemory<Pair> there(std::move(shared));
  EXPECT_EQ(there->first, 9);
  EXPECT_EQ(there.descriptor(), number);
  there.move_descriptor_up(200);
  EXPECT_GE(there.descriptor(), 200);
  EXPECT_EQ(SharedMemory<Pair>(FileDescriptor(dup(there.descriptor())))->first, 9);
}

TEST(SharedMemory, WritesToNothingButMemory) {
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  ASSERT_EQ(ftruncate(fileno(file), 4096), 0);
  EXPECT_THROW(SharedMemory<Pair>(FileDescriptor(dup(fileno(file)))), std::system_error);
  EXPECT_THROW(SharedMemory<Pair>(FileDescriptor(-1)), std::system_error);
  std::fclose(file);
}

TEST(SharedMemory, ThatIsTooShortIsRefused) {
  EXPECT_THROW(SharedMemory<Pair>(shared_file(sizeof(Pair) - 1)), std::system_error);
}

}  // namespace
}  // namespace regista::process
