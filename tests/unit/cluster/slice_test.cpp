// SPDX-License-Identifier: MIT
// What a task asks the engine for, as far as that can be seen without a match: of what is in its part already nothing
// is played.
#include "cluster/task.hpp"

#include <gmock/gmock.h>

#include <set>

#include "study_of_two_rounds.hpp"

namespace regista::cluster {
namespace {

class SliceTest : public FolderTest {
 protected:
  campaign::Store part{folder / "part.db", campaign::Store::Mode::create, "1.0", campaign::Journal::rollback};
  campaign::Store known{folder / "known.db", campaign::Store::Mode::create, "1.0", campaign::Journal::rollback};
};

TEST_F(SliceTest, LooksAtItsOwnPlacesAlone) {
  const std::int64_t fixture = part.add(std::vector<campaign::Fixture>{{"one", {}}}).front();
  for (const std::int64_t row : {1, 2, 5}) part.insert(row, {fixture, static_cast<std::uint64_t>(row - 1)}, match(), 1);
  TwoRounds study;
  SliceOrder order;
  order.slices = {{0, 2}, {4, 5}};
  std::vector<TaskProgress> steps;
  order.progressed = [&](const TaskProgress& progress) { steps.push_back(progress); };
  order.job = [](campaign::Job job, std::uint64_t) {
    ADD_FAILURE() << "a match is to be played";
    return job;
  };
  EXPECT_EQ(play_slice(study, known, part, order), campaign::Finish::complete);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps.back().done, 3u);
  EXPECT_EQ(steps.back().all, 3u);
  EXPECT_EQ(steps.back().fresh, 0u);
  EXPECT_TRUE(steps.back().ended);
  EXPECT_FALSE(steps.front().ended);
}

TEST_F(SliceTest, OfALaterRoundNeedsTheEarlierOnes) {
  TwoRounds study;
  SliceOrder order;
  order.first_row = 6;
  order.slices = {{0, 1}};
  EXPECT_THROW(play_slice(study, known, part, order), study::StudyError);
  const std::int64_t fixture = known.add(std::vector<campaign::Fixture>{{"one", {}}}).front();
  for (std::int64_t row = 1; row <= 6; ++row)
    known.insert(row, {fixture, static_cast<std::uint64_t>(row - 1)}, match(), 1);
  part.insert(7, {part.add(std::vector<campaign::Fixture>{{"two", {}}}).front(), 600}, match(), 1);
  TwoRounds again;
  EXPECT_EQ(play_slice(again, known, part, order), campaign::Finish::complete);
}

TEST_F(SliceTest, BeyondTheRoundIsRefused) {
  TwoRounds study;
  SliceOrder order;
  order.slices = {{5, 7}};
  EXPECT_THROW(play_slice(study, known, part, order), study::StudyError);
}

}  // namespace
}  // namespace regista::cluster
