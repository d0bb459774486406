// SPDX-License-Identifier: MIT
// The shell is the judge of what a shell reads.
#include "campaign/shell.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

namespace regista::campaign {
namespace {

// What `printf '%s\n'` of the shell makes of the words of a line.
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
}  // namespace regista::campaign
