// SPDX-License-Identifier: MIT
#include "recording/field_svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace regista::recording::picture {
namespace {

constexpr Area page{0.0, 0.0, 600.0, 400.0};

Area area_of(const WantedLabel& label, const PlacedLabel& at) {
  return {at.x - label.width / 2.0, at.y - label.height / 2.0, at.x + label.width / 2.0, at.y + label.height / 2.0};
}

bool meet(const Area& a, const Area& b) {
  constexpr double rounding = 1e-9;
  return a.left + rounding < b.right && b.left + rounding < a.right && a.top + rounding < b.bottom &&
         b.top + rounding < a.bottom;
}

TEST(Labels, ALonelyOneIsBelowItsObject) {
  const std::vector<WantedLabel> one{{200.0, 150.0, 10.0, 60.0, 12.0}};
  const auto placed = place_labels(one, {}, page);
  ASSERT_TRUE(placed[0]);
  EXPECT_EQ(placed[0]->x, 200.0);
  EXPECT_EQ(placed[0]->y, 150.0 + 10.0 + 3.0 + 6.0);
}

TEST(Labels, NoneCoversAnotherOrABodyOrLeavesThePicture) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0.0, 600.0), y(0.0, 400.0), width(20.0, 110.0);
  int far = 0, missing = 0;
  for (int picture = 0; picture < 200; ++picture) {
    std::vector<WantedLabel> labels;
    std::vector<Area> bodies;
    for (std::size_t i = 0; i < 22; ++i) {
      labels.push_back({x(random), y(random), 9.0, width(random), 12.0, i % 3 != 0});
      bodies.push_back({labels[i].x - 9.0, labels[i].y - 9.0, labels[i].x + 9.0, labels[i].y + 9.0});
    }
    const auto placed = place_labels(labels, bodies, page);
    ASSERT_EQ(placed.size(), labels.size());
    std::vector<Area> full = bodies;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (!placed[i]) {
        ++missing;
        continue;
      }
      far += placed[i]->far ? 1 : 0;
      EXPECT_TRUE(labels[i].far || !placed[i]->far);
      const Area area = area_of(labels[i], *placed[i]);
      EXPECT_TRUE(area.left >= -1e-9 && area.top >= -1e-9 && area.right <= 600.0 + 1e-9 && area.bottom <= 400.0 + 1e-9);
      for (const Area& other : full) EXPECT_FALSE(meet(area, other));
      full.push_back(area);
    }
  }
  EXPECT_GT(far, 100) << "crowded pictures need lines";
  EXPECT_LT(missing, 200 * 22 / 20);
}

TEST(Labels, OfOneCrowdTheFirstChooses) {
  const std::vector<WantedLabel> same(20, {300.0, 200.0, 30.0, 10.0, 10.0, false});
  const auto placed = place_labels(same, {}, page);
  EXPECT_TRUE(placed[0] && !placed[0]->far);
  EXPECT_EQ(std::ranges::count_if(placed, [](const auto& each) { return !each; }), 20 - 8)
      << "eight places are near; the others are left out";
}

TEST(Labels, TheEdgeOfThePicturePushesThemAside) {
  const std::vector<WantedLabel> one{{4.0, 150.0, 10.0, 60.0, 12.0}};
  const auto placed = place_labels(one, {}, page);
  ASSERT_TRUE(placed[0]);
  EXPECT_EQ(placed[0]->x, 30.0);
}

}  // namespace
}  // namespace regista::recording::picture
