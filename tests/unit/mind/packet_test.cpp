// SPDX-License-Identifier: MIT
// The packet codec against its own specification (packet.hpp): sizes, quanta, ends of ranges, refusals, arbitrary
// bytes.
#include "mind/world/packet.hpp"

#include <gtest/gtest.h>

#include <regista/testkit/dice.hpp>

#include "fuzz/packet/canonical.hpp"

namespace regista::mind {
namespace {

constexpr PacketLimits limits{.team_size = 7, .role_count = 20, .context_count = 3, .size = 128};

using testkit::Dice;

Report random_report(Dice& dice) {
  Report report;
  report.sender = dice.integer(1, 7);
  report.time_sent = dice.real(0.0, 1500.0);
  report.pose.x = dice.real(-6.0, 6.0);
  report.pose.y = dice.real(-4.0, 4.0);
  report.pose.heading = dice.real(-pi, pi);
  report.position_deviation = dice.real(0.0, 2.5);
  report.heading_deviation = dice.real(0.0, 2.5);
  report.velocity = {dice.real(-1.2, 1.2), dice.real(-1.2, 1.2)};
  report.target = {dice.real(-6.0, 6.0), dice.real(-4.0, 4.0)};
  report.fallen = dice.integer(0, 1) != 0;
  report.playing = dice.integer(0, 1) != 0;
  report.time_until_up = dice.real(0.0, 25.0);
  report.role = dice.integer(-1, 19);
  report.role_since = dice.real(0.0, 1500.0);
  report.context = dice.integer(0, 2);
  if (dice.integer(0, 1) != 0) {
    ReportedBall& ball = report.ball.emplace();
    ball.position = {dice.real(-6.0, 6.0), dice.real(-4.0, 4.0)};
    ball.velocity = {dice.real(-5.0, 5.0), dice.real(-5.0, 5.0)};
    ball.deviation = dice.real(0.0, 2.5);
    ball.age = dice.real(0.0, 30.0);
  }
  report.opponent_count = static_cast<std::size_t>(dice.integer(0, 5));
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    report.opponents[i].position = {dice.real(-6.0, 6.0), dice.real(-4.0, 4.0)};
    report.opponents[i].deviation = dice.real(0.0, 1.5);
    report.opponents[i].age = dice.real(0.0, 7.5);
  }
  return report;
}

Report sent_and_heard(const Report& report) {
  std::vector<std::uint8_t> bytes;
  std::vector<Segment> segments;
  encode(report, bytes);
  const std::optional<Report> out = decode(bytes, limits, segments);
  EXPECT_TRUE(out.has_value());
  return out.value_or(Report{});
}

TEST(Packet, EveryValueComesBackWithinHalfAQuantum) {
  Dice dice(1);
  constexpr double slack = 1e-9;
  const auto near = [](double a, double b, double quantum, const char* what) {
    EXPECT_LE(std::abs(a - b), 0.5 * quantum + slack) << what << ": " << a << " became " << b;
  };
  for (int round = 0; round < 2000; ++round) {
    const Report sent = random_report(dice), heard = sent_and_heard(sent);
    EXPECT_EQ(heard.sender, sent.sender);
    EXPECT_EQ(heard.fallen, sent.fallen);
    EXPECT_EQ(heard.playing, sent.playing);
    EXPECT_EQ(heard.role, sent.role);
    EXPECT_EQ(heard.context, sent.context);
    near(sent.time_sent, heard.time_sent, 1e-3, "time");
    near(sent.pose.x, heard.pose.x, 1e-3, "x");
    near(sent.pose.y, heard.pose.y, 1e-3, "y");
    near(0.0, std::remainder(sent.pose.heading - heard.pose.heading, 2.0 * pi), 2.0 * pi / 65536.0, "heading");
    near(sent.position_deviation, heard.position_deviation, 0.01, "deviation");
    near(sent.heading_deviation, heard.heading_deviation, 0.01, "deviation of the heading");
    near(sent.velocity.x(), heard.velocity.x(), 0.01, "vx");
    near(sent.velocity.y(), heard.velocity.y(), 0.01, "vy");
    near(sent.target.x(), heard.target.x(), 1e-3, "x of the target");
    near(sent.target.y(), heard.target.y(), 1e-3, "y of the target");
    near(sent.role_since, heard.role_since, 0.1, "role since");
    near(sent.time_until_up, heard.time_until_up, 0.1, "time until up");
    ASSERT_EQ(heard.ball.has_value(), sent.ball.has_value());
    if (sent.ball) {
      near(sent.ball->position.x(), heard.ball->position.x(), 1e-3, "x of the ball");
      near(sent.ball->position.y(), heard.ball->position.y(), 1e-3, "y of the ball");
      near(sent.ball->velocity.x(), heard.ball->velocity.x(), 1e-3, "vx of the ball");
      near(sent.ball->velocity.y(), heard.ball->velocity.y(), 1e-3, "vy of the ball");
      near(sent.ball->age, heard.ball->age, 0.01, "age of the ball");
      near(sent.ball->deviation, heard.ball->deviation, 0.01, "deviation of the ball");
    }
    ASSERT_EQ(heard.opponent_count, sent.opponent_count);
    for (std::size_t i = 0; i < sent.opponent_count; ++i) {
      near(sent.opponents[i].position.x(), heard.opponents[i].position.x(), 0.01, "x of an opponent");
      near(sent.opponents[i].position.y(), heard.opponents[i].position.y(), 0.01, "y of an opponent");
      near(sent.opponents[i].deviation, heard.opponents[i].deviation, 0.1, "deviation of an opponent");
      near(sent.opponents[i].age, heard.opponents[i].age, 0.5, "age of an opponent");
    }
  }
}

TEST(Packet, ValuesBeyondAFieldsRangeComeBackAsItsEnd) {
  Report report;
  report.sender = 3;
  report.time_sent = 1e9;
  report.pose = {1e3, -1e3, pi};
  report.position_deviation = 9.0;
  report.heading_deviation = -1.0;
  report.velocity = {5.0, -5.0};
  report.target = {-1e6, 1e6};
  report.role_since = 1e6;
  report.time_until_up = 100.0;
  report.ball = ReportedBall{{99.0, -99.0}, {1e300, -1e300}, 50.0, 1e4};
  report.opponent_count = 1;
  report.opponents[0] = {{30.0, -30.0}, 7.0, 60.0};
  const Report heard = sent_and_heard(report);
  EXPECT_DOUBLE_EQ(heard.time_sent, 16777.215);
  EXPECT_DOUBLE_EQ(heard.pose.x, 32.767);
  EXPECT_DOUBLE_EQ(heard.pose.y, -32.768);
  EXPECT_DOUBLE_EQ(heard.pose.heading, pi);
  EXPECT_DOUBLE_EQ(heard.position_deviation, 2.55);
  EXPECT_DOUBLE_EQ(heard.heading_deviation, 0.0);
  EXPECT_DOUBLE_EQ(heard.velocity.x(), 1.27);
  EXPECT_DOUBLE_EQ(heard.velocity.y(), -1.28);
  EXPECT_DOUBLE_EQ(heard.target.x(), -32.768);
  EXPECT_DOUBLE_EQ(heard.target.y(), 32.767);
  EXPECT_DOUBLE_EQ(heard.role_since, 6553.5);
  EXPECT_DOUBLE_EQ(heard.time_until_up, 25.5);
  EXPECT_DOUBLE_EQ(heard.ball->position.x(), 32.767);
  EXPECT_DOUBLE_EQ(heard.ball->velocity.y(), -32.768);
  EXPECT_DOUBLE_EQ(heard.ball->age, 655.35);
  EXPECT_DOUBLE_EQ(heard.ball->deviation, 2.55);
  EXPECT_DOUBLE_EQ(heard.opponents[0].position.x(), 20.47);
  EXPECT_DOUBLE_EQ(heard.opponents[0].position.y(), -20.48);
  EXPECT_DOUBLE_EQ(heard.opponents[0].deviation, 1.5);
  EXPECT_DOUBLE_EQ(heard.opponents[0].age, 7.5);
}

TEST(Packet, HasTheSizesOfItsSpecification) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t opponents = 0; opponents <= Report::most_opponents; ++opponents) {
    for (const bool ball : {false, true}) {
      Report report;
      report.sender = 1;
      report.opponent_count = opponents;
      if (ball) report.ball.emplace();
      encode(report, bytes);
      EXPECT_EQ(bytes.size(), 24 + (ball ? 11 : 0) + 4 * opponents);
      EXPECT_LE(bytes.size(), 60u);
    }
  }
}

