// SPDX-License-Identifier: MIT
// Which drawings a recording tells, and when.
#include "recording/plugin_records.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace regista::recording {
namespace {

using match::Side;

mind::DrawnShape dot(const char* layer, double x, const char* plugin = "voronoi") {
  mind::DrawnShape out;
  out.plugin = plugin;
  out.layer = layer;
  out.shape = REGISTA_SHAPE_POINTS;
  out.points = {{x, 0.5}};
  return out;
}

class DrawnLayersTest : public testing::Test {
 protected:
  // "layer: shapes" of what is told, one after the other.
  std::string told(double time, const std::vector<mind::DrawnShape>& shapes, double direction = 1.0, int robot = 3,
                   Side side = Side::home) {
    std::string out;
    for (const DrawnLayers::Change& each : layers.follow(side, robot, time, shapes, direction)) {
      out += std::string(each.layer) + ": " + std::string(each.shapes) + '\n';
    }
    return out;
  }
  DrawnLayers layers;
};

TEST_F(DrawnLayersTest, ALayerIsToldWhenItAppearsAndWhenItIsEmpty) {
  EXPECT_EQ(told(0.0, {}), "");
  EXPECT_EQ(told(0.1, {dot("a", 1.0)}), "a: [{\"shape\":\"points\",\"at\":[[1,0.5]]}]\n");
  EXPECT_EQ(told(0.2, {dot("a", 1.0)}), "") << "it is still there";
  EXPECT_EQ(told(0.8, {}), "a: []\n");
  EXPECT_EQ(told(0.9, {}), "");
  EXPECT_EQ(told(1.0, {dot("a", 2.0)}), "") << "half a second has not passed";
  EXPECT_EQ(told(1.3, {dot("a", 2.0)}), "a: [{\"shape\":\"points\",\"at\":[[2,0.5]]}]\n");
}

TEST_F(DrawnLayersTest, OneThatMovesIsToldTwiceASecond) {
  int times = 0;
  for (int i = 0; i <= 100; ++i) times += told(0.1 * i, {dot("a", 0.1 * i)}).empty() ? 0 : 1;
  EXPECT_EQ(times, 21);
  EXPECT_EQ(told(10.5, {dot("a", 10.0)}), "") << "as it was told";
}

TEST_F(DrawnLayersTest, LayersRobotsAndPluginsAreApart) {
  EXPECT_EQ(told(0.0, {dot("a", 1.0), dot("b", 2.0), dot("a", 3.0)}),
            "a: [{\"shape\":\"points\",\"at\":[[1,0.5]]},{\"shape\":\"points\",\"at\":[[3,0.5]]}]\n"
            "b: [{\"shape\":\"points\",\"at\":[[2,0.5]]}]\n");
  EXPECT_EQ(told(0.0, {dot("a", 1.0)}, 1.0, 4), "a: [{\"shape\":\"points\",\"at\":[[1,0.5]]}]\n");
  EXPECT_EQ(told(0.6, {dot("a", 1.0), dot("b", 2.0), dot("a", 3.0), dot("a", 9.0, "other")}),
            "a: [{\"shape\":\"points\",\"at\":[[9,0.5]]}]\n");
}

TEST_F(DrawnLayersTest, TheWorldFrameIsThatOfTheFirstHalf) {
  EXPECT_EQ(told(0.0, {dot("a", 1.0)}, -1.0), "a: [{\"shape\":\"points\",\"at\":[[-1,-0.5]]}]\n");
}

TEST_F(DrawnLayersTest, AShapeSaysWhatWasChosen) {
  mind::DrawnShape shape = dot("a", 1.0);
  shape.shape = REGISTA_SHAPE_POLYGON;
  shape.filled = true;
  shape.colour = 0x0E69F00Fu;
  shape.width = 0.05;
  mind::DrawnShape text = dot("a", 2.0);
  text.shape = REGISTA_SHAPE_TEXT;
  text.text = "\"x\"";
  EXPECT_EQ(told(0.0, {shape, text}),
            "a: [{\"shape\":\"polygon\",\"at\":[[1,0.5]],\"colour\":\"#0e69f00f\",\"width\":0.05,\"filled\":true},"
            "{\"shape\":\"text\",\"at\":[[2,0.5]],\"text\":\"\\\"x\\\"\"}]\n");
}

}  // namespace
}  // namespace regista::recording
