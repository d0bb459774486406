// SPDX-License-Identifier: MIT
// Numbers of matches as JSON and as bytes: what is read is what was written, bit for bit, and nothing else is read.
#include "campaign/match_encoding.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "texts/json.hpp"

namespace regista::campaign {
namespace {

using namespace std::string_view_literals;
using match::Side;
using testing::ElementsAre;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> out;
  for (const double value : values) out.push_back(std::bit_cast<std::uint64_t>(value));
  return out;
}

TEST(MetricBytes, AreThoseOfTheDocumentedFormat) {
  EXPECT_EQ(number_bytes(std::vector{none, 0.0, -1e-6, 1e-6, 0.000063}), "\x00\x02\x03\x04\x80\x01"sv);
  EXPECT_EQ(number_bytes(std::vector{0.1 + 0.2}), "\x01\x34\x33\x33\x33\x33\x33\xd3\x3f"sv);
}

TEST(MetricBytes, EveryNumberComesBackBitForBit) {
  std::vector<double> values{
      0.0,    -0.0, 1.0,   -1.0, 0.1,  12.3, -12.3, 1e-6, 5e-7,      1e300,
      -1e300, 9e9,  9.1e9, 1e15, none, 600,  1200,  1e-9, 1.0 / 3.0, std::numeric_limits<double>::infinity()};
  std::mt19937_64 random(7);
  for (int i = 0; i < 10'000; ++i) {
    values.push_back(std::round(static_cast<double>(random() % 2'000'000'000) - 1e9) / 1e6);
    const double any = std::bit_cast<double>(random());
    if (!std::isnan(any)) values.push_back(any);
  }
  EXPECT_EQ(bits(numbers_of(number_bytes(values), values.size())), bits(values));
}

TEST(MetricBytes, OtherBytesAreRefused) {
  const std::string bytes = number_bytes(std::vector{1.0, 0.1 + 0.2});
  EXPECT_THROW(numbers_of(bytes, 1), std::invalid_argument);
  EXPECT_THROW(numbers_of(bytes, 3), std::invalid_argument);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(numbers_of(std::string_view(bytes).substr(0, length), 2), std::invalid_argument) << length;
  }
  EXPECT_THROW(numbers_of(std::string(11, '\x80'), 1), std::invalid_argument);
}

TEST(MetricBytes, NamesComeBackInTheirOrder) {
  const match::MetricNames names({{.name = "playing_seconds"},
                                  {.side = Side::home, .name = "packets"},
                                  {.side = Side::home, .role = "playing.striker", .name = "switches"},
                                  {.side = Side::home, .role = "a\"b", .name = "robot_seconds", .place = 1},
                                  {.side = Side::home, .role = "a\"b", .name = "robot_seconds", .place = 2},
                                  {.side = Side::away, .name = "packets"}});
  EXPECT_EQ(*names_of(names_text(names)), names);
  for (const char* const text : {"", "{", "7", "[7]", "[{}]", R"([{"name": "a", "side": "left"}])",
                                 R"([{"name": "a"}, {"name": "a"}])", R"([{"name": 7}])"}) {
    EXPECT_THROW(names_of(text), std::invalid_argument) << text;
  }
}

TEST(MetricJson, ComesBackAsItWas) {
  const std::string text =
      R"({"playing_seconds":612.4,"packets":[90,null],"budget_curve":[[3,2,1],[]],)"
      R"("territory":[{"ball":{"x":0.3}},{"ball":{"x":-0.3}}],"roles":[{"a.b":{"switches":4,"robot_seconds":[1,2.5]}},{}]})";
  const match::MetricNumbers numbers = metrics_from_json(text);
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < numbers.names().size(); ++i) paths.push_back(numbers.names().path(i));
  EXPECT_THAT(paths, ElementsAre("playing_seconds", "packets", "packets", "budget_curve.1", "budget_curve.2",
                                 "budget_curve.3", "territory.ball.x", "territory.ball.x", "a.b.switches",
                                 "a.b.robot_seconds.1", "a.b.robot_seconds.2"));
  nlohmann::ordered_json again;
  add_metrics(again, numbers);
  EXPECT_EQ(metrics_from_json(again), numbers);
  EXPECT_EQ(again["packets"], nlohmann::ordered_json::parse("[90, null]"));
  EXPECT_EQ(again["roles"][0]["a.b"]["robot_seconds"], nlohmann::ordered_json::parse("[1, 2.5]"));
}

TEST(MetricJson, OtherJsonIsRefused) {
  for (const char* const text : {"", "{", "[]", "null", R"({"a": "text"})", R"({"a": [1]})", R"({"a": [1, 2, 3]})",
                                 R"({"a": {"b": 1}})", R"({"a": [{"b": "text"}, 1]})", R"({"a": [[[1]], 2]})",
                                 R"({"roles": [1, 2]})", R"({"roles": [{"a": 1}, {}]})", R"({"a": [["text"], 1]})"}) {
    EXPECT_THROW(metrics_from_json(std::string(text)), std::invalid_argument) << text;
  }
}

}  // namespace
}  // namespace regista::campaign
