// SPDX-License-Identifier: MIT
#include "campaign/run_program.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <system_error>

namespace regista::campaign {
namespace {

using namespace std::chrono_literals;

ProgramEnd shell(const std::string& line) { return run_program({.words = {"sh", "-c", line}}); }

TEST(RunProgram, WhatItSaysAndHowItEnds) {
  const ProgramEnd end = shell("echo said; echo complained >&2; exit 3");
  EXPECT_TRUE(end.found && end.in_time);
  EXPECT_EQ(end.output, "said\n");
  EXPECT_EQ(end.errors, "complained\n");
  EXPECT_EQ(WEXITSTATUS(end.status), 3);
  EXPECT_FALSE(end.succeeded());
  EXPECT_TRUE(shell("true").succeeded());
  EXPECT_EQ(WTERMSIG(shell("kill -TERM $$").status), SIGTERM);
}

TEST(RunProgram, WordsAreNoShellLines) {
  EXPECT_EQ(run_program({.words = {"printf", "%s|", "a b", "$HOME", "*", ""}}).output, "a b|$HOME|*||");
}

TEST(RunProgram, NothingIsToBeRead) { EXPECT_EQ(shell("cat; echo end").output, "end\n"); }

TEST(RunProgram, OneThatIsNotThere) {
  const ProgramEnd end = run_program({.words = {"no-such-program-anywhere"}});
  EXPECT_FALSE(end.found);
  EXPECT_FALSE(end.succeeded());
}

TEST(RunProgram, OneThatEndsLikeAShellWithoutAProgramIsThere) {
  const ProgramEnd end = shell("no-such-program-anywhere");
  EXPECT_TRUE(end.found);
  EXPECT_EQ(WEXITSTATUS(end.status), 127);
  EXPECT_THAT(end.errors, testing::HasSubstr("no-such-program-anywhere"));
}

TEST(RunProgram, OneThatCannotBeStarted) {
  EXPECT_THROW(run_program({.words = {"true"}, .folder = "/no/such/folder"}), std::system_error);
  EXPECT_THROW(run_program({.words = {std::filesystem::temp_directory_path().string()}}), std::system_error);
}

// More than a pipe holds, in both at once.
TEST(RunProgram, MuchInBothTexts) {
  const ProgramEnd end = shell("i=0; while [ $i -lt 20000 ]; do echo 12345678; echo 1234567 >&2; i=$((i + 1)); done");
  EXPECT_EQ(end.output.size(), 180'000u);
  EXPECT_EQ(end.errors.size(), 160'000u);
}

TEST(RunProgram, OnlyTheBeginningOfALongText) {
  const ProgramEnd end = run_program({.words = {"sh", "-c", "printf 123456; printf abcdef >&2"}, .longest_text = 4});
  EXPECT_EQ(end.output, "1234");
  EXPECT_EQ(end.errors, "abcd");
  EXPECT_TRUE(end.succeeded());
}

TEST(RunProgram, OneThatTakesTooLongIsKilled) {
  // With what it has started, which would keep its texts open.
  const ProgramEnd end = run_program({.words = {"sh", "-c", "echo begun; sleep 600 & sleep 600"}, .patience = 2s});
  EXPECT_FALSE(end.in_time);
  EXPECT_EQ(end.output, "begun\n");
  EXPECT_EQ(WTERMSIG(end.status), SIGKILL);
}

TEST(RunProgram, FolderAndEnvironmentOfItsOwn) {
  const std::filesystem::path folder = std::filesystem::canonical(std::filesystem::temp_directory_path());
  const ProgramEnd end =
      run_program({.words = {"/bin/sh", "-c", "/bin/pwd; /usr/bin/env"}, .folder = folder, .environment = {{"A=b c"}}});
  EXPECT_THAT(end.output, testing::StartsWith(folder.string() + "\n"));
  EXPECT_THAT(end.output, testing::HasSubstr("\nA=b c\n"));
  EXPECT_THAT(end.output, testing::Not(testing::HasSubstr("HOME=")));
}

}  // namespace
}  // namespace regista::campaign
