// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

class PositionerTest : public PuppetTest {
 protected:
  void SetUp() override {
    PuppetTest::SetUp();
    written = {};
    written.points = {{0, 0, 1, -1, 0}, {1, 0, 1, -1, 0}, {0, 1, 1, -1, 0}, {4.5, 3, 1, -1, 0}};
    written.edges = {{0, 1}, {1, 2}};
    written.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    written.cells = {{3, 0, 4}};
  }

  template <class T>
  static void fill(regista_room& room, const std::vector<T>& from) {
    EXPECT_EQ(room.count, 0u);
    EXPECT_EQ(room.stride, sizeof(T));
    room.count = static_cast<std::uint32_t>(from.size());
    std::copy(from.begin(), from.end(), static_cast<T*>(room.data));
  }

  // Runs a plugin that hands back `written`.
  std::string run() {
    Puppet::positioner.place = [](void*, const regista_frame*, regista_placement* to, regista_error*) {
      fill(to->points, written.points);
      fill(to->edges, written.edges);
      fill(to->cells, written.cells);
      fill(to->vertices, written.vertices);
      return Puppet::ok;
    };
    return message_of([&] { Positioner(Puppet::instance()).place(scene.frame, out); });
  }

  static inline Placement written;
  Scene scene{2};
  Placement out;
};

TEST_F(PositionerTest, HandsBackWhatThePluginWrote) {
  EXPECT_EQ(run(), "");
  ASSERT_EQ(out.points.size(), 4u);
  EXPECT_EQ(out.points[3].x, 4.5);
  EXPECT_EQ(out.edges.size(), 2u);
  EXPECT_EQ(out.cells.size(), 1u);
  EXPECT_EQ(out.vertices.size(), 4u);
}

TEST_F(PositionerTest, ReplacesWhatWasThere) {
  out.points.resize(9);
  out.edges.resize(9);
  written = {};
  EXPECT_EQ(run(), "");
  EXPECT_TRUE(out.points.empty());
  EXPECT_TRUE(out.edges.empty());
}

TEST_F(PositionerTest, AllocatesNothingOnceTheOutputHasGrown) {
  EXPECT_EQ(run(), "");
  const auto* const points = out.points.data();
  const auto* const vertices = out.vertices.data();
  EXPECT_EQ(run(), "");
  EXPECT_EQ(out.points.data(), points);
  EXPECT_EQ(out.vertices.data(), vertices);
}

TEST_F(PositionerTest, TakesPointsOfTheBorderStripAndNoneBeyond) {
  written.points[3] = {5.2, -3.7, 1, -1, 0};
  EXPECT_EQ(run(), "");
  written.points[3] = {7.1, 0, 1, -1, 0};
  EXPECT_EQ(run(), Puppet::failure("place: point 3 at (7.1, 0) is outside the field"));
  written.points[3] = {0, -3.75, 1, -1, 0};
  EXPECT_EQ(run(), Puppet::failure("place: point 3 at (0, -3.75) is outside the field"));
  written.points[3] = {std::numeric_limits<double>::quiet_NaN(), 0, 1, -1, 0};
  EXPECT_EQ(run(), Puppet::failure("place: point 3 at (nan, 0) is outside the field"));
}

TEST_F(PositionerTest, RefusesScoresTasksAndRobotsThatCannotBe) {
  written.points[1].score = -1.0;
  EXPECT_EQ(run(), Puppet::failure("place: score of point 1 is -1; scores are finite and at least 0"));
  written.points[1].score = std::numeric_limits<double>::infinity();
  EXPECT_EQ(run(), Puppet::failure("place: score of point 1 is inf; scores are finite and at least 0"));
  written.points[1] = {1, 0, 1, 1, 5};
  EXPECT_EQ(run(), "");
  written.points[1] = {1, 0, 1, 2, 0};
  EXPECT_EQ(run(), Puppet::failure("place: point 1 belongs to task 2 of 2"));
  written.points[1] = {1, 0, 1, -2, 0};
  EXPECT_EQ(run(), Puppet::failure("place: point 1 belongs to task -2 of 2"));
  written.points[1] = {1, 0, 1, -1, 6};
  EXPECT_EQ(run(), Puppet::failure("place: point 1 belongs to robot 6 of 5"));
}

TEST_F(PositionerTest, RefusesEdgesOfPointsThatDoNotExist) {
  written.edges[1] = {1, 4};
  EXPECT_EQ(run(), Puppet::failure("place: edge 1 joins points 1 and 4 of 4"));
  written.edges[1] = {2, 2};
  EXPECT_EQ(run(), Puppet::failure("place: edge 1 joins point 2 to itself"));
  written.edges[1] = {1, 0};
  EXPECT_EQ(run(), Puppet::failure("place: edge 1 joins points 1 and 0 a second time"));
}

TEST_F(PositionerTest, RefusesCellsThatCannotBe) {
  written.cells[0].robot = 0;
  EXPECT_EQ(run(), Puppet::failure("place: cell 0 belongs to robot 0 of 5"));
  written.cells[0] = {3, 1, 4};
  EXPECT_EQ(run(), Puppet::failure("place: cell 0 has 4 vertices from 1 on, but there are 4"));
  written.cells[0] = {3, 2, std::numeric_limits<std::uint32_t>::max()};
  EXPECT_EQ(run(), Puppet::failure("place: cell 0 has 4294967295 vertices from 2 on, but there are 4"));
  written.cells[0] = {3, 0, 4};
  std::swap(written.vertices[1], written.vertices[3]);
  EXPECT_EQ(run(), Puppet::failure("place: cell 0 runs clockwise"));
  written.vertices[2].y = std::numeric_limits<double>::infinity();
  EXPECT_EQ(run(), Puppet::failure("place: vertex 2 is at (1, inf)"));
}

TEST_F(PositionerTest, RefusesCountsBeyondTheBuffers) {
  Puppet::positioner.place = [](void*, const regista_frame*, regista_placement* to, regista_error*) {
    to->edges.count = to->edges.capacity + 1;
    return Puppet::ok;
  };
  EXPECT_EQ(message_of([&] { Positioner(Puppet::instance()).place(scene.frame, out); }),
            Puppet::failure("place: wrote 769 edges into room for 768"));
}

TEST_F(PositionerTest, ReportsSharedObjectsByTheirFile) {
  const auto run_file = [&](const std::string& name, const config::Node& params = {}) {
    Positioner positioner(instance_of(open(name), 0, params));
    return message_of([&] { positioner.place(scene.frame, out); });
  };
  EXPECT_EQ(run_file("returns_nan"), failure("returns_nan", "place: point 0 at (1, nan) is outside the field"));
  EXPECT_EQ(run_file("index_out_of_range"), failure("index_out_of_range", "place: point 0 belongs to task 2 of 2"));
  EXPECT_EQ(run_file("index_out_of_range", map({{"edge", scalar("true")}})),
            failure("index_out_of_range", "place: edge 0 joins points 0 and 5 of 1"));
  EXPECT_EQ(run_file("throws"), failure("throws", "place: fell in place"));
}

}  // namespace
}  // namespace regista::plugin::test
