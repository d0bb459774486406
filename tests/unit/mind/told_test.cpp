// SPDX-License-Identifier: MIT
// delta for one packet: what is continued, what is born, what is left out and why.
#include "mind/world/fusion.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace regista::mind {
namespace {

regista_track track(int label, double x, double y, double age = 0.0, double deviation = 0.3, double weight = 0.9) {
  regista_track out{};
  out.label = label;
  out.x = x;
  out.y = y;
  out.age = age;
  out.weight = weight;
  out.covariance[0] = out.covariance[2] = deviation * deviation;
  return out;
}

// At the centre, looking ahead; it tells what it has seen in the last four seconds.
SenderView sender(bool tells_all = true) { return {{0.0, 0.0, 0.0}, 0.5 * pi, 4.0, 0.6, 4.0, tells_all}; }

std::vector<regista_track> merged(const std::vector<regista_track>& known, const std::vector<regista_track>& told,
                                  const SenderView& view = sender()) {
  std::vector<regista_track> out;
  merge_told(known, told, view, out);
  std::ranges::sort(out, {}, &regista_track::label);
  return out;
}

TEST(MergeTold, ATrackThatIsToldAgainIsReplacedAndKeepsItsLabel) {
  const auto out = merged({track(7, 1.0, 1.0, 9.0, 0.8)}, {track(1, 1.5, 1.2, 0.5, 0.1)});
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].label, 7);
  EXPECT_EQ(out[0].x, 1.5);
  EXPECT_EQ(out[0].age, 0.5);
  EXPECT_EQ(out[0].covariance[0], 0.1 * 0.1) << "not surer than the packet: both rest on the same sightings";
}

TEST(MergeTold, WhatIsNewIsBornWithALabelOfItsOwn) {
  const auto out = merged({track(3, -3.0, 0.0, 9.0)}, {track(3, 3.0, 0.0), track(4, 3.0, 2.5)});
  ASSERT_EQ(out.size(), 3u);
  EXPECT_EQ(out[0].label, 3);
  EXPECT_EQ(out[0].x, -3.0) << "behind the sender, and older than what it tells: kept";
  EXPECT_EQ(out[1].x, 3.0);
  EXPECT_NE(out[1].label, out[2].label);
}

TEST(MergeTold, AnEmptyPacketErasesNothingThatItsSenderCannotHaveSeen) {
  for (const regista_track& known : {track(1, -2.0, 0.0, 6.0), track(1, 4.5, 0.0, 6.0)}) {
    const auto out = merged({known}, {});
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].weight, known.weight);
  }
}

TEST(MergeTold, WhatTheSenderMayHaveLookedForInVainIsLessLikely) {
  const auto out = merged({track(1, 2.0, 1.0, 6.0)}, {});
  ASSERT_EQ(out.size(), 1u);
  EXPECT_NEAR(out[0].weight, 0.9 * 0.4 / (0.9 * 0.4 + 0.1), 1e-12) << "Bayes: missed with probability 0.4 if it exists";
  std::vector<regista_track> known{track(1, 2.0, 1.0, 6.0)};
  int packets = 0;
  for (; !known.empty() && packets < 50; ++packets) known = merged(known, {});
  EXPECT_LT(packets, 10);
}

TEST(MergeTold, WhatItWouldHaveToldIsGone) {
  EXPECT_TRUE(merged({track(1, -2.0, 0.0, 3.0)}, {}).empty()) << "seen 3 s ago, and the sender does not believe it now";
  EXPECT_EQ(merged({track(1, -2.0, 0.0, 3.0)}, {}, sender(false)).size(), 1u) << "unless there was no room for it";
  EXPECT_EQ(merged({track(1, 2.0, 1.0, 6.0)}, {}, sender(false))[0].weight, 0.9);
}

TEST(MergeTold, TheNearestPairIsOneRobot) {
  // Both told tracks are within the gate of both known ones.
  const auto out = merged({track(1, 0.0, 0.0, 9.0, 1.0), track(2, 1.5, 0.0, 9.0, 1.0)},
                          {track(1, 1.4, 0.0, 0.0, 0.5), track(2, 0.2, 0.0, 0.0, 0.5)});
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].x, 0.2);
  EXPECT_EQ(out[1].x, 1.4);
}

TEST(MergeTold, AKnownTrackBesideAToldOneIsTheSameRobot) {
  // Too far apart for the gate, as both are sharp, but no two robots stand like that.
  EXPECT_EQ(merged({track(1, 2.0, 0.0, 9.0, 0.05)}, {track(1, 2.8, 0.0, 0.0, 0.05)}).size(), 1u);
}

}  // namespace
}  // namespace regista::mind
