// SPDX-License-Identifier: MIT
#include "process/child.hpp"

#include <gmock/gmock.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace regista::process {
namespace {

using namespace std::chrono_literals;

ProgramEnd shell(const std::string& line) { return run_program({.words = {"sh", "-c", line}}); }

TEST(RunProgram, WhatItSaysAndHowItEnds) {
  const ProgramEnd end = shell("echo said; echo complained >&2; exit 3");
  EXPECT_TRUE(end.found && end.in_time);
  EXPECT_EQ(end.output, "said\n");
  EXPECT_EQ(end.errors, "complained\n");
  EXPECT_TRUE(end.end.exited_with(3));
  EXPECT_FALSE(end.succeeded());
  EXPECT_TRUE(shell("true").succeeded());
  EXPECT_EQ(shell("kill -TERM $$").end.signal_number(), SIGTERM);
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
  EXPECT_TRUE(end.end.exited_with(127));
  EXPECT_THAT(end.errors, testing::HasSubstr("no-such-program-anywhere"));
}

TEST(RunProgram, OneThatCannotBeStarted) {
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
  EXPECT_EQ(end.end.signal_number(), SIGKILL);
}

// The shell is the judge of what a shell reads: what `printf '%s\n'` of the shell makes of the words of a line.
std::string read_by_shell(const std::string& line) {
  std::FILE* const shell = popen(("printf '%s\\n' " + line).c_str(), "r");
  std::string out;
  std::array<char, 256> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), shell)) out.append(buffer.data(), count);
  EXPECT_EQ(pclose(shell), 0);
  return out;
}

TEST(ShellLine, IsReadBackAsTheSameWords) {
  const std::vector<std::string> words{"plain", "with space", "it's", "",    "$HOME", "`id`", "a;b",  "*",
                                       "\\",    "\"quoted\"", "''",   "a=b", "~",     "#",    "{a,b}"};
  std::string expected;
  for (const std::string& word : words) expected += word + '\n';
  EXPECT_EQ(read_by_shell(shell_line(words)), expected);
}

TEST(ShellLine, LeavesPlainWordsAlone) {
  const std::vector<std::string> words{"regista", "match", "configs/teams/paper.yaml", "--set", "rules.team_size=5"};
  EXPECT_EQ(shell_line(words), "regista match configs/teams/paper.yaml --set rules.team_size=5");
}

}  // namespace
}  // namespace regista::process
