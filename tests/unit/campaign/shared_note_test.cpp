// SPDX-License-Identifier: MIT
#include "campaign/shared_note.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <system_error>

namespace regista::campaign {
namespace {

TEST(SharedNote, OutlivesTheProcessThatWroteIt) {
  SharedNote note;
  const pid_t child = fork();
  if (child == 0) {
    SharedNote inherited(dup(note.descriptor()));
    inherited.note().call.plugin = plugin::note_of_id("greedy");
    inherited.note().call.tick = 417;
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_STREQ(note.note().call.plugin.data(), "greedy");
  EXPECT_EQ(note.note().call.tick, 417u);
  note.clear();
  EXPECT_STREQ(note.note().call.plugin.data(), "");
}

TEST(SharedNote, WritesToNothingButMemory) {
  std::FILE* const file = std::tmpfile();
  ASSERT_NE(file, nullptr);
  ASSERT_EQ(ftruncate(fileno(file), 4096), 0);
  EXPECT_THROW(SharedNote(dup(fileno(file))), std::system_error);
  EXPECT_THROW(SharedNote(-1), std::system_error);
  std::fclose(file);
}

TEST(SharedNote, LongIdsAreCutOff) {
  const auto noted = plugin::note_of_id(std::string(100, 'x'));
  EXPECT_EQ(std::string(noted.data()), std::string(63, 'x'));
}

}  // namespace
}  // namespace regista::campaign
