// SPDX-License-Identifier: MIT
#include "command/options_declared.hpp"

#include <gtest/gtest.h>

namespace regista::command {
namespace {

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

}  // namespace
}  // namespace regista::command
