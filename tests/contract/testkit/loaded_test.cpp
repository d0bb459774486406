// SPDX-License-Identifier: MIT
// Opening plugins, giving them values, calling them, and the mailbox.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regista/testkit/corners.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

namespace {

using namespace regista::testkit;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const char* file, const char* id) {
  try {
    Loaded(file, id);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Loaded, SaysWhyItCannotOpen) {
  EXPECT_THAT(refusal("/nowhere/x.so", "x"), HasSubstr("/nowhere/x.so: cannot open shared object file"));
  EXPECT_THAT(refusal(CONTRACT_NO_ENTRY, "x"), HasSubstr("exports no regista_plugin_entry"));
  EXPECT_THAT(refusal(CONTRACT_OTHER_MAJOR, "other_major"), HasSubstr("built for plugin interface 2.0"));
  EXPECT_THAT(refusal(CONTRACT_OTHER_MAJOR, "endless"), HasSubstr("its descriptors do not end"));
  EXPECT_THAT(refusal(CONTRACT_GOOD, "nearest"),
              HasSubstr("no plugin \"nearest\" in it; it has: first_free, nearness, ball_seen, at_the_ball"));
}

TEST(Values, StartAsDeclaredAndAreSetByName) {
  const Loaded plugin(CONTRACT_GOOD, "everything");
  Values values(plugin);
  EXPECT_EQ(values.raw().at(0).number, 1.5);
  EXPECT_EQ(values.raw().at(3).number, 1.0);
  EXPECT_STREQ(values.raw().at(4).text, "hello");
  EXPECT_EQ(values.raw().at(5).text, nullptr);
  values.set("reach", 0.5).set("form", "square").set("map", std::string_view("a\0b", 3));
  const std::vector<regista_value> raw = values.raw();
  EXPECT_EQ(raw.at(0).number, 0.5);
  EXPECT_EQ(raw.at(3).number, 0.0);
  EXPECT_EQ(std::string(raw.at(5).text, raw.at(5).text_size), std::string("a\0b", 3));
  EXPECT_THROW(values.set("raech", 1.0), std::logic_error);
  EXPECT_THROW(values.set("form", "oval"), std::logic_error);
}

TEST(Values, ReachThePlugin) {
  const Loaded plugin(CONTRACT_GOOD, "everything");
  const Scene scene = FrameBuilder{}.own(1).robot(1).task(0).task(1).task(2).task(3).task(4).task(5).build();
  Instance instance(plugin, EnvironmentBuilder{}.own(1),
                    Values(plugin).set("reach", 0.5).set("map", std::string_view("a\0b", 3)).set("deep", true));
  const Matrix seen = instance.score(scene);
  EXPECT_EQ(seen(0, 0), 0.5);
  EXPECT_EQ(seen(0, 1), 2.0);
  EXPECT_EQ(seen(0, 2), 1.0);
  EXPECT_EQ(seen(0, 3), 1.0);
  EXPECT_EQ(seen(0, 4), 5.0);
  EXPECT_EQ(seen(0, 5), 3.0);
}

TEST(Corners, AreAllOfASmallBoxAndEveryWord) {
  const Loaded plugin(CONTRACT_GOOD, "everything");
  std::vector<std::string> names;
  for (const Corner& corner : corners(plugin, Values(plugin))) names.push_back(corner.name);
  EXPECT_THAT(names,
              ElementsAre("defaults", "all low", "all high", "high: reach", "high: depth", "deep = false, others low",
                          "deep = false, others high", "deep = true", "deep = true, others low",
                          "deep = true, others high", "form = square", "form = square, others low",
                          "form = square, others high", "form = round, others low", "form = round, others high"));
  for (const Corner& corner : corners(plugin, Values(plugin))) {
    if (corner.name != "high: depth") continue;
    EXPECT_EQ(corner.values.number(0), 0.0);
    EXPECT_EQ(corner.values.number(1), 4.0);
  }
}

TEST(Corners, OfALargeBoxAreEachEndAlone) {
  const Loaded plugin(CONTRACT_GOOD, "seven_numbers");
  const std::vector<Corner> all = corners(plugin, Values(plugin));
  ASSERT_EQ(all.size(), 3u + 2u * 7u);
  for (const Corner& corner : all) {
    int moved = 0;
    for (std::size_t i = 0; i < 7; ++i) moved += corner.values.number(i) != 1.0 ? 1 : 0;
    EXPECT_EQ(moved, corner.name == "defaults" ? 0 : corner.name.substr(0, 3) == "all" ? 7 : 1) << corner.name;
  }
}

TEST(Instance, ThrowsWhatThePluginSaid) {
  EXPECT_THROW(Instance(Loaded(CONTRACT_GOOD, "talker"), EnvironmentBuilder{}.own(9)), CallFailed);
  Instance utility(Loaded(CONTRACT_GOOD, "nearness"), EnvironmentBuilder{});
  EXPECT_THROW((void)utility.holds(FrameBuilder{}.build()), std::logic_error);
}

TEST(Host, TakesWhatAnInstanceLogsDrawsAndReports) {
  static constexpr regista_metric hits{sizeof hits, REGISTA_METRIC_SUM, "hits", "1", "How often"};
  static constexpr regista_metrics declared{sizeof declared, 1, &hits, sizeof hits, 0};
  regista_descriptor plugin{};
  plugin.extension = [](const char*) -> const void* { return &declared; };
  RecordingHost host;
  host.set_metrics(plugin);
  const auto table = [&](const char* id) { return host.raw()->extension(host.raw()->context, id); };
  EXPECT_EQ(table("nobody.has_this/0"), nullptr);
  const auto& log = *static_cast<const regista_log*>(table(REGISTA_LOG_EXTENSION));
  log.write(log.context, REGISTA_LOG_WARNING, "hello", 4);
  ASSERT_EQ(host.log.size(), 1u);
  EXPECT_EQ(host.log[0].text, "hell");
  const auto& reports = *static_cast<const regista_metric_reports*>(table(REGISTA_METRIC_EXTENSION));
  reports.report(reports.context, 0, 2.5);
  EXPECT_EQ(host.reports.size(), 1u);
  EXPECT_EQ(host.take_broken(), "");
  reports.report(reports.context, 1, 2.5);
  EXPECT_EQ(host.take_broken(), "reported metric 1 of 1");
  EXPECT_EQ(host.take_broken(), "");
  reports.report(reports.context, 0, std::nan(""));
  EXPECT_EQ(host.take_broken(), "reported nan as metric 0");

  const auto& draw = *static_cast<const regista_draw*>(table(REGISTA_DRAW_EXTENSION));
  const regista_point nowhere{0.0, std::nan("")};
  regista_shape shape{};
  shape.size = sizeof shape;
  shape.shape = REGISTA_SHAPE_POINTS;
  shape.layer = "cells";
  shape.points = &nowhere;
  shape.count = 1;
  draw.draw(draw.context, &shape);
  EXPECT_EQ(host.take_broken(), "drew in layer cells a point that is nowhere");
  shape.count = 1'000'000'000;
  draw.draw(draw.context, &shape);
  EXPECT_EQ(host.take_broken(), "drew in layer cells a shape of 1000000000 points");
  EXPECT_EQ(host.shapes, 2u);
}

TEST(Mailbox, OffersAreRecordedAndMessagesArrive) {
  Instance talker(Loaded(CONTRACT_GOOD, "talker"), EnvironmentBuilder{}.own(4));
  const Scene scene = FrameBuilder{}.own(4).robot(4).robot(5).task(0).build();
  (void)talker.assign(scene, Matrix(2, 1));
  ASSERT_EQ(talker.host().offers.size(), 1u);
  const RecordingHost::Offered first = talker.host().offers[0];
  EXPECT_THAT(first.bytes, ElementsAre(4, 0));
  EXPECT_EQ(first.urgency, 0.5);
  EXPECT_EQ(first.replaces, 0u);
  talker.transmitted(first.handle);
  const std::uint8_t word[] = {9, 9, 9};
  talker.receive(2, word, 1.0, 1.2);
  (void)talker.assign(scene, Matrix(2, 1));  // tells how many bytes it heard
  ASSERT_EQ(talker.host().offers.size(), 2u);
  EXPECT_THAT(talker.host().offers[1].bytes, ElementsAre(4, 3));
  EXPECT_EQ(talker.host().offers[1].replaces, 0u);
  (void)talker.assign(scene, Matrix(2, 1));
  EXPECT_EQ(talker.host().offers[2].replaces, talker.host().offers[1].handle);
  talker.host().set_bytes_free(1);
  (void)talker.assign(scene, Matrix(2, 1));
  EXPECT_EQ(talker.host().offers.size(), 3u);
  EXPECT_EQ(talker.host().refused, 1u);
}

}  // namespace
