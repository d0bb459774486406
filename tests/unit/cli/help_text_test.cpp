// SPDX-License-Identifier: MIT
#include "cli/help_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/command_line.hpp"
#include "cli/commands.hpp"
#include "config/bad_input.hpp"

namespace regista::cli {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

CommandDeclaration example() {
  CommandDeclaration out{"sort", "tidy sort", "put things in order", {}, {}, {}};
  out.options.push_back({{"things"}, "THING", "what is to be sorted", {}, {}, true});
  out.options.push_back({{"-r", "--reverse"}, "", "the last one first", {}, {}});
  out.options.push_back({{"--by"}, "CHOICE", "what decides", {"size", "age"}, {}});
  out.notes =
      "Examples:\n  tidy sort a b c   # an example that is wider than the page\n\none two three four five six seven";
  return out;
}

TEST(HelpText, SaysHowACommandIsCalledAndWhatItTakes) {
  EXPECT_EQ(help_text(example(), 40), R"(tidy sort: put things in order

Usage: tidy sort THING... [OPTIONS]

Arguments:
  THING...  what is to be sorted

Options:
  -r, --reverse  the last one first
  --by size|age  what decides
  -h, --help     print this help

Examples:
  tidy sort a b c   # an example that is wider than the page

one two three four five six seven
)");
}

TEST(HelpText, ParagraphsAreFilledAndExamplesAreNot) {
  EXPECT_EQ(filled("a bb ccc\ndd e\n\nlist:\n  as  it  is\nend", 8), "a bb ccc\ndd e\n\nlist:\n  as  it  is\nend\n");
  EXPECT_EQ(filled("a\nb\nc", 80), "a b c\n");
  EXPECT_EQ(filled("averyverylongword and more", 8), "averyverylongword\nand more\n");
  EXPECT_EQ(filled("", 80), "");
}

// Of each command that the program has: no line is too wide but an example or a single word.
void expect_narrow(const CommandDeclaration& command, std::size_t width) {
  std::istringstream lines(help_text(command, width));
  for (std::string line; std::getline(lines, line);) {
    const bool example = line.starts_with(' ') && command.notes.find(line) != std::string::npos;
    const bool one_word = line.find(' ', std::min(line.find_first_not_of(' '), line.size())) == std::string::npos;
    EXPECT_TRUE(line.size() <= width || example || one_word) << command.full_name << " at " << width << ": " << line;
  }
  for (const CommandDeclaration& each : command.commands) expect_narrow(each, width);
}

TEST(HelpText, FitsTheWidth) {
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
