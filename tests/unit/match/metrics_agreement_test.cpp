// SPDX-License-Identifier: MIT
// Agreement, step by step, of three robots whose samples can be counted.
#include "match/metrics_coordination.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace regista::match {
namespace {

constexpr std::uint32_t everybody = 0b111;

struct Agreement : testing::Test {
  AgreementMeasures measures{3, 70};  // more roles than a word has bits

  void decide(int number, int context, std::vector<int> kept) { measures.decided(number, context, kept); }
  void sample(int times, std::uint32_t active = everybody, bool same_assignment = false) {
    for (int i = 0; i < times; ++i) measures.sample(active, same_assignment);
  }
};

TEST_F(Agreement, OfNoSamplesThereIsNone) {
  sample(3, 0b010);
  sample(3, 0);
  const AgreementMetrics result = measures.result();
  EXPECT_EQ(result.context, std::nullopt) << "who is alone agrees with nobody";
  EXPECT_EQ(result.kept_tasks, std::nullopt);
  EXPECT_EQ(result.assignment_given_tasks, std::nullopt);
}

TEST_F(Agreement, WhoHasDecidedNothingAgreesOnThat) {
  sample(1);
  EXPECT_EQ(measures.result().context, 1.0);
  EXPECT_EQ(measures.result().kept_tasks, 1.0);
  EXPECT_EQ(measures.result().assignment_given_tasks, 0.0);
}

TEST_F(Agreement, OnTheContext) {
  for (int number = 1; number <= 3; ++number) decide(number, 1, {});
  sample(6);
  decide(3, 0, {});
  sample(2);
  EXPECT_DOUBLE_EQ(*measures.result().context, 6.0 / 8.0);
  sample(2, 0b011);
  EXPECT_DOUBLE_EQ(*measures.result().context, 8.0 / 10.0) << "the third one is penalised";
  sample(2, 0b101);
  EXPECT_DOUBLE_EQ(*measures.result().context, 8.0 / 12.0);
  decide(1, -1, {});
  sample(4, 0b011);
  EXPECT_DOUBLE_EQ(*measures.result().context, 8.0 / 16.0) << "none is none of them";
}

TEST_F(Agreement, OnTheKeptTasksAsSets) {
  decide(1, 0, {0, 3, 69});
  decide(2, 0, {69, 0, 3});
  decide(3, 0, {0, 3, 69});
  sample(4);
  EXPECT_EQ(measures.result().kept_tasks, 1.0);
  decide(2, 0, {0, 3});
  sample(4);
  EXPECT_EQ(measures.result().kept_tasks, 0.5) << "the far one is missing";
  decide(2, 0, {0, 3, 5});
  sample(4);
  EXPECT_DOUBLE_EQ(*measures.result().kept_tasks, 4.0 / 12.0) << "5 is not 69";
  sample(4, 0b101);
  EXPECT_DOUBLE_EQ(*measures.result().kept_tasks, 8.0 / 16.0);
  EXPECT_EQ(measures.result().context, 1.0);
}

TEST_F(Agreement, OnTheAssignmentCountsWhereTheTasksAreTheSame) {
  for (int number = 1; number <= 3; ++number) decide(number, 0, {1, 2});
  sample(3, everybody, true);
  sample(1, everybody, false);
  decide(1, 0, {1, 3});
  sample(4, everybody, false);
  sample(4, everybody, true);
  EXPECT_DOUBLE_EQ(*measures.result().assignment_given_tasks, 3.0 / 4.0);
  EXPECT_DOUBLE_EQ(*measures.result().kept_tasks, 4.0 / 12.0);
}

TEST(AgreementWithoutRoles, IsOnTheContextAlone) {
  AgreementMeasures measures(2, 0);
  measures.decided(1, 0, {});
  measures.decided(2, 1, {});
  measures.sample(0b11, true);
  EXPECT_EQ(measures.result().context, 0.0);
  EXPECT_EQ(measures.result().kept_tasks, 1.0);
}

}  // namespace
}  // namespace regista::match
