// SPDX-License-Identifier: MIT
// What a plugin declares, copied, written as bytes and read again, is what the plugin itself says.
#include "plugin/description.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

constexpr std::array choices{"near", "far", "nowhere at all"};

const std::vector<regista_parameter>& declared() {
  static const std::vector<regista_parameter> parameters{
      {sizeof(regista_parameter), REGISTA_TYPE_REAL, "reach", "m", "How far", 0.1, 20.0, 1.0 / 3, nullptr, nullptr, 0,
       REGISTA_PARAMETER_TUNABLE | REGISTA_PARAMETER_LOG_SCALE},
      {sizeof(regista_parameter), REGISTA_TYPE_INTEGER, "depth", "1", "", -5.0, 5.0, -2.0, nullptr, nullptr, 0, 0},
      {sizeof(regista_parameter), REGISTA_TYPE_CHOICE, "where", "", "One of these", 0.0, 2.0, 1.0, nullptr,
       choices.data(), choices.size(), 0},
      {sizeof(regista_parameter), REGISTA_TYPE_TEXT, "words", "", "Said", 0.0, 0.0, 0.0, "hello\nworld", nullptr, 0, 0},
      {sizeof(regista_parameter), REGISTA_TYPE_TEXT, "none", "", "Said", 0.0, 0.0, 0.0, nullptr, nullptr, 0, 0}};
  return parameters;
}

void expect_same(const regista_parameter& a, const regista_parameter& b) {
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.type, b.type);
  EXPECT_STREQ(a.name, b.name);
  EXPECT_STREQ(a.unit, b.unit);
  EXPECT_STREQ(a.doc, b.doc);
  EXPECT_EQ(a.minimum, b.minimum);
  EXPECT_EQ(a.maximum, b.maximum);
  EXPECT_EQ(a.initial, b.initial);
  EXPECT_STREQ(a.initial_text, b.initial_text);
  EXPECT_EQ(a.flags, b.flags);
  ASSERT_EQ(a.choice_count, b.choice_count);
  for (std::uint32_t i = 0; i < a.choice_count; ++i) EXPECT_STREQ(a.choices[i], b.choices[i]);
}

class DescriptionTest : public PuppetTest {
 protected:
  static regista_descriptor live() {
    regista_descriptor out = Puppet::descriptor();
    out.parameters = declared().data();
    out.parameter_count = static_cast<std::uint32_t>(declared().size());
    out.parameter_stride = sizeof(regista_parameter);
    return out;
  }

  static std::vector<std::uint8_t> bytes_of(const Description& description) {
    texts::BytesOut out;
    description.write(out);
    return {out.bytes().begin(), out.bytes().end()};
  }

  static void expect_says(const Description& description, const regista_descriptor& live) {
    const regista_descriptor& said = description.declared();
    EXPECT_STREQ(said.id, live.id);
    EXPECT_STREQ(said.version, live.version);
    EXPECT_STREQ(said.summary, live.summary);
    EXPECT_STREQ(said.licence, live.licence);
    EXPECT_STREQ(said.build_tag, live.build_tag);
    EXPECT_NE(static_cast<const void*>(said.id), static_cast<const void*>(live.id)) << "a copy of its own";
    EXPECT_EQ(said.abi_major, live.abi_major);
    EXPECT_EQ(said.abi_minor, live.abi_minor);
    for (int kind = 1; kind < REGISTA_KIND_END; ++kind)
      EXPECT_EQ(description.implements(kind), live.table(kind) != nullptr);
    EXPECT_EQ(description.subjects(), Puppet::predictor.subjects);
    EXPECT_EQ(description.assigner_flags(), Puppet::assigner.flags);
    ASSERT_EQ(said.parameter_count, live.parameter_count);
    for (std::uint32_t i = 0; i < said.parameter_count; ++i) expect_same(parameter(said, i), declared()[i]);
    // Nothing of it can be called.
    EXPECT_EQ(said.table, nullptr);
    EXPECT_EQ(said.create, nullptr);
    EXPECT_EQ(said.reset, nullptr);
    EXPECT_EQ(said.destroy, nullptr);
  }
};

TEST_F(DescriptionTest, SaysWhatThePluginSays) {
  Puppet::assigner.flags = 1;
  expect_says(Description(live()), live());
}

TEST_F(DescriptionTest, ComesBackFromItsBytes) {
  Puppet::assigner.flags = 1;
  const std::vector<std::uint8_t> bytes = bytes_of(Description(live()));
  texts::BytesIn in(bytes);
  const Description read(in);
  EXPECT_TRUE(in.empty());
  expect_says(read, live());
  EXPECT_EQ(bytes_of(read), bytes);
}

TEST_F(DescriptionTest, ReadsParametersOfALargerStruct) {
  // As of a later interface: what it has grown by is left out.
  struct Grown {
    regista_parameter now;
    double later;
  };
  std::vector<Grown> grown;
  for (const regista_parameter& each : declared()) grown.push_back({each, 7.0});
  for (Grown& each : grown) each.now.size = sizeof(Grown);
  regista_descriptor larger = live();
  larger.parameters = &grown.front().now;
  larger.parameter_stride = sizeof(Grown);
  const Description description(larger);
  for (std::uint32_t i = 0; i < larger.parameter_count; ++i) {
    EXPECT_STREQ(parameter(description.declared(), i).name, declared()[i].name);
  }
}

TEST_F(DescriptionTest, DamagedBytesAreRefused) {
  const std::vector<std::uint8_t> bytes = bytes_of(Description(live()));
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    texts::BytesIn in{std::span<const std::uint8_t>(bytes).first(length)};
    EXPECT_THROW(Description{in}, std::out_of_range) << length;
  }
  // Whatever a plugin wrote there: some description, or a refusal.
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> damaged = bytes;
    for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<std::uint8_t>(random());
    texts::BytesIn in(damaged);
    try {
      const Description read(in);
      for (std::uint32_t p = 0; p < read.declared().parameter_count; ++p) {
        EXPECT_NE(parameter(read.declared(), p).name, nullptr);
      }
    } catch (const std::out_of_range&) {
    }
  }
}

}  // namespace
}  // namespace regista::plugin::test
