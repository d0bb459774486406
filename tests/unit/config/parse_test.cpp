// SPDX-License-Identifier: MIT
#include "config/parse.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "testing.hpp"

namespace regista::config {
namespace {

using namespace std::string_literals;

std::string repeated(std::string_view text, std::size_t times) {
  std::string result;
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::string message(std::string_view text) {
  return error_of([&] { parse_text(text, "t.yaml"); });
}

TEST(Parse, RemembersWhereValuesStand) {
  const Node document = parse_text("a: 1\nb:\n  - x\n  - {c: \"d\"}\n", "t.yaml");
  EXPECT_EQ(to_string(document.where()), "t.yaml:1:1");
  EXPECT_EQ(to_string(document["a"].where()), "t.yaml:1:4");
  EXPECT_EQ(to_string(document["b"].where()), "t.yaml:3:3");
  ASSERT_EQ(document["b"].elements().size(), 2u);
  const Node inner = document["b"].elements()[1];
  EXPECT_EQ(to_string(inner.where()), "t.yaml:4:5");
  EXPECT_EQ(to_string(inner.entries()[0].key_where), "t.yaml:4:6");
  EXPECT_EQ(inner["c"].text(), "d");
  EXPECT_TRUE(inner["c"].quoted());
  EXPECT_FALSE(document["a"].quoted());
  EXPECT_FALSE(document["z"]);
  EXPECT_FALSE(document["z"]["y"]);
}

TEST(Parse, CarriageReturnsDoNotMovePlaces) {
  const Node document = parse_text("a: 1\r\nb: {c: \"x\"}\r\n", "t.yaml");
  EXPECT_EQ(to_string(document["b"]["c"].where()), "t.yaml:2:8");
  EXPECT_EQ(document["b"]["c"].text(), "x");
}

TEST(Parse, AliasesStandForTheirValue) {
  const Node document = parse_text("a: &x {b: [1, 2]}\nc: *x\nd: &n ~\ne: *n\n", "t.yaml");
  EXPECT_TRUE(same(document["a"], document["c"]));
  EXPECT_EQ(to_string(document["c"].where()), "t.yaml:1:4") << "where the anchor stands";
  EXPECT_EQ(document["e"].kind(), Node::Kind::null);
}

TEST(Parse, SameIgnoresOrderAndPlace) {
  const Node a = parse_text("{a: 1, b: [x, {c: ~}]}", "a.yaml");
  EXPECT_TRUE(same(a, parse_text("b:\n- 'x'\n- c:\na: 1\n", "b.yaml")));
  for (const char* other : {"{a: 2, b: [x, {c: ~}]}", "{a: 1}", "{a: 1, b: [x]}", "{a: 1, b: [x, {d: ~}]}",
                            "{a: 1, b: [x, {c: 1}]}", "{a: 1, b: [x, {c: ~}], d: 1}"}) {
    EXPECT_FALSE(same(a, parse_text(other, "b.yaml"))) << other;
  }
}

TEST(Parse, WhatIsRefused) {
  const std::pair<std::string, std::string_view> cases[] = {
      // Encoding
      {"a:\n\tb: 1\n", "t.yaml:2:1: tab in the indentation; use spaces"},
      {"a: |\n x\n\ty\n", "t.yaml:3:1: tab in the indentation; use spaces"},
      {"\xef\xbb\xbf"
       "a: 1\n",
       "t.yaml:1:1: begins with a byte order mark; save it as UTF-8 without one"},
      {"\xff\xfe"
       "a\0:\0"s,
       "t.yaml:1:1: is UTF-16 text; save it as UTF-8"},
      {"\xfe\xff\0a"s, "t.yaml:1:1: is UTF-16 text; save it as UTF-8"},
      {"a: 1\0b\n"s, "t.yaml:1:5: byte 0x00 is not text; is this a binary file?"},
      {"a: 1\nb: \x04\nc: 2\n", "t.yaml:2:4: byte 0x04 is not text; is this a binary file?"},
      {"\x7f"
       "ELF\x02",
       "t.yaml:1:1: byte 0x7f is not text; is this a binary file?"},
      {"\x89PNG\r\n\x1a\n", "t.yaml:1:1: byte 0x89 is not UTF-8"},
      {"a: \xff\n", "t.yaml:1:4: byte 0xff is not UTF-8"},
      {"a: caf\xe9\n", "t.yaml:1:7: byte 0xe9 is not UTF-8"},
      {"a: \xc0\xaf\n", "t.yaml:1:4: byte 0xc0 is not UTF-8"},
      {"a: \xed\xa0\x80\n", "t.yaml:1:4: byte 0xed is not UTF-8"},
      {"a: \xf4\x90\x80\x80\n", "t.yaml:1:4: byte 0xf4 is not UTF-8"},
      {"a: \xe2\x82", "t.yaml:1:4: byte 0xe2 is not UTF-8"},
      {"a\rb: 1\n", "t.yaml:1:2: carriage return inside a line"},
      {"a: " + std::string(70000, 'x'), "t.yaml:1:65537: line is longer than 65536 bytes"},
      // Not one map
      {"", "t.yaml: is empty"},
      {"# only a comment\n", "t.yaml: is empty"},
      {"~\n", "t.yaml:1:1: is empty"},
      {"hello world\n", "t.yaml:1:1: expected a map at the top, not text"},
      {"- a\n- b\n", "t.yaml:1:1: expected a map at the top, not a list"},
      {"a: 1\n---\nb: 2\n", "t.yaml:2:1: second document; a file holds one"},
      {"\"a\" \"b\"\n", "t.yaml:1:5: text after the end of the document"},
      {"- a\nb: c\n", "t.yaml:2:1: text after the end of the document"},
      // Keys
      {"a: 1\na: 2\n", "t.yaml:2:1: duplicate key \"a\"; first in line 1"},
      {"x:\n  b: 1\n  c: 2\n  \"b\": 3\n", "t.yaml:4:3: duplicate key \"b\"; first in line 2"},
      {"a: &x {b: 1}\n<<: *x\n",
       "t.yaml:2:1: merge key \"<<\" is not supported; use `extends: FILE` for variants of a file"},
      {"? [a]\n: 1\n", "t.yaml:1:3: a key must be plain text; is a bracket not closed?"},
      {"? {a: 1}\n: 1\n", "t.yaml:1:3: a key must be plain text; is a bracket not closed?"},
      {": 1\n", "t.yaml:1:1: a key is missing before the ':'"},
      {"~: 1\n", "t.yaml:1:1: a key is missing before the ':'"},
      {"a: &k b\n*k : 1\n", "t.yaml:2:1: an alias cannot be a key"},
      {"&k a: 1\n", "t.yaml:1:1: a key cannot have an anchor"},
      // Anchors and tags
      {"a: &x [*x]\n", "t.yaml:1:8: alias of a value that contains it"},
      {"a: &x {b: [1, {c: *x}]}\n", "t.yaml:1:19: alias of a value that contains it"},
      {"a: *q\n", "t.yaml:1:4: alias without an anchor before it"},
      {"a: &x &y 1\n", "t.yaml:1:7: two anchors on one value"},
      {"a: !foo 3\n", "t.yaml:1:4: tag \"!foo\"; tags are not supported"},
      {"a: !!python/object:os.system x\n",
       "t.yaml:1:4: tag \"tag:yaml.org,2002:python/object:os.syste...\"; tags are not supported"},
      {"a: !!map {b: 1}\n", "t.yaml:1:4: tag \"tag:yaml.org,2002:map\"; tags are not supported"},
      // Syntax
      {"a: [1, 2\nb: 3\n", "t.yaml:1:4: the list that begins here is not closed: expected ',' or ']' before line 2"},
      {"a: {b: 1\nc: 2\n", "t.yaml:1:4: the map that begins here is not closed: expected ',' or '}' before line 2"},
      {"a: {b: 1, c: 2\n", "t.yaml:1:4: the map that begins here is not closed: expected ',' or '}' before line 2"},
      {"a:\n  - {b: {c: 1}\n  - {b: 2}\n",
       "t.yaml:3:3: '- ' where no list can begin; is a bracket not closed in the line above?"},
      {"a: {b: 1 c: 2}\n", "t.yaml:1:11: ',' or '}' expected to continue or end the map"},
      {"a:\n  b:10\n\n  c: 2\n",
       "t.yaml:4:4: ':' where no value can begin; is a space missing after ':' in the line above?"},
      {"a:\n  b:10\n  # ten\n  c: 2\n",
       "t.yaml:4:3: this does not continue the map above; is a space missing after ':' in the line above?"},
      {"a: b: c\n", "t.yaml:1:5: ':' where no value can begin; check the indentation, or quote the text"},
      {"a: 1\n b: 2\n", "t.yaml:2:3: ':' where no value can begin; check the indentation, or quote the text"},
      {"a:\n  b: 1\n c: 2\n", "t.yaml:3:2: this does not continue the map above; check the indentation"},
      {"a: 1\n- b\n", "t.yaml:2:1: this does not continue the map above; check the indentation"},
      {"a: }\n", "t.yaml:1:4: closing bracket without an opening one"},
      {"{a: 1}}\n", "t.yaml:1:7: closing bracket without an opening one"},
      {"a: @x\n", "t.yaml:1:4: this character cannot begin a value; quote the text"},
      {"a: 'x\nb: 1\n", "t.yaml:1:4: quote ' is never closed"},
      {"a: \"x\nb: 1\n", "t.yaml:1:4: quote \" is never closed"},
      {"a: \"x\\\"\nb: 1\n", "t.yaml:1:4: quote \" is never closed"},
      {"a: 'it''s\n", "t.yaml:1:4: quote ' is never closed"},
      {"a: \"\\q\"\n", "t.yaml:1:7: not YAML: unknown escape character: q"},
      {"%YAML 3.0\n---\na: 1\n", "t.yaml:1:1: not YAML: YAML major version too large"},
      // Size
      {"a: " + repeated("[", 10000), "t.yaml:1:5: a key must be plain text; is a bracket not closed?"},
      {"a: " + repeated("[", 10000) + repeated("]", 10000), "t.yaml:1:67: nested deeper than 64 levels"},
      {repeated("- ", 10000) + "1", "t.yaml:1:129: nested deeper than 64 levels"},
      {"a: [" + repeated("1,\n ", 60000) + "1]",
       "t.yaml:49999:2: more than 50000 values (aliases count as what they stand for)"},
  };
  for (const auto& [text, expected] : cases) {
    std::string said;
    EXPECT_LT(seconds_of([&, given = &text] { said = message(*given); }), 1.0) << expected;
    EXPECT_EQ(said, expected);
  }
}

TEST(Parse, WhatLooksOddButIsFine) {
  for (const char* text :
       {"a: 'it''s'\n", "a: \"x \\\" y\"\n", "--- # comment\na: 1\n...\n", "a: \"b\n  c\"\n", "\"<<\": 1\n",
        "a: &x 1\nb: &x 2\nc: *x\n", "a: |\n  'not a quote\n", "a: >\n  \"x\n", "{a: 1}", "a: x\ty\n", "é: ü\n"}) {
    EXPECT_EQ(message(text), "") << text;
  }
}

TEST(Parse, DepthAtTheLimit) {
  const auto nested = [](std::size_t depth) { return "a: " + repeated("[", depth) + repeated("]", depth); };
  EXPECT_EQ(message(nested(63)), "") << "with the map at the top, 64";
  EXPECT_EQ(message(nested(64)), "t.yaml:1:67: nested deeper than 64 levels");
  // Through aliases, each one level deeper than the last.
  std::string text = "a0: &a0 [1]\n";
  for (int i = 1; i < 70; ++i) text += fmt::format("a{}: &a{} [*a{}]\n", i, i, i - 1);
  EXPECT_EQ(message(text), "t.yaml:64:12: nested deeper than 64 levels");
}

TEST(Parse, BillionLaughs) {
  std::string text = "a0: &a0 [lol, lol, lol, lol, lol, lol, lol, lol, lol, lol]\n";
  for (int i = 1; i < 10; ++i) {
    text += fmt::format("a{}: &a{} [{}*a{}]\n", i, i, repeated(fmt::format("*a{}, ", i - 1), 9), i - 1);
  }
  std::string said;
  EXPECT_LT(seconds_of([&] { said = message(text); }), 1.0);
  EXPECT_EQ(said, "t.yaml:5:25: more than 50000 values (aliases count as what they stand for)");
}

// Texts of the largest size that are meant to be slow. What grows with the square of a text takes minutes; sanitizers
// and busy machines cost a few seconds.
TEST(Parse, LargeTextsTakeNoLong) {
  constexpr double no_long = 10.0;  // s of processor time
  const std::string cases[] = {
      repeated("[", largest_file),
      repeated("[\n", largest_file / 2),
      repeated("{\n", largest_file / 2),
      repeated(repeated("[", 60000) + "\n", largest_file / 60001),
      repeated("? ", largest_file / 2),
      repeated("a: b\n", largest_file / 5),
      repeated("\n", largest_file),
      repeated("#\n", largest_file / 2),
      "a: \"" + repeated("\\n\n", largest_file / 3 - 2) + "\"",
      repeated("'\n", largest_file / 2),
      repeated("- &a *a\n", largest_file / 8),
      "[" + repeated("'',\n", largest_file / 4 - 1),
      "a: |\n" + repeated(" \n", largest_file / 2 - 3),
      repeated("!a\n", largest_file / 3),
  };
  for (const std::string& text : cases) {
    ASSERT_LE(text.size(), largest_file);
    EXPECT_LT(seconds_of([&] { message(text); }), no_long) << text.substr(0, 20);
  }
}

using ParseFile = InFolder;

TEST_F(ParseFile, FilesThatAreNone) {
  EXPECT_EQ(error_of([] { parse("nothing.yaml"); }), "nothing.yaml: no such file");
  write("spl2023.yaml", "a: 1\n");
  EXPECT_EQ(error_of([] { parse("spl2032.yaml"); }), "spl2032.yaml: no such file; nearest: \"spl2023.yaml\"");
  std::filesystem::create_directory("folder.yaml");
  EXPECT_EQ(error_of([] { parse("folder.yaml"); }), "folder.yaml: is a folder; expected a YAML file");
  ASSERT_EQ(mkfifo("pipe.yaml", 0600), 0);
  EXPECT_EQ(error_of([] { parse("pipe.yaml"); }), "pipe.yaml: is not a regular file");
  EXPECT_EQ(error_of([] { parse("/dev/zero"); }), "/dev/zero: is not a regular file");
  EXPECT_EQ(error_of([] { parse("spl2023.yaml/x.yaml"); }),
            "spl2023.yaml/x.yaml: no such file; there is no folder spl2023.yaml");
  EXPECT_EQ(error_of([] { parse("two\nlines.yaml"); }), "two\\nlines.yaml: no such file");
}

TEST_F(ParseFile, TooLarge) {
  write("large.yaml", "a: 1\n");
  std::filesystem::resize_file("large.yaml", 100u << 20);
  std::string said;
  EXPECT_LT(seconds_of([&] { said = error_of([] { parse("large.yaml"); }); }), 1.0);
  EXPECT_EQ(said, "large.yaml: is 104857600 bytes large; at most 1048576 are read");
}

}  // namespace
}  // namespace regista::config
