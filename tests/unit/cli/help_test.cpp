// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "command/options_declared.hpp"
#include "config/errors.hpp"

namespace regista::cli {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// Of each command that the program has: no line is too wide but an example or a single word.
void expect_narrow(const command::CommandDeclaration& command, std::size_t width) {
  std::istringstream lines(command::help_text(command, width));
  for (std::string line; std::getline(lines, line);) {
    const bool example = line.starts_with(' ') && command.notes.find(line) != std::string::npos;
    const bool one_word = line.find(' ', std::min(line.find_first_not_of(' '), line.size())) == std::string::npos;
    EXPECT_TRUE(line.size() <= width || example || one_word) << command.full_name << " at " << width << ": " << line;
  }
  for (const command::CommandDeclaration& each : command.commands) expect_narrow(each, width);
}

TEST(Help, FitsTheWidth) {
  const Invocation invocation;
  Command program("regista", "about");
  add_commands(program, invocation);
  for (const std::size_t width : {60U, 80U, 100U, 120U}) expect_narrow(program.declaration(), width);
}

TEST(Help, IsAskedForByNameOrByOption) {
  const Invocation invocation;
  const auto answer = [&](const std::vector<std::string>& words) {
    Command program("regista", "about");
    add_commands(program, invocation);
    return program.read(words, 80).answer;
  };
  EXPECT_EQ(answer({"help", "plugin", "info"}), answer({"plugin", "info", "--help"}));
  EXPECT_EQ(answer({"help"}), answer({"--help"}));
  EXPECT_THAT(answer({"help", "plugin", "info"}), StartsWith("regista plugin info: "));
  // The examples are those of the command.
  EXPECT_THAT(answer({"match", "--help"}), HasSubstr("  regista match configs/"));
  EXPECT_THAT(answer({"match", "--help"}), Not(HasSubstr("  regista tune")));
  EXPECT_THROW(answer({"help", "mach"}), config::BadInput);
  EXPECT_THROW(answer({"help", "match", "more"}), config::BadInput);
}

}  // namespace
}  // namespace regista::cli
