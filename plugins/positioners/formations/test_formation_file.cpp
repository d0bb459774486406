// SPDX-License-Identifier: MIT
// Broken, empty, huge and foreign files: each refused in one line that says where and what. And the triangulation of
// samples that mirror each other, are on one line, or only one.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "formation.hpp"
#include "formation_file.hpp"
#include "role_numbers.hpp"

namespace {

using namespace formations;

std::string refusal(std::string_view bytes) {
  try {
    read_formation(bytes);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "read";
}

std::string file(const std::string& method, const std::string& data) {
  return "{\"method\": \"" + method + "\", \"data\": [" + data + "]}";
}

std::string sample(double x, double y, int positions = 2) {
  std::string out = "{\"ball\": {\"x\": " + std::to_string(x) + ", \"y\": " + std::to_string(y) + "}";
  for (int n = 1; n <= positions; ++n)
    out += ", \"" + std::to_string(n) + "\": {\"x\": " + std::to_string(n) + ", \"y\": 1}";
  return out + "}";
}

TEST(FormationFile, Sound) {
  const std::vector<Sample> samples =
      read_formation(file("DelaunayTriangulation", sample(1, 2) + "," + sample(-3.25, 0.5)));
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[1].ball, (GridPoint{-32500, -5000}));
  EXPECT_EQ(samples[0].positions, (std::vector<Position>{{1.0, -1.0}, {2.0, -1.0}}));
}

TEST(FormationFile, Refused) {
  EXPECT_EQ(refusal(""), "formation: the file is empty; expected a formation file of librcsc");
  EXPECT_EQ(refusal(" \n"), "formation: the file is empty; expected a formation file of librcsc");
  EXPECT_EQ(
      refusal("{\n \"method\": ?}"),
      "formation: line 2, column 12: not JSON; expected a formation file of librcsc, in JSON or as text that begins "
      "with \"Formation\"");
  EXPECT_EQ(refusal("[[1, 2]]"), "formation: the file is no object");
  EXPECT_EQ(refusal("{\"vectors\": []}"), "formation: the file has no \"method\"");
  EXPECT_EQ(refusal(file("Delaunay", sample(0, 0))),
            "formation: line 1, column 12: its method is \"Delaunay\"; read are DelaunayTriangulation and Static");
  EXPECT_EQ(refusal("{\"method\": \"Static\"}"), "formation: the file has no \"data\"");
  EXPECT_EQ(refusal(file("Static", "")), "formation: \"data\" holds no samples");
  EXPECT_EQ(refusal(file("Static", sample(0, 0) + "," + sample(1, 0))), "formation: is static but has 2 samples");
  EXPECT_EQ(refusal(file("Static", sample(0, 0, 0))), "formation: data[0] has no position \"1\"");
  EXPECT_EQ(refusal(file("DelaunayTriangulation", sample(0, 0) + "," + sample(1, 0, 1))),
            "formation: data[1] has no \"2\"");
  EXPECT_EQ(refusal(file("DelaunayTriangulation", sample(0, 0) + "," + sample(1, 0, 3))),
            "formation: data[1] has more positions than data[0], which has 2");
  EXPECT_EQ(refusal(file("DelaunayTriangulation", sample(0, 0) + "," + sample(1, 0) + "," + sample(0, 0))),
            "formation: data[0] and data[2] have the ball at the same place");
  EXPECT_EQ(refusal(file("Static", "{\"1\": {\"x\": 0, \"y\": 0}}")), "formation: data[0] has no \"ball\"");
  EXPECT_EQ(refusal(file("Static", "{\"ball\": {\"x\": 0, \"y\": 0}, \"1\": {\"x\": \"0\", \"y\": 0}}")),
            "formation: data[0].1: x is no number");
  EXPECT_EQ(refusal(file("Static", sample(0, 1e300))),
            "formation: data[0].ball: y is farther than 1000 m from the centre");
  EXPECT_EQ(refusal("{\"method\": \"Static\", \"role\": [{}], \"data\": [" + sample(0, 0) + "]}"),
            "formation: \"role\" names 1 positions, data[0] has 2");
}

TEST(FormationFile, Huge) {
  EXPECT_EQ(refusal(std::string(5'000'000, '[')), "formation: has 5000000 bytes; at most 4000000 are read");
  EXPECT_NE(refusal(std::string(3'900'000, '[')).find("not JSON"), std::string::npos);
  EXPECT_EQ(refusal(std::string(1'900'000, '[') + std::string(1'900'000, ']')), "formation: the file is no object");
  std::string many;
  for (int i = 0; i <= 1000; ++i) {
    if (i > 0) many += ",";
    many += sample(0.1 * i, 0.0);
  }
  EXPECT_EQ(refusal(file("DelaunayTriangulation", many)), "formation: has 1001 samples; at most 1000 are read");
}

// One cut of a sound file after the other: never anything but a refusal.
TEST(FormationFile, Truncated) {
  const std::string sound = file("DelaunayTriangulation", sample(1, 2) + "," + sample(-3.25, 0.5));
  for (std::size_t length = 0; length < sound.size(); ++length) {
    EXPECT_EQ(refusal(sound.substr(0, length)).rfind("formation: ", 0), 0u) << length;
  }
}

// Of four samples on an empty circle, the first three make a triangle.
TEST(Triangulation, TheOrderDecidesOnACircle) {
  const GridPoint corner[] = {{-2, -1}, {2, -1}, {1, 1}, {-1, 1}};
  std::vector<int> order{0, 1, 2, 3};
  do {
    std::vector<GridPoint> points;
    for (const int i : order) points.push_back(corner[i]);
    const Triangulation t = triangulate(points);
    ASSERT_EQ(t.triangles.size(), 2u);
    bool first_three = false;
    for (const auto& triangle : t.triangles) {
      first_three = first_three || triangle.corner[0] + triangle.corner[1] + triangle.corner[2] == 0 + 1 + 2;
    }
    EXPECT_TRUE(first_three);
    EXPECT_EQ(t.border.size(), 4u);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Triangulation, AGridOfCirclesIsCoveredOnce) {
  std::vector<GridPoint> points;
  for (std::int64_t k = 0; k < 49; ++k) points.push_back({(k * 5) % 49 / 7, (k * 5) % 49 % 7});
  const Triangulation t = triangulate(points);
  EXPECT_EQ(t.triangles.size(), 2u * 36u);
  EXPECT_EQ(t.border.size(), 24u);
  for (const auto& triangle : t.triangles) {
    const GridPoint &a = points[static_cast<std::size_t>(triangle.corner[0])],
                    &b = points[static_cast<std::size_t>(triangle.corner[1])],
                    &c = points[static_cast<std::size_t>(triangle.corner[2])];
    EXPECT_EQ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 1);
  }
}

TEST(FormationOf, OneSampleTwoAndALine) {
  const std::vector<Sample> one{{{0, 0}, {{1.0, 2.0}}}};
  const std::vector<Sample> line{{{10'000, 0}, {{1.0, 2.0}}}, {{-10'000, 0}, {{3.0, 2.0}}}, {{0, 0}, {{2.0, 8.0}}}};
  for (const Beyond beyond : {Beyond::nearest_point, Beyond::nearest_sample}) {
    const Formation only(one, 1.0, 1.0, beyond);
    EXPECT_EQ(only.position(only.shares({5.0, -3.0}), 0), (Position{1.0, 2.0}));
    const Formation row(line, 1.0, 1.0, beyond);
    EXPECT_EQ(row.position(row.shares({-7.0, 3.0}), 0), (Position{3.0, 2.0}));
    EXPECT_EQ(row.position(row.shares({0.0, 0.0}), 0), (Position{2.0, 8.0}));
  }
  const Formation row(line, 1.0, 1.0, Beyond::nearest_point);
  EXPECT_EQ(row.position(row.shares({0.5, 1.0}), 0), (Position{1.5, 5.0}));
}

// --- Roles ---------------------------------------------------------------------------------------------------------

const std::vector<Role> roles{{"goalkeeper", "playing", 0}, {"striker", "playing", 1}, {"goalkeeper", "searching", 0}};

std::string refused_roles(std::string_view text, std::size_t positions, std::size_t team_size) {
  try {
    role_numbers(text, roles, positions, team_size);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "read";
}

TEST(RoleNumbers, ByNameByListAndByImportance) {
  EXPECT_EQ(role_numbers("", roles, 11, 7), (std::vector<int>{0, 10, 0}));
  EXPECT_EQ(role_numbers("", roles, 3, 3), (std::vector<int>{0, 1, 0}));
  EXPECT_EQ(role_numbers("striker: 9, searching/goalkeeper: 2\ngoalkeeper: 1 # both", roles, 11, 22),
            (std::vector<int>{0, 8, 1}));
  EXPECT_EQ(role_numbers("striker: 9", roles, 11, 7), (std::vector<int>{no_position, 8, no_position}));
}

TEST(RoleNumbers, Refused) {
  EXPECT_EQ(refused_roles("goalkeper: 1", 11, 7),
            "roles: line 1: no role \"goalkeper\"; the nearest is \"goalkeeper\"");
  EXPECT_EQ(refused_roles("goalkeeper: 1,\nplayin/striker: 2", 11, 7),
            "roles: line 2: no role \"playin/striker\"; the nearest is \"playing/striker\"");
  EXPECT_EQ(refused_roles("striker: 12", 11, 7), "roles: line 1: striker: no position 12; the formation has 1 to 11");
  EXPECT_EQ(refused_roles("striker: 1.5", 11, 7), "roles: line 1: striker: no position 1.5; the formation has 1 to 11");
  EXPECT_EQ(refused_roles("striker: nan", 11, 7), "roles: line 1: striker: \"nan\" is not a number");
  EXPECT_EQ(refused_roles("striker: 1 2", 11, 7), "roles: line 1: striker: \"2\" is too much");
  EXPECT_EQ(refused_roles("striker", 11, 7), "roles: line 1: \"striker\" has no colon; an entry is \"role: value\"");
  EXPECT_EQ(refused_roles("striker: 1, striker: 2", 11, 7), "roles: line 1: \"striker\" stands twice");
  EXPECT_EQ(refused_roles("", 11, 12),
            "formation: has 11 positions, but the team has 12 robots; name in `roles` which role takes which position");
  EXPECT_EQ(refused_roles("", 1, 1),
            "formation: has 1 positions, but there is none for the role \"striker\", number 2 of the list \"playing\"; "
            "name in `roles` which role takes which position");
}

}  // namespace
