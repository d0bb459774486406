// SPDX-License-Identifier: MIT
// The measures of coordination on courses that can be counted by hand.
#include "match/metrics_coordination.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <random>
#include <vector>

namespace regista::match {
namespace {

const std::vector<Role> table{{"goalkeeper", "playing", 0, {1}},
                              {"striker", "playing", 1},
                              {"supporter", "playing", 2},
                              {"libero", "playing", 3},
                              {"searcher", "searching", 0}};
constexpr std::uint32_t everybody = 0b111;

struct Coordination : testing::Test {
  RoleMeasures measures{3, table};

  void decide(int number, int role, std::vector<int> assignment = {}) {
    measures.decided(number, role, assignment, true);
  }
  void sample(int times, std::uint32_t active = everybody) {
    for (int i = 0; i < times; ++i) measures.sample(active);
  }
  RoleMetrics role(std::size_t row, double end = 0.0) const { return measures.result(end).roles[row]; }
};

TEST_F(Coordination, CountsOverlapAndWhatIsUncovered) {
  decide(1, 0);
  decide(2, 1);
  decide(3, 1);
  sample(10);
  EXPECT_EQ(role(1).all.overlap_seconds, 1.0);
  EXPECT_EQ(role(2).all.uncovered_seconds, 1.0);
  EXPECT_EQ(role(3).all.uncovered_seconds, 0.0) << "three robots need not cover a fourth role";
  EXPECT_EQ(role(4).all.uncovered_seconds, 0.0) << "of a list that is not in force";
  EXPECT_EQ(role(1).robot_seconds, (std::vector{0.0, 1.0, 1.0}));
  decide(3, 2);
  sample(5);
  EXPECT_EQ(role(1).all.overlap_seconds, 1.0);
  EXPECT_EQ(role(2).all.uncovered_seconds, 1.0);
  EXPECT_EQ(role(1).robot_seconds, (std::vector{0.0, 1.5, 1.0}));
}

TEST_F(Coordination, PenalisedRobotsHoldNothingAndWantNothing) {
  decide(1, 0);
  decide(2, 1);
  decide(3, 1);
  sample(10, 0b110);
  EXPECT_EQ(role(0).all.uncovered_seconds, 0.0) << "bound to a robot that cannot take it";
  EXPECT_EQ(role(2).all.uncovered_seconds, 0.0) << "only two robots";
  EXPECT_EQ(role(1).all.overlap_seconds, 1.0);
  sample(10, 0b001);
  EXPECT_EQ(role(1).all.overlap_seconds, 1.0);
  sample(10, 0);
  EXPECT_EQ(role(0).all.uncovered_seconds, 0.0) << "nobody is there to want anything";
}

TEST(CoordinationOfFew, OneOfTheRobotsOfARoleIsEnoughToWantIt) {
  const std::vector<Role> roles{{"goalkeeper", "playing", 0, {1, 2, 99}, 2}, {"striker", "playing", 1}};
  RoleMeasures measures(3, roles);
  measures.decided(3, 1, {}, true);
  const auto uncovered_after = [&](std::uint32_t active) {
    const double before = measures.result(0.0).roles[0].all.uncovered_seconds;
    for (int i = 0; i < 10; ++i) measures.sample(active);
    return measures.result(0.0).roles[0].all.uncovered_seconds - before;
  };
  EXPECT_EQ(uncovered_after(0b111), 1.0);
  EXPECT_EQ(uncovered_after(0b110), 1.0) << "the second robot";
  EXPECT_EQ(uncovered_after(0b100), 0.0) << "one robot is too few, and none of those that may take it";
}

TEST_F(Coordination, CountsRolesTaken) {
  decide(2, 1);
  decide(2, 1);
  decide(2, 2);
  decide(2, 1);
  decide(2, -1);
  decide(2, 1);
  EXPECT_EQ(role(1).all.switches, 3);
  EXPECT_EQ(role(2).all.switches, 1);
  measures.decided(2, 3, {}, false);
  EXPECT_EQ(role(3).all.switches, 0) << "not in play";
  decide(2, 3);
  EXPECT_EQ(role(3).all.switches, 0) << "it has had it since before play";
}

TEST_F(Coordination, AgreementIsTheShareOfEqualAssignments) {
  for (int number = 1; number <= 3; ++number) decide(number, -1, {0, 1, 2});
  sample(6);
  decide(3, -1, {0, 2, 1});
  sample(2);
  EXPECT_DOUBLE_EQ(measures.result(0.8).agreement.value(), 6.0 / 8.0);
  sample(2, 0b011);
  EXPECT_DOUBLE_EQ(measures.result(1.0).agreement.value(), 8.0 / 10.0);
  sample(5, 0b100);
  sample(5, 0);
  EXPECT_DOUBLE_EQ(measures.result(2.0).agreement.value(), 8.0 / 10.0) << "one robot has nobody to agree with";
}

TEST_F(Coordination, ARoleIsUnplayedWhenMostBelieveThatSomebodyElsePlaysIt) {
  decide(1, 0, {0, 3, 2});
  decide(2, 1, {0, 1, 3});
  decide(3, 1, {0, 2, 1});
  sample(10);
  EXPECT_EQ(role(3).all.unplayed_seconds, 1.0) << "two of three give it to somebody";
  EXPECT_EQ(role(2).all.unplayed_seconds, 1.0);
  EXPECT_EQ(role(1).all.unplayed_seconds, 0.0) << "it is held";
  EXPECT_EQ(role(4).all.unplayed_seconds, 0.0) << "nobody thinks of it";
  decide(3, 1, {0, -1, 1});
  sample(10);
  EXPECT_EQ(role(2).all.unplayed_seconds, 1.0) << "one of three is not most";
  EXPECT_EQ(role(3).all.unplayed_seconds, 2.0);
  decide(3, 3, {0, 1, 3});
  sample(10);
  EXPECT_EQ(role(3).all.unplayed_seconds, 2.0) << "now it is held";
  // Of a negotiated assignment that gives a role to two.
  decide(1, 0, {0, 2, 2});
  sample(10);
  EXPECT_EQ(role(2).all.unplayed_seconds, 1.0);
}

TEST_F(Coordination, HalfOfTheRobotsAreNotMost) {
  decide(1, 0, {0, 2, 1});
  decide(2, 1, {0, 1, -1});
  sample(10, 0b011);
  EXPECT_EQ(role(2).all.unplayed_seconds, 0.0) << "one of two";
  decide(2, 1, {0, 1, 2});
  sample(10, 0b011);
  EXPECT_EQ(role(2).all.unplayed_seconds, 1.0) << "both";
}

// A match of 100 s in samples: overlap all the time, a packet after 30 s and the last one after 60 s.
TEST_F(Coordination, SilenceBeginsWithTheLastPacketAndDividesEverything) {
  decide(2, 1, {0, 1, 2});
  decide(3, 1, {0, 1, 2});
  decide(1, 0, {0, 1, 2});
  sample(300);
  measures.sent(30.0);
  sample(300);
  decide(1, 2, {0, 1, 2});
  measures.sent(60.0);
  decide(1, 0, {2, 1, 0});
  decide(1, 2, {2, 1, 0});
  sample(250);
  const auto not_silent = measures.result(85.0);
  EXPECT_EQ(not_silent.silent_seconds, 0.0) << "25 s are not more than 25 s";
  EXPECT_EQ(not_silent.roles[1].before_silence.overlap_seconds, 85.0);
  EXPECT_EQ(not_silent.roles[1].after_silence.overlap_seconds, 0.0);
  EXPECT_EQ(not_silent.agreement_after_silence, std::nullopt);
  sample(150);
  const auto silent = measures.result(100.0);
  EXPECT_EQ(silent.silent_seconds, 40.0);
  EXPECT_EQ(silent.roles[1].all.overlap_seconds, 100.0);
  EXPECT_EQ(silent.roles[1].before_silence.overlap_seconds, 60.0);
  EXPECT_EQ(silent.roles[1].after_silence.overlap_seconds, 40.0);
  EXPECT_EQ(silent.roles[2].before_silence.uncovered_seconds, 60.0);
  EXPECT_EQ(silent.roles[2].after_silence.uncovered_seconds, 0.0);
  EXPECT_EQ(silent.roles[0].after_silence.uncovered_seconds, 40.0);
  EXPECT_EQ(silent.roles[2].before_silence.switches, 1);
  EXPECT_EQ(silent.roles[2].after_silence.switches, 1);
  EXPECT_EQ(silent.roles[0].after_silence.switches, 1);
  EXPECT_DOUBLE_EQ(*silent.agreement_before_silence, 1.0);
  EXPECT_DOUBLE_EQ(*silent.agreement_after_silence, 0.0);
}

TEST_F(Coordination, ATeamThatNeverSendsIsSilentFromTheBeginning) {
  decide(2, 1);
  decide(3, 1);
  sample(300);
  const auto all = measures.result(30.0);
  EXPECT_EQ(all.silent_seconds, 30.0);
  EXPECT_EQ(all.roles[1].after_silence.overlap_seconds, 30.0);
  EXPECT_EQ(all.agreement_before_silence, std::nullopt);
  EXPECT_EQ(measures.result(20.0).silent_seconds, 0.0);
}

// Against the definitions, with the whole course in memory: what came before the last packet is before the silence.
TEST_F(Coordination, ARandomCourseAddsUpAsItsDefinitionsSay) {
  std::mt19937 random(7);
  const auto below = [&random](std::uint32_t n) { return static_cast<int>(random() % n); };
  struct Moment {
    std::vector<int> held;
    std::uint32_t active;
  };
  std::vector<Moment> course;
  std::vector<int> held(3, -1);
  std::size_t sent_after = 0;
  for (int i = 0; i < 2000; ++i) {
    const int number = 1 + below(3);
    held[static_cast<std::size_t>(number - 1)] = below(6) - 1;
    decide(number, held[static_cast<std::size_t>(number - 1)]);
    const auto active = static_cast<std::uint32_t>(below(8));
    measures.sample(active);
    course.push_back({held, active});
    if (i < 1500 && below(100) == 0) {
      measures.sent(0.1 * (i + 1));
      sent_after = course.size();
    }
  }
  const auto result = measures.result(200.0);
  ASSERT_GT(sent_after, 1000u);
  EXPECT_DOUBLE_EQ(result.silent_seconds, static_cast<double>(2000 - sent_after) / 10.0);
  for (int role = 0; role < 5; ++role) {
    std::map<bool, int> overlap;
    for (std::size_t i = 0; i < course.size(); ++i) {
      int holders = 0;
      for (std::size_t robot = 0; robot < 3; ++robot) {
        if (course[i].held[robot] == role && (course[i].active >> robot & 1u) != 0) ++holders;
      }
      if (holders >= 2) ++overlap[i >= sent_after];
    }
    const RoleMetrics& metrics = result.roles[static_cast<std::size_t>(role)];
    EXPECT_DOUBLE_EQ(metrics.before_silence.overlap_seconds, overlap[false] / 10.0);
    EXPECT_DOUBLE_EQ(metrics.after_silence.overlap_seconds, overlap[true] / 10.0);
    EXPECT_EQ(metrics.all.switches, metrics.before_silence.switches + metrics.after_silence.switches);
  }
}

TEST(CoordinationOfNobody, HasNoRolesAndNoDisagreement) {
  RoleMeasures measures(3, {});
  measures.sample(everybody);
  const auto result = measures.result(0.1);
  EXPECT_TRUE(result.roles.empty());
  EXPECT_EQ(result.agreement, 1.0);
  EXPECT_EQ(RoleMeasures(3, table).result(0.0).agreement, std::nullopt) << "no samples";
  RoleMeasures alone(3, table);
  alone.sample(0b010);
  EXPECT_EQ(alone.result(0.1).agreement, std::nullopt);
  EXPECT_EQ(alone.result(0.1).agreement_after_silence, std::nullopt);
  EXPECT_EQ(alone.result(0.1).silent_seconds, 0.0);
}

}  // namespace
}  // namespace regista::match