TEST(Packet, IsTheSameBytesEverywhere) {
  Report report;
  report.sender = 5;
  report.time_sent = 0x030201 * 1e-3;
  report.pose = {0.258, -0.001, pi / 2};
  report.role = 4;
  report.context = 1;
  report.playing = true;
  std::vector<std::uint8_t> bytes;
  encode(report, bytes);
  const std::vector<std::uint8_t> expected{5 << 3 | 1, 1 << 4, 1, 2, 3, 0x02, 0x01, 0xff, 0xff, 0x00, 0x40, 0,
                                           0,          0,      0, 0, 0, 0,    0,    4,    0,    0,    1,    0};
  EXPECT_EQ(bytes, expected);
}

TEST(Packet, RefusesWhatIsNotOfThisTeam) {
  Report report;
  report.sender = 7;
  report.role = 19;
  report.context = 2;
  std::vector<std::uint8_t> good;
  encode(report, good);
  std::vector<Segment> segments;
  ASSERT_TRUE(decode(good, limits, segments));
  const auto refused = [&](std::size_t at, std::uint8_t value) {
    std::vector<std::uint8_t> bytes = good;
    bytes[at] = value;
    return !decode(bytes, limits, segments).has_value();
  };
  EXPECT_TRUE(refused(0, 8 << 3 | 1)) << "robot 8 of 7";
  EXPECT_TRUE(refused(0, 0 << 3 | 1)) << "robot 0";
  for (std::uint8_t version = 0; version < 8; ++version) {
    EXPECT_EQ(refused(0, static_cast<std::uint8_t>(7 << 3 | version)), version != 1);
  }
  EXPECT_TRUE(refused(1, 1 << 6)) << "reserved bit";
  EXPECT_TRUE(refused(1, 1 << 7)) << "reserved bit";
  for (std::uint8_t count = 1; count < 8; ++count) EXPECT_TRUE(refused(1, count)) << "opponents that are not there";
  EXPECT_TRUE(refused(19, 20)) << "role 20 of 20";
  EXPECT_FALSE(refused(19, 255)) << "no role";
  EXPECT_TRUE(refused(22, 3)) << "context 3 of 3";
  good.resize(limits.size + 1);
  EXPECT_FALSE(decode(good, limits, segments)) << "longer than a packet may be";
  // Six and seven opponents are refused even where there would be bytes for them.
  for (const std::uint8_t count : {std::uint8_t{6}, std::uint8_t{7}}) {
    std::vector<std::uint8_t> bytes(24 + 4 * std::size_t{count});
    std::copy_n(good.begin(), 24, bytes.begin());
    bytes[1] = count;
    EXPECT_FALSE(decode(bytes, limits, segments));
  }
}

