// SPDX-License-Identifier: MIT
// What plugins log, draw and report, through the tables that they are given: limits, and who is named when they are
// broken.
#include "mind/extensions/extensions.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include "regista/draw.hpp"
#include "regista/metric.hpp"
#include "regista/plugin.hpp"
#include "regista/utility.hpp"

namespace regista::mind {
namespace {

struct Talker {
  static constexpr auto id = "talker", version = "1.0.0", summary = "Watched by a test";
  static constexpr std::array metrics{metric("hits", "1", "How often", REGISTA_METRIC_SUM),
                                      metric("reach", "m", "How far", REGISTA_METRIC_GREATEST)};
  void score(const Frame&, Utilities) {}
};

class ExtensionsTest : public testing::Test {
 protected:
  ExtensionsTest() { caller.tick = 41; }

  // What it is given.
  const regista_log& log() { return *static_cast<const regista_log*>(own().find(REGISTA_LOG_EXTENSION)); }
  const regista_draw& draw() { return *static_cast<const regista_draw*>(own().find(REGISTA_DRAW_EXTENSION)); }
  const regista_metric_reports& reports() {
    return *static_cast<const regista_metric_reports*>(own().find(REGISTA_METRIC_EXTENSION));
  }
  const InstanceExtensions& own() {
    if (own_ == nullptr) {
      own_ = &extensions.open(plugin, of_team);
      extensions.begin(4.1);
    }
    return *own_;
  }
  void say(std::string_view text, std::int32_t level = REGISTA_LOG_INFO) {
    log().write(log().context, level, text.data(), static_cast<std::uint32_t>(text.size()));
  }
  void polygon(const char* layer, const std::vector<regista_point>& points, double width = 0.0) {
    regista_shape shape{};
    shape.size = sizeof shape;
    shape.shape = REGISTA_SHAPE_POLYGON;
    shape.layer = layer;
    shape.width = width;
    shape.points = points.data();
    shape.count = static_cast<std::uint32_t>(points.size());
    draw().draw(draw().context, &shape);
  }
  void report(std::uint32_t metric, double value) { reports().report(reports().context, metric, value); }
  std::vector<std::string> lines() const {
    std::vector<std::string> out;
    for (const LogLine& each : extensions.log().lines()) out.push_back(to_string(each));
    return out;
  }
  using Lines = std::vector<std::string>;

  plugin::Found plugin{"talker.so", Plugin<Talker, utility>::descriptor()};
  std::vector<int> of_team{4, 2};
  plugin::Caller caller{"paper", 3};
  std::vector<std::string> told;  // at once
  Extensions extensions{caller, {0, [this](const LogLine& line) { told.push_back(to_string(line)); }}, true};

