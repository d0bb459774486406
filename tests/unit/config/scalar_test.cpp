// SPDX-License-Identifier: MIT
#include "config/scalar.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

const Location here{"t.yaml", 1, 1};

// A value as a document would hold it.
Node value(std::string_view text) { return parse_value(text, here); }

template <class Read>
std::string message(Read read, std::string_view text) {
  return error_of([&] { read(value(text), "a"); });
}

TEST(Scalar, Reals) {
  EXPECT_EQ(to_real(value("1"), "a"), 1.0);
  EXPECT_EQ(to_real(value("-1.5"), "a"), -1.5);
  EXPECT_EQ(to_real(value("+.5"), "a"), 0.5);
  EXPECT_EQ(to_real(value("5."), "a"), 5.0);
  EXPECT_EQ(to_real(value("1e3"), "a"), 1000.0);
  EXPECT_EQ(to_real(value("1.25E-2"), "a"), 0.0125);
  EXPECT_EQ(to_real(value("0"), "a"), 0.0);
  EXPECT_EQ(to_real(value("0.5"), "a"), 0.5);
  EXPECT_TRUE(std::signbit(to_real(value("-0"), "a")));
}

TEST(Scalar, RealsThatAreNone) {
  const std::pair<std::string_view, std::string_view> cases[] = {
      {".nan", "t.yaml:1:1: a: \".nan\" is not finite"},
      {"-.inf", "t.yaml:1:1: a: \"-.inf\" is not finite"},
      {"inf", "t.yaml:1:1: a: \"inf\" is not finite"},
      {"1e400", "t.yaml:1:1: a: \"1e400\" is beyond what a number can hold"},
      {"0x10", "t.yaml:1:1: a: \"0x10\" is not decimal; write it in base ten"},
      {"0o17", "t.yaml:1:1: a: \"0o17\" is not decimal; write it in base ten"},
      {"010", "t.yaml:1:1: a: \"010\" begins with zero, which some read as octal; leave the zero out"},
      {"-00.5", "t.yaml:1:1: a: \"-00.5\" begins with zero, which some read as octal; leave the zero out"},
      {"abc", "t.yaml:1:1: a: \"abc\" is not a number"},
      {"1 m", "t.yaml:1:1: a: \"1 m\" is not a number"},
      {"1,5", "t.yaml:1:1: a: \"1,5\" is not a number"},
      {"1_000", "t.yaml:1:1: a: \"1_000\" is not a number"},
      {"1:30", "t.yaml:1:1: a: \"1:30\" is not a number"},
      {"1e", "t.yaml:1:1: a: \"1e\" is not a number"},
      {".", "t.yaml:1:1: a: \".\" is not a number"},
      {"+", "t.yaml:1:1: a: \"+\" is not a number"},
      {"--1", "t.yaml:1:1: a: \"--1\" is not a number"},
      {"true", "t.yaml:1:1: a: \"true\" is not a number"},
      {"\"1\"", "t.yaml:1:1: a: \"1\" is text, being quoted; expected a number"},
      {"~", "t.yaml:1:1: a: nothing; expected a number"},
      {"", "t.yaml:1:1: a: nothing; expected a number"},
      {"[1]", "t.yaml:1:1: a: a list; expected a number"},
      {"{a: 1}", "t.yaml:1:1: a: a map; expected a number"},
      {"\"line\\nbreak\"", "t.yaml:1:1: a: \"line\\nbreak\" is text, being quoted; expected a number"},
      {"0123456789012345678901234567890123456789é0123456789",
       "t.yaml:1:1: a: \"0123456789012345678901234567890123456789...\" begins with zero, which some read as octal; "
       "leave "
       "the zero out"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(message(to_real, text), expected);
}

TEST(Scalar, Integers) {
  EXPECT_EQ(to_integer(value("0"), "a"), 0);
  EXPECT_EQ(to_integer(value("+12"), "a"), 12);
  EXPECT_EQ(to_integer(value("-9223372036854775808"), "a"), std::numeric_limits<std::int64_t>::min());
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"010", "t.yaml:1:1: a: \"010\" begins with zero, which some read as octal; leave the zero out"},
      {"0x10", "t.yaml:1:1: a: \"0x10\" is not decimal; write it in base ten"},
      {"4.0", "t.yaml:1:1: a: \"4.0\" is not an integer"},
      {"1e3", "t.yaml:1:1: a: \"1e3\" is not an integer"},
      {"+", "t.yaml:1:1: a: \"+\" is not an integer"},
      {"+-1", "t.yaml:1:1: a: \"+-1\" is not an integer"},
      {".inf", "t.yaml:1:1: a: \".inf\" is not finite"},
      {"9223372036854775808", "t.yaml:1:1: a: \"9223372036854775808\" is beyond what an integer can hold"},
      {"[]", "t.yaml:1:1: a: a list; expected an integer"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(message(to_integer, text), expected);
}

TEST(Scalar, Booleans) {
  for (const char* text : {"true", "True", "TRUE"}) EXPECT_TRUE(to_boolean(value(text), "a"));
  for (const char* text : {"false", "False", "FALSE"}) EXPECT_FALSE(to_boolean(value(text), "a"));
  const std::pair<std::string_view, std::string_view> cases[] = {
      {"yes", "t.yaml:1:1: a: \"yes\" is neither true nor false; write true"},
      {"no", "t.yaml:1:1: a: \"no\" is neither true nor false; write false"},
      {"on", "t.yaml:1:1: a: \"on\" is neither true nor false; write true"},
      {"OFF", "t.yaml:1:1: a: \"OFF\" is neither true nor false; write false"},
      {"1", "t.yaml:1:1: a: \"1\" is neither true nor false; write true"},
      {"tRue", "t.yaml:1:1: a: \"tRue\" is neither true nor false; write true"},
      {"\"true\"", "t.yaml:1:1: a: \"true\" is neither true nor false; write true"},
      {"maybe", "t.yaml:1:1: a: \"maybe\" is neither true nor false"},
      {"~", "t.yaml:1:1: a: nothing; expected true or false"},
  };
  for (const auto& [text, expected] : cases) EXPECT_EQ(message(to_boolean, text), expected);
}

TEST(Scalar, Names) {
  EXPECT_EQ(to_name(value("defender_left"), "a"), "defender_left");
  EXPECT_EQ(to_name(value("\"true\""), "a"), "true");
  EXPECT_EQ(to_name(value("no"), "a"), "no") << "text in YAML 1.2";
  const std::string rule = " is not a name (a letter, then letters, digits, '_' and '-')";
  EXPECT_EQ(message(to_name, "true"), "t.yaml:1:1: a: \"true\" is a boolean; expected a name");
  EXPECT_EQ(message(to_name, "2023"), "t.yaml:1:1: a: \"2023\"" + rule);
  EXPECT_EQ(message(to_name, "a.b"), "t.yaml:1:1: a: \"a.b\"" + rule);
  EXPECT_EQ(message(to_name, "\"\""), "t.yaml:1:1: a: \"\"" + rule);
  EXPECT_EQ(message(to_name, "[a]"), "t.yaml:1:1: a: a list; expected a name");
  EXPECT_EQ(to_name(value(std::string(64, 'a')), "a"), std::string(64, 'a'));
  EXPECT_EQ(message(to_name, std::string(65, 'a')),
            "t.yaml:1:1: a: \"" + std::string(40, 'a') + "...\" is longer than 64 characters");
}

TEST(Scalar, RealTextReadsBackExactly) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 10000; ++i) {
    const std::uint64_t bits = random();
    const double number = std::bit_cast<double>(bits);
    if (!std::isfinite(number) || std::abs(number) < std::numeric_limits<double>::min()) continue;
    EXPECT_EQ(to_real(value(real_text(number)), "a"), number);
  }
}

}  // namespace
}  // namespace regista::config
