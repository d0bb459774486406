// SPDX-License-Identifier: MIT
// The parts that a recording and its page are made of.
#include <gmock/gmock.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "recording/packed_recording.hpp"
#include "recording/schemas.hpp"
#include "texts/html.hpp"
#include "texts/json.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {
namespace {

using texts::append_base64;
using texts::JsonText;

std::string base64(std::string_view bytes) {
  std::string out = ">";
  append_base64(out, bytes);
  return out.substr(1);
}

TEST(Base64, GivesTheVectorsOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string_view("\xff\xfe\x00\xfb\xf0", 5)), "//4A+/A=");
}

TEST(MatchPage, PutsNameAndRecordingIntoTheirPlaces) {
  const std::string viewer = R"(<a name="@REGISTA_RECORDING_NAME@">@REGISTA_RECORDING@</a>)";
  EXPECT_EQ(match_page(viewer, "foo", "<my> \"match\""), R"(<a name="&lt;my&gt; &quot;match&quot;">Zm9v</a>)");
  EXPECT_EQ(match_page("no place", "foo", "n"), std::nullopt);
  EXPECT_EQ(match_page("@REGISTA_RECORDING_NAME@ alone", "foo", "n"), std::nullopt);
}

std::string number(double value, int decimals) {
  JsonText json;
  json.number(value, decimals);
  return std::string(json.text());
}

std::string quantity(double value, int decimals) {
  JsonText json;
  json.quantity(value, decimals);
  return std::string(json.text());
}

TEST(JsonText, EscapesTextsOfOthers) {
  const std::string text = "a \"b\" \\ \n\x01 \xc3\xbc";
  JsonText json;
  json.open('{').key("said").string(text).key("more").string("").close('}');
  EXPECT_EQ(nlohmann::json::parse(json.text()), (nlohmann::json{{"said", text}, {"more", ""}}));
}

TEST(JsonText, WritesNumbersWithoutIdleDigits) {
  EXPECT_EQ(number(0.0, 3), "0");
  EXPECT_EQ(number(-0.0, 3), "0");
  EXPECT_EQ(number(-0.0004, 3), "0");
  EXPECT_EQ(number(1.5, 3), "1.5");
  EXPECT_EQ(number(-12.0305, 3), "-12.031");
  EXPECT_EQ(number(0.05, 2), "0.05");
  EXPECT_EQ(number(100.0, 2), "100");
  EXPECT_EQ(number(999'999'999.0, 6), "999999999");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity(), 3), "null");
  EXPECT_EQ(number(std::nan(""), 3), "null");
  EXPECT_EQ(nlohmann::json::parse(number(1e300, 3)).get<double>(), 1e300);
}

TEST(JsonText, NumbersAreTheNearestWithSoManyDecimals) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> digits(-1.0, 1.0);
  for (int i = 0; i < 20'000; ++i) {
    const int decimals = 1 + i % 6;
    const double value = digits(random) * std::pow(10.0, i % 9);
    const double half_step = 0.5 * std::pow(10.0, -decimals);
    const std::string text = number(value, decimals);
    double read = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
    ASSERT_TRUE(error == std::errc() && end == text.data() + text.size()) << text;
    ASSERT_LE(std::abs(read - value), half_step * (1.0 + 1e-9) + 1e-15 * std::abs(value)) << text;
    const std::size_t point = text.find('.');
    ASSERT_TRUE(point == std::string::npos || text.size() - point - 1 <= static_cast<std::size_t>(decimals)) << text;
  }
}

TEST(JsonText, SmallQuantitiesKeepTheirDigits) {
  EXPECT_EQ(quantity(0.5, 4), "0.5");
  EXPECT_EQ(quantity(0.0, 4), "0");
  EXPECT_EQ(nlohmann::json::parse(quantity(1.2345e-7, 4)).get<double>(), 1.2345e-7);
  EXPECT_EQ(nlohmann::json::parse(quantity(-0.012345678, 4)).get<double>(), -0.012346);
}

TEST(JsonText, IsJsonHoweverLongItGets) {
  JsonText json;
  for (int round = 0; round < 2; ++round) {
    json.clear();
    json.open('{').key("list").open('[');
    for (int i = 0; i < 20'000; ++i) json.number(i / 7.0).integer(-i).word("x").null().boolean(i % 2 == 0);
    json.close(']').key("empty").open('{').close('}').key("end").integer(INT64_MIN).close('}');
    const auto parsed = nlohmann::json::parse(json.text());
    EXPECT_EQ(parsed.at("list").size(), 100'000u);
    EXPECT_EQ(parsed.at("end"), INT64_MIN);
  }
}

// What Foxglove takes for the description of a message: objects of named properties, each of one type, and lists of
// such, but no lists of lists and no alternatives.
bool foxglove_takes(const nlohmann::json& schema) {
  if (schema.value("type", "") != "object" || !schema.contains("properties")) return false;
  for (const auto& [name, property] : schema.at("properties").items()) {
    const nlohmann::json& item = property.value("type", "") == "array" ? property.at("items") : property;
    if (property.contains("oneOf") || !item.contains("type")) return false;
    const std::string type = item.at("type");
    if (type == "object" ? !foxglove_takes(item)
                         : type != "boolean" && type != "string" && type != "number" && type != "integer") {
      return false;
    }
  }
  return true;
}

// Parsers keep one of the two, each another.
TEST(RecordingSchemas, HaveNoKeyTwice) {
  for (const std::string& schema :
       {schema::game(), schema::event(), schema::play(), schema::packet(), schema::heard(), schema::segment(),
        schema::log(), schema::draw(), schema::decision(), schema::belief()}) {
    std::vector<std::set<std::string>> keys;
    const auto look = [&](int, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
      using Event = nlohmann::json::parse_event_t;
      if (event == Event::object_start) keys.emplace_back();
      if (event == Event::object_end) keys.pop_back();
      const bool first = event != Event::key || keys.back().insert(parsed.get<std::string>()).second;
      EXPECT_TRUE(first) << parsed << " in " << schema;
      return true;
    };
    EXPECT_TRUE(nlohmann::json::parse(schema, look).is_object());
  }
}

TEST(RecordingSchemas, AreWhatFoxgloveTakes) {
  for (const std::string& schema :
       {schema::game(), schema::event(), schema::packet(), schema::heard(), schema::segment(), schema::log(),
        schema::draw(), schema::decision(), schema::belief()}) {
    const auto parsed = nlohmann::json::parse(schema);
    EXPECT_TRUE(foxglove_takes(parsed)) << schema;
    for (const auto& name : parsed.at("required")) {
      const bool plain = parsed.at("properties").contains(name);
      EXPECT_TRUE(plain || parsed.at("allOf").at(0).at("properties").contains(name)) << name;
    }
  }
  using namespace nlohmann::literals;
  EXPECT_FALSE(foxglove_takes(R"({"type":"object","properties":{"a":{"anyOf":[]}}})"_json));
  EXPECT_FALSE(
      foxglove_takes(R"({"type":"object","properties":{"a":{"type":"array","items":{"type":"array"}}}})"_json));
}

}  // namespace
}  // namespace regista::recording