 private:
  const InstanceExtensions* own_ = nullptr;
};

TEST_F(ExtensionsTest, NamesThatNobodyKnowsAreNull) {
  EXPECT_EQ(own().find("regista.log/1"), nullptr);
  EXPECT_EQ(own().find("regista.reward/0"), nullptr);
  EXPECT_EQ(own().find(""), nullptr);
}

TEST_F(ExtensionsTest, WhatWasToldIsGivenAsItWasSaid) {
  const auto& told_table = *static_cast<const regista_told*>(own().find(REGISTA_TOLD_EXTENSION));
  const auto& budget_table = *static_cast<const regista_budget_now*>(own().find(REGISTA_BUDGET_EXTENSION));
  regista_told_packet packet{};
  packet.size = sizeof packet;
  EXPECT_EQ(told_table.packet(told_table.context, 2, &packet), 0) << "nothing is known yet";
  EXPECT_EQ(told_table.sees_ball(told_table.context), 0);

  Report report;
  report.time_sent = 3.5;
  report.pose = {1, -2, 0.5};
  report.velocity = {0.1, 0.2};
  report.target = {3, 4};
  report.role = 5;
  report.role_since = 1.5;
  report.context = 2;
  report.ball.emplace(ReportedBall{{0.5, 0.6}, {-1, 1}, 0.1, 0.7});
  extensions.answer_with({[&](int number) { return number == 2 ? &report : nullptr; }, [] { return true; },
                          [] {
                            regista_budget out{};
                            out.packets_left = 17;
                            out.share = 0.5;
                            return out;
                          }});
  ASSERT_EQ(told_table.packet(told_table.context, 2, &packet), 1);
  EXPECT_EQ(packet.size, sizeof packet);
  EXPECT_EQ(packet.flags, std::uint32_t{REGISTA_TOLD_BALL});
  EXPECT_EQ(packet.time_sent, 3.5);
  EXPECT_EQ(std::vector(packet.pose, packet.pose + 3), (std::vector{1.0, -2.0, 0.5}));
  EXPECT_EQ(std::vector(packet.velocity, packet.velocity + 2), (std::vector{0.1, 0.2}));
  EXPECT_EQ(std::vector(packet.target, packet.target + 2), (std::vector{3.0, 4.0}));
  EXPECT_EQ(std::tuple(packet.role, packet.role_since, packet.context), std::tuple(5, 1.5, 2));
  EXPECT_EQ(std::vector(packet.ball, packet.ball + 2), (std::vector{0.5, 0.6}));
  EXPECT_EQ(std::vector(packet.ball_velocity, packet.ball_velocity + 2), (std::vector{-1.0, 1.0}));
  EXPECT_EQ(packet.ball_age, 0.7);
  EXPECT_EQ(told_table.packet(told_table.context, 3, &packet), 0);
  EXPECT_EQ(told_table.sees_ball(told_table.context), 1);
  EXPECT_EQ(told_table.receiver(told_table.context), 0);
  const auto& pass = *static_cast<const regista_pass*>(own().find(REGISTA_PASS_EXTENSION));
  pass.meant_for(pass.context, 6);
  EXPECT_EQ(told_table.receiver(told_table.context), 6);
  extensions.begin(4.2);
  EXPECT_EQ(told_table.receiver(told_table.context), 0) << "of this decision";
  // A caller that knows less is given less.
  regista_budget budget{};
  budget.size = offsetof(regista_budget, share);
  budget_table.read(budget_table.context, &budget);
  EXPECT_EQ(std::tuple(budget.packets_left, budget.share, budget.size),
            std::tuple(17, 0.0, static_cast<std::uint32_t>(offsetof(regista_budget, share))));
}

TEST_F(ExtensionsTest, ALineSaysWhoWroteIt) {
  say("two points coincide", REGISTA_LOG_WARNING);
  say("so be it", 77);
  const Lines wanted{"[warning] home 3, tick 41, talker: two points coincide",
                     "[info] home 3, tick 41, talker: so be it"};
  EXPECT_EQ(lines(), wanted);
  EXPECT_EQ(told, wanted);
  EXPECT_EQ(extensions.log().lines()[0].time, 4.1);
  extensions.begin(4.2);
  EXPECT_EQ(lines(), Lines());
}

TEST_F(ExtensionsTest, ALineCannotHarmATerminal) {
  say("a\nb\x1b[2J\xff");
  EXPECT_EQ(lines(), Lines{"[info] home 3, tick 41, talker: a\\nb\\x1b[2J\xef\xbf\xbd"});
}

TEST_F(ExtensionsTest, AMegabyteOfLogIsCutAndToldOnce) {
  const std::string kilobytes(100'000, 'x');
  for (int i = 0; i < 100; ++i) say(kilobytes);
  const auto written = extensions.log().lines();
  ASSERT_EQ(written.size(), REGISTA_LOG_MOST_LINES + 1u);
  EXPECT_EQ(written[0].text.size(), std::size_t{REGISTA_LOG_MOST_BYTES});
  EXPECT_EQ(
      lines().back(),
      "[warning] home 3, tick 41, talker: log: wrote more than 64 lines in one decision; what is more is left out");
  extensions.begin(4.2);
  for (int i = 0; i < 100; ++i) say("y");
  EXPECT_EQ(lines().size(), std::size_t{REGISTA_LOG_MOST_LINES}) << "and not told again";
}

TEST_F(ExtensionsTest, ALogOfAMatchHasAnEnd) {
  const std::string line(1000, 'x');
  std::size_t bytes = 0;
  for (int decision = 0; decision < 1000; ++decision) {
    extensions.begin(0.1 * decision);
    for (int i = 0; i < 10; ++i) say(line);
    for (const LogLine& each : extensions.log().lines()) bytes += each.text.size();
  }
  EXPECT_LE(bytes, REGISTA_LOG_MOST_OF_MATCH + 200u);
  EXPECT_GE(bytes, REGISTA_LOG_MOST_OF_MATCH - 1000u);
  EXPECT_EQ(told.back(),
            "[warning] home 3, tick 41, talker: log: wrote more than 256 KiB in this match; what is more is left out");
}

TEST_F(ExtensionsTest, TextsAreCutBetweenCharacters) {
  std::string text(REGISTA_LOG_MOST_BYTES - 1, 'x');
  say(text + "\xc3\xa4");
  EXPECT_EQ(extensions.log().lines()[0].text, text);
  say(text.substr(1) + "\xc3\xa4" + "y");
  EXPECT_EQ(extensions.log().lines()[1].text, text.substr(1) + "\xc3\xa4");
}

TEST_F(ExtensionsTest, ALengthThatIsWrongReadsNothingBehindTheText) {
  constexpr std::array said{'a', 'b', 'c', '\0', 'o', 't', 'h', 'e', 'r', '\0'};
  for (const std::uint32_t length : {4u, 10u, 4'000'000'000u}) {
    log().write(log().context, REGISTA_LOG_INFO, said.data(), length);
    EXPECT_EQ(extensions.log().lines().back().text, "abc");
  }
}

TEST_F(ExtensionsTest, ASinkHearsFromItsLevelOn) {
  std::vector<std::int32_t> heard;
  Extensions fresh(caller, {REGISTA_LOG_WARNING, [&](const LogLine& line) { heard.push_back(line.level); }});
  const auto& table = *static_cast<const regista_log*>(fresh.open(plugin, of_team).find(REGISTA_LOG_EXTENSION));
  for (const std::int32_t level : {REGISTA_LOG_DEBUG, REGISTA_LOG_ERROR, REGISTA_LOG_INFO, REGISTA_LOG_WARNING}) {
    table.write(table.context, level, "x", 1);
  }
  EXPECT_EQ(heard, (std::vector<std::int32_t>{REGISTA_LOG_ERROR, REGISTA_LOG_WARNING}));
}

TEST_F(ExtensionsTest, DrawingsLastForADecision) {
  polygon("cells", {{0, 0}, {1, 0}, {0, 1}}, 0.05);
  ASSERT_EQ(extensions.drawings().shapes().size(), 1u);
  const DrawnShape& shape = extensions.drawings().shapes()[0];
  EXPECT_EQ(shape.plugin, std::string("talker"));
  EXPECT_EQ(shape.layer, "cells");
  EXPECT_EQ(shape.points.size(), 3u);
  EXPECT_EQ(shape.width, 0.05);
  extensions.begin(4.2);
  EXPECT_EQ(extensions.drawings().shapes().size(), 0u);
}

TEST_F(ExtensionsTest, ShapesThatBreakARuleAreLeftOutAndTheFirstIsTold) {
  polygon("cells", {{0, 0}, {std::nan(""), 1}});
  polygon("cells", {{0, 0}, {10001, 0}});
  EXPECT_EQ(extensions.drawings().shapes().size(), 0u);
  EXPECT_EQ(lines(),
            Lines{"[warning] home 3, tick 41, talker: draw: layer cells: point 1 is at (nan, 1); it is left out"});
}

TEST_F(ExtensionsTest, PointsBeyondTheLimitAreNotRead) {
  const regista_point here{0, 0};
  regista_shape shape{};
  shape.size = sizeof shape;
  shape.shape = REGISTA_SHAPE_POINTS;
  shape.layer = "all";
  shape.points = &here;
  shape.count = 1'000'000'000;
  draw().draw(draw().context, &shape);
  EXPECT_EQ(lines(), Lines{"[warning] home 3, tick 41, talker: draw: layer all: a shape has 1000000000 points; at most "
                           "512 are taken; it "
                           "is left out"});
}

TEST_F(ExtensionsTest, WhatElseIsWrongWithAShape) {
  const auto said = [&](auto spoil) {
    Extensions fresh(caller, {}, true);
    const auto& table = *static_cast<const regista_draw*>(fresh.open(plugin, of_team).find(REGISTA_DRAW_EXTENSION));
    fresh.begin(0.0);
    const regista_point here{0, 0};
    regista_shape shape{};
    shape.size = sizeof shape;
    shape.shape = REGISTA_SHAPE_TEXT;
    shape.layer = "notes";
    shape.text = "x";
    shape.points = &here;
    shape.count = 1;
    spoil(shape);
    table.draw(table.context, &shape);
    return fresh.log().lines().empty() ? std::string() : std::string(fresh.log().lines()[0].text);
  };
  EXPECT_EQ(said([](regista_shape&) {}), "");
  EXPECT_EQ(said([](regista_shape& s) { s.size = 8; }),
            "draw: a shape is 8 bytes; regista.draw/0 needs 56; it is left out");
  EXPECT_EQ(said([](regista_shape& s) { s.shape = 5; }), "draw: there is no shape 5; it is left out");
  EXPECT_EQ(said([](regista_shape& s) { s.layer = nullptr; }), "draw: a shape names no layer; it is left out");
  EXPECT_EQ(said([](regista_shape& s) { s.layer = ""; }), "draw: a shape names no layer; it is left out");
  EXPECT_EQ(said([](regista_shape& s) { s.text = nullptr; }), "draw: layer notes: a text is null; it is left out");
  EXPECT_EQ(said([](regista_shape& s) { s.count = 0; }), "draw: layer notes: a shape has no points; it is left out");
  EXPECT_EQ(said([](regista_shape& s) { s.width = -1.0; }), "draw: layer notes: a shape is -1 m wide; it is left out");
}

TEST_F(ExtensionsTest, ShapesWithoutEndAreCut) {
  for (int i = 0; i < 1000; ++i) polygon("cells", {{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(extensions.drawings().shapes().size(), std::size_t{REGISTA_DRAW_MOST_SHAPES});
  EXPECT_EQ(lines(),
            Lines{"[warning] home 3, tick 41, talker: draw: more than 256 shapes in one decision; it is left out"});
}

TEST_F(ExtensionsTest, PointsOfADecisionAndLayersOfAMatchHaveAnEnd) {
  const std::vector<regista_point> many(REGISTA_DRAW_MOST_POINTS);
  for (int i = 0; i < 20; ++i) polygon("cells", many);
  EXPECT_EQ(extensions.drawings().shapes().size(),
            std::size_t{REGISTA_DRAW_MOST_POINTS_OF_ALL / REGISTA_DRAW_MOST_POINTS});
  EXPECT_EQ(lines(),
            Lines{"[warning] home 3, tick 41, talker: draw: more than 4096 points in one decision; it is left out"});

  Extensions fresh(caller, {}, true);
  const auto& table = *static_cast<const regista_draw*>(fresh.open(plugin, of_team).find(REGISTA_DRAW_EXTENSION));
  std::size_t drawn = 0;
  std::string last;
  for (int i = 0; i < 100; ++i) {
    fresh.begin(0.1 * i);
    const std::string layer = "t = " + std::to_string(i);
    regista_shape shape{};
    shape.size = sizeof shape;
    shape.shape = REGISTA_SHAPE_POINTS;
    shape.layer = layer.c_str();
    shape.points = many.data();
    shape.count = 1;
    table.draw(table.context, &shape);
    drawn += fresh.drawings().shapes().size();
    for (const LogLine& each : fresh.log().lines()) last = each.text;
  }
  EXPECT_EQ(drawn, std::size_t{REGISTA_DRAW_MOST_LAYERS});
  EXPECT_EQ(last, "draw: layer t = 32: more than 32 layers in one match; it is left out");
}

TEST_F(ExtensionsTest, NothingIsKeptWhereNobodyRecords) {
  Extensions fresh(caller);
  const InstanceExtensions& given = fresh.open(plugin, of_team);
  const auto& table = *static_cast<const regista_draw*>(given.find(REGISTA_DRAW_EXTENSION));
  EXPECT_EQ(table.wanted(table.context), 0);
  EXPECT_EQ(draw().wanted(draw().context), 1);
  const auto& write = *static_cast<const regista_log*>(given.find(REGISTA_LOG_EXTENSION));
  write.write(write.context, REGISTA_LOG_INFO, "x", 1);
  EXPECT_TRUE(fresh.log().lines().empty());
}

TEST_F(ExtensionsTest, ReportsBecomeOneSummaryOfEachMetric) {
  report(0, 1.0);
  report(1, 7.0);
  report(0, -2.0);
  report(0, 0.5);
  std::vector<MetricReport> out;
  extensions.metrics().take(out);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].metric, 2);
  EXPECT_EQ(out[0].greatest, 7.0);
  EXPECT_EQ(out[1].metric, 4);
  EXPECT_EQ(out[1].count, 3u);
  EXPECT_EQ(out[1].sum, -0.5);
  EXPECT_EQ(out[1].least, -2.0);
  EXPECT_EQ(out[1].greatest, 1.0);
  EXPECT_EQ(out[1].last, 0.5);
  extensions.metrics().take(out);
  EXPECT_TRUE(out.empty());
  EXPECT_FALSE(extensions.metrics().violation());
}

TEST_F(ExtensionsTest, AReportThatBreaksAPromiseNamesTheMetric) {
  const auto said = [&](std::uint32_t metric, double value) {
    MetricReports fresh;
    fresh.report(plugin, of_team, 0, metric, value);
    return fresh.violation() ? fresh.violation()->what : "";
  };
  EXPECT_EQ(said(1, 1e9), "");
  EXPECT_EQ(said(1, std::nan("")), "reported nan as metric \"reach\"");
  EXPECT_EQ(said(0, -std::numeric_limits<double>::infinity()), "reported -inf as metric \"hits\"");
  EXPECT_EQ(said(0, 1.1e9), "reported 1100000000 as metric \"hits\"");
  EXPECT_EQ(said(2, 1.0), "reported metric number 2; it declares 2, counted from 0");
}

TEST_F(ExtensionsTest, WhatIsDoneForRecordersDoesNotCount) {
  own();
  extensions.mute(true);
  say("x");
  polygon("cells", {{0, 0}});
  report(0, 1.0);
  extensions.mute(false);
  std::vector<MetricReport> out;
  extensions.metrics().take(out);
  EXPECT_TRUE(out.empty());
  EXPECT_EQ(lines(), Lines());
  EXPECT_TRUE(extensions.drawings().shapes().empty());
}

}  // namespace
}  // namespace regista::mind
