// SPDX-License-Identifier: MIT
#include "plugin/info.hpp"

#include <gtest/gtest.h>

namespace regista::plugin::test {
namespace {

TEST(MarkdownText, ShowsTextsAsTheyAre) {
  EXPECT_EQ(as_text("Far, in m; below `x_least`: y < 0 (0, 1]"), R"(Far, in m; below `x_least`: y < 0 (0, 1\])");
  EXPECT_EQ(as_text("a|b <script> [x](http://y) *z*"), R"(a\|b \<script> \[x\](http://y) \*z\*)");
  EXPECT_EQ(as_text("![picture](x)"), R"(!\[picture\](x))");
  EXPECT_EQ(as_text(R"(\| is no escape)"), R"(\\\| is no escape)");
}

TEST(MarkdownText, LeavesCodeThatEnds) {
  EXPECT_EQ(as_text("`a[1] < b*c`"), "`a[1] < b*c`");
  EXPECT_EQ(as_text("`a|b`"), R"(`a\|b`)");
  EXPECT_EQ(as_text("open ` here [x]"), R"(open \` here \[x\])");
  EXPECT_EQ(as_text("``a` [x]"), R"(\`\`a\` \[x\])");
}

TEST(MarkdownText, BeginsNoHeadingAndNoList) {
  EXPECT_EQ(as_paragraph("# Title"), R"(\# Title)");
  EXPECT_EQ(as_paragraph("- a"), R"(\- a)");
  EXPECT_EQ(as_paragraph("A - b"), "A - b");
  EXPECT_EQ(as_paragraph(""), "");
}

TEST(MarkdownText, CodeEndsWhereItShould) {
  EXPECT_EQ(as_code("0.5"), "`0.5`");
  EXPECT_EQ(as_code("a|b"), R"(`a\|b`)");
  EXPECT_EQ(as_code("a`b``c"), "``` a`b``c ```");
}

}  // namespace
}  // namespace regista::plugin::test
