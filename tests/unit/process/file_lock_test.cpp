// SPDX-License-Identifier: MIT

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "process/file_descriptor.hpp"

namespace regista::process {
namespace {

class FileLockTest : public testing::Test {
 protected:
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "file";
  FileDescriptor opened() const { return FileDescriptor(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)); }
};

constexpr auto held = std::errc::operation_would_block;

TEST_F(FileLockTest, OneWritesOrManyRead) {
  FileDescriptor first = opened(), second = opened(), third = opened();
  EXPECT_FALSE(lock_file(first.number, FileLock::exclusive));
  EXPECT_EQ(lock_file(second.number, FileLock::exclusive), held);
  EXPECT_EQ(lock_file(second.number, FileLock::shared), held);
  first.reset();
  EXPECT_FALSE(lock_file(second.number, FileLock::shared));
  EXPECT_FALSE(lock_file(third.number, FileLock::shared));
  EXPECT_EQ(lock_file(third.number, FileLock::exclusive), held);
}

// It is of the open file, not of the process: closing another descriptor of the same file does not end it, and a child
// has it, too.
TEST_F(FileLockTest, LastsAsLongAsTheOpenFile) {
  FileDescriptor first = opened(), second = opened();
  ASSERT_FALSE(lock_file(first.number, FileLock::exclusive));
  opened().reset();
  EXPECT_EQ(lock_file(second.number, FileLock::exclusive), held);
  const pid_t child = fork();
  ASSERT_NE(child, -1);
  if (child == 0) {
    pause();
    _exit(0);
  }
  first.reset();
  EXPECT_EQ(lock_file(second.number, FileLock::exclusive), held);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_FALSE(lock_file(second.number, FileLock::exclusive));
}

TEST_F(FileLockTest, IsGivenUpForCopiesToo) {
  const FileDescriptor first = opened(), copy(::dup(first.number)), second = opened();
  ASSERT_FALSE(lock_file(first.number, FileLock::exclusive));
  unlock_file(first.number);
  EXPECT_FALSE(lock_file(second.number, FileLock::exclusive));
  EXPECT_EQ(lock_file(copy.number, FileLock::exclusive), held);
}

TEST_F(FileLockTest, SaysWhatElseIsWrong) {
  EXPECT_EQ(lock_file(-1, FileLock::exclusive), std::errc::bad_file_descriptor);
  FileDescriptor read_only(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  EXPECT_TRUE(lock_file(read_only.number, FileLock::exclusive));
}

}  // namespace
}  // namespace regista::process
