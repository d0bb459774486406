// SPDX-License-Identifier: MIT
// What tasks leave behind, as it comes into the study's results.
#include "cluster/study_folder.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <optional>
#include <stdexcept>

#include "study_of_two_rounds.hpp"

namespace regista::cluster {
namespace {

using campaign::Store;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Parts : public FolderTest {
 protected:
  Parts() {
    study.create({});
    results.emplace(study.results(), Store::Mode::create, "1.0", campaign::Journal::rollback);
    results->set_meta("schedule", "{}");
    results->add(fixtures);
  }

  Store part(const TaskName& name, std::int64_t row, bool ended = true) {
    Store out(ended ? study.part(name) : study.under_way(name), Store::Mode::create, "1.0",
              campaign::Journal::rollback);
    out.set_meta("schedule", "{}");
    out.insert(row, {out.add(fixtures).front(), static_cast<std::uint64_t>(row)}, match(), 1);
    write_progress(study, name, {1, 1, 1, 0, 2.5, ended, "node1"});
    return out;
  }
  std::vector<std::string> names(const std::filesystem::path& in) const {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(in)) out.push_back(entry.path().filename());
    return out;
  }

  StudyFolder study{folder / "study"};
  std::vector<campaign::Fixture> fixtures{{"one", {}}};
  std::optional<Store> results;
};

TEST_F(Parts, AreTakenOverAndRemovedAlsoOfTasksThatWereKilled) {
  part({1, 0}, 1);
  part({1, 12}, 2, false);
  EXPECT_EQ(task_progress(study).size(), 2u);
  const Gathered out = gather(study, *results, Tasks::killed_too);
  EXPECT_EQ(out.rows, 2u);
  EXPECT_THAT(out.remarks, IsEmpty());
  EXPECT_THAT(names(study.parts()), IsEmpty());
  EXPECT_THAT(task_progress(study), IsEmpty());
  EXPECT_EQ(results->rows(), 2);
}

TEST_F(Parts, ThatATaskMayGoOnWithStayWithIt) {
  part({1, 0}, 1, false);
  part({1, 1}, 2);
  EXPECT_EQ(gather(study, *results, Tasks::ended).rows, 1u);
  EXPECT_THAT(names(study.parts()), testing::UnorderedElementsAre("1-0.db.part", "1-0.txt"));
}

TEST_F(Parts, OfATaskThatPlaysStayWithIt) {
  const Store playing = part({1, 0}, 1, false);
  const Gathered out = gather(study, *results, Tasks::killed_too);
  EXPECT_EQ(out.rows, 0u);
  EXPECT_EQ(task_progress(study).size(), 1u);
  EXPECT_TRUE(std::filesystem::exists(study.under_way({1, 0})));
  ASSERT_EQ(out.remarks.size(), 1u);
  EXPECT_EQ(out.remarks[0], "1-0.db.part: a task that should have ended still holds it; it is taken later");
  EXPECT_TRUE(gather(study, *results, Tasks::ended).remarks.empty());
}

TEST_F(Parts, ThatAreNoneAreSetAsideAndNamed) {
  std::ofstream(study.part({1, 0})) << "nothing of ours";
  part({1, 1}, 1).set_meta("schedule", "of another study");
  part({1, 2}, 2);
  const Gathered out = gather(study, *results, Tasks::killed_too);
  EXPECT_EQ(out.rows, 1u);
  EXPECT_EQ(out.refused, 1u);
  ASSERT_EQ(out.remarks.size(), 2u);
  EXPECT_THAT(out.remarks[0], HasSubstr("1-0.db: cannot be read, so that its matches are missing"));
  EXPECT_EQ(out.remarks[1], "1-1.db: these are results of another study");
  EXPECT_EQ(names(study.set_aside()).size(), 2u);
}

TEST_F(Parts, NodesThatRefuseAreNamedOnce) {
  write_refusal(study, {1, 0}, "node7", "its program is another");
  write_refusal(study, {1, 1}, "node7", "its program is another");
  const Gathered out = gather(study, *results, Tasks::killed_too);
  EXPECT_THAT(out.refused_nodes, ElementsAre("node7"));
  EXPECT_EQ(out.remarks.front(), "node node7 plays nothing: its program is another");
  EXPECT_THAT(gather(study, *results, Tasks::killed_too).remarks, IsEmpty());
}

TEST_F(Parts, TheCourseOfATaskComesBackFromItsFile) {
  EXPECT_EQ(progress_from_json(to_json(TaskProgress{3, 9, 2, 1, 4.5, false, "n"})).fresh, 2u);
  EXPECT_THROW(progress_from_json("{}"), std::invalid_argument);
  std::ofstream(study.progress({1, 0})) << "half a li";
  EXPECT_THAT(task_progress(study), IsEmpty());
}

TEST_F(Parts, TheFolderKnowsItself) {
  Progress progress = study.progress();
  progress.state = Progress::State::stopped;
  progress.batches.push_back({1, 2, 3, 4, "17", "18"});
  progress.finding = "nothing yet";
  progress.refused_nodes = {"node7"};
  study.write(progress);
  EXPECT_EQ(study.progress().state, Progress::State::stopped);
  EXPECT_EQ(study.progress().batches.front().gather_job, "18");
  EXPECT_EQ(study.progress().batches.front().rows_before, 4u);
  EXPECT_EQ(study.progress().finding, "nothing yet");
  EXPECT_EQ(study.settings().tasks, Settings().tasks);
  EXPECT_THROW(study.create({}), std::runtime_error);
  EXPECT_THROW(StudyFolder(folder).settings(), std::runtime_error);
}

}  // namespace
}  // namespace regista::cluster