TEST(Packet, SegmentsFollowTheCoreAndAreViewsIntoTheBytes) {
  Report report;
  report.sender = 2;
  report.ball.emplace();
  std::vector<std::uint8_t> bytes;
  encode(report, bytes);
  const std::vector<std::uint8_t> first{1, 2, 3}, second;
  append_segment({200, first}, bytes);
  append_segment({0, second}, bytes);
  std::vector<Segment> segments;
  ASSERT_TRUE(decode(bytes, limits, segments));
  ASSERT_EQ(segments.size(), 2u);
  EXPECT_EQ(segments[0].place, 200);
  EXPECT_EQ(std::vector<std::uint8_t>(segments[0].bytes.begin(), segments[0].bytes.end()), first);
  EXPECT_GE(segments[0].bytes.data(), bytes.data());
  EXPECT_LE(segments[0].bytes.data() + 3, bytes.data() + bytes.size());
  EXPECT_EQ(segments[1].place, 0);
  EXPECT_TRUE(segments[1].bytes.empty());
  for (std::size_t cut = 1; cut <= 6; ++cut) {
    const std::span<const std::uint8_t> shorter(bytes.data(), bytes.size() - cut);
    const bool at_a_border = cut == 2;  // only the empty segment is gone
    EXPECT_EQ(decode(shorter, limits, segments).has_value(), at_a_border) << cut;
    EXPECT_EQ(segments.empty(), !at_a_border) << "segments of a refused packet";
    const std::optional<Report> core = decode_core(shorter, limits);
    ASSERT_TRUE(core) << "whoever sent it is known all the same";
    EXPECT_EQ(core->sender, 2);
  }
  const std::span<const std::uint8_t> no_core(bytes.data(), 30);
  EXPECT_FALSE(decode_core(no_core, limits)) << "the ball is cut";
  EXPECT_FALSE(decode_core(std::vector<std::uint8_t>(129), limits));
}

// Buffers are exactly as long as the bytes, so that the sanitizers see a read past the end.
TEST(Packet, AnyBytesAreRefusedOrTheOneEncodingOfWhatTheySay) {
  Dice dice(2);
  PacketLimits roomy = limits;
  roomy.size = 200;
  int accepted = 0;
  for (std::size_t length = 0; length <= 200; ++length) {
    for (int round = 0; round < 300; ++round) {
      std::vector<std::uint8_t> bytes(length);
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(dice.bits());
      // Half of them pass the first checks, so that the later ones are reached.
      if (length > 22 && round % 2 == 0) {
        bytes[0] = static_cast<std::uint8_t>(dice.integer(1, 7) << 3 | 1);
        bytes[1] &= 0x3f;
        bytes[19] = static_cast<std::uint8_t>(dice.integer(0, 19));
        bytes[22] = static_cast<std::uint8_t>(dice.integer(0, 2));
      }
      const Verdict verdict = examine(bytes, roomy);
      ASSERT_NE(verdict, Verdict::not_canonical);
      ASSERT_NE(verdict, Verdict::no_sense);
      accepted += verdict == Verdict::canonical;
    }
  }
  EXPECT_GT(accepted, 100);
}

TEST(Packet, OneWrongBitIsRefusedOrSaysSomethingElse) {
  Dice dice(3);
  std::vector<std::uint8_t> bytes;
  std::vector<Segment> segments;
  for (int round = 0; round < 200; ++round) {
    encode(random_report(dice), bytes);
    append_segment({round, {}}, bytes);
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
      const Verdict verdict = examine(bytes, limits);
      ASSERT_TRUE(verdict == Verdict::refused || verdict == Verdict::canonical) << "bit " << bit;
      bytes[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
    }
  }
}

}  // namespace
}  // namespace regista::mind
