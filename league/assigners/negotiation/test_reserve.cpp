// SPDX-License-Identifier: MIT
// When the reserve is reached, and who has which role then, however much a robot knows of the others.
#include "reserve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/recording_host.hpp>

namespace {

using namespace regista::testkit;
using Rows = std::vector<std::int32_t>;

struct Kept {
  RecordingHost host;
  Setting setting;
  negotiation::Reserve reserve;
  explicit Kept(int stop_negotiating_at,
                const EnvironmentBuilder& environment = EnvironmentBuilder{}.roles(usual_roles()))
      : setting(environment.build()) {
    reserve.setup(setting.environment(), regista::Host(host.raw()), stop_negotiating_at);
  }
  bool is_reached_with(int packets, double share = 1.0) {
    host.budget.packets_left = packets;
    host.budget.share = share;
    return reserve.is_reached();
  }
  Rows by_rank(const Scene& scene, const Matrix& utilities) {
    Rows out(utilities.rows(), -7);
    reserve.assign_by_rank(regista::Frame(scene.raw()), regista::UtilityMatrix(utilities.raw()),
                           regista::Assignment(out.data(), out.size()));
    return out;
  }
};

TEST(Reserve, IsReachedWhenNoMorePacketsAreLeft) {
  Kept kept(30);
  EXPECT_FALSE(kept.is_reached_with(1200));
  EXPECT_FALSE(kept.is_reached_with(31));
  EXPECT_TRUE(kept.is_reached_with(30));
  EXPECT_TRUE(kept.is_reached_with(0));
  EXPECT_FALSE(kept.is_reached_with(9, 0.25));  // a quarter of 30, and some remain some
  EXPECT_TRUE(kept.is_reached_with(8, 0.25));
  Kept spends_all(0);
  EXPECT_FALSE(spends_all.is_reached_with(1));
  EXPECT_TRUE(spends_all.is_reached_with(0));
  EXPECT_FALSE(Kept(-1).is_reached_with(0, 0.5));
}

TEST(Reserve, WithoutABudgetThereIsNone) {
  Kept kept(30);
  regista_host old = *kept.host.raw();
  old.extension = nullptr;
  negotiation::Reserve reserve;
  reserve.setup(kept.setting.environment(), regista::Host(&old), 30);
  kept.host.budget.packets_left = 0;
  EXPECT_FALSE(reserve.is_reached());
}

// Tasks in this order of columns; the striker's is the most important, then the supporter's, then the jolly's.
FrameBuilder scene() {
  FrameBuilder frame;
  frame.own(2).robot(1).robot(2).robot(4);
  frame.robot(3).penalised().robot(5).penalised().robot(6).penalised().robot(7).penalised();
  frame.task("jolly").priority(2).task("striker").priority(0).task("supporter").priority(1);
  return frame;
}

TEST(Reserve, RolesGoByRank) {
  Kept kept(30);
  EXPECT_EQ(kept.by_rank(scene().build(), Matrix(3, 3)), (Rows{1, 2, 0}));
  Matrix utilities(3, 3);
  utilities(0, 1) = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(kept.by_rank(scene().build(), utilities), (Rows{2, 1, 0}));
  EXPECT_EQ(kept.by_rank(FrameBuilder{}.own(2).robot(1).robot(2).build(), Matrix(2, 0)), (Rows{-1, -1}));
}

TEST(Reserve, WhoIsGivenUpKeepsItsRank) {
  Kept kept(30);
  EXPECT_EQ(kept.by_rank(scene().robot(1).inactive().build(), Matrix(2, 3)), (Rows{2, 0}));
  EXPECT_EQ(kept.by_rank(scene().robot(1).penalised().build(), Matrix(2, 3)), (Rows{1, 2}));
}

// A robot that has a role of its own takes no other one, and its role is not among the tasks while it is given up.
TEST(Reserve, WhoHasARoleOfItsOwnHasNoOther) {
  EnvironmentBuilder environment;
  environment.roles({}).role("goalkeeper", 1).role("striker").role("supporter").role("searcher", 0, "searching");
  Kept kept(30, environment);
  const auto with = [](bool goalkeeper) {
    FrameBuilder frame;
    frame.roles({"goalkeeper", "striker", "supporter", "searcher"}).team_size(3).own(3);
    if (goalkeeper) frame.robot(1);
    frame.robot(2).robot(3);
    if (goalkeeper) frame.task("goalkeeper").only_for(1);
    return frame.task("striker").priority(1).task("supporter").priority(2).build();
  };
  Matrix all(3, 3);
  for (const auto& [row, column] : {std::pair{0, 1}, {0, 2}, {1, 0}, {2, 0}}) {
    all(static_cast<std::size_t>(row), static_cast<std::size_t>(column)) = -std::numeric_limits<double>::infinity();
  }
  EXPECT_EQ(kept.by_rank(with(true), all), (Rows{0, 1, 2}));
  EXPECT_EQ(kept.by_rank(with(false), Matrix(2, 2)), (Rows{0, 1}));
  // In the other list it searches like all.
  FrameBuilder searching;
  searching.roles({"goalkeeper", "striker", "supporter", "searcher"}).team_size(3).own(3).robot(2).robot(3);
  EXPECT_EQ(kept.by_rank(searching.task("searcher").build(), Matrix(2, 1)), (Rows{-1, -1}));
}

}  // namespace
