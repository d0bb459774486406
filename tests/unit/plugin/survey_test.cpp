// SPDX-License-Identifier: MIT
// Files are looked at in another process: this one hears what they declare, and has loaded none of them.
#include "plugin/shared_object.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "process/sanitized.hpp"
#include "scene.hpp"

namespace regista::plugin::test {
namespace {

fs::path when_opened(const std::string& does) {
  return fs::path(TEST_PLUGINS) / ("when_opened_" + does) / (does + ".so");
}

bool is_loaded(const fs::path& file) { return ::dlopen(file.c_str(), RTLD_NOLOAD | RTLD_LAZY | RTLD_LOCAL) != nullptr; }

std::vector<std::string> ids(const ScannedFile& surveyed) {
  std::vector<std::string> out;
  for (const auto& each : surveyed.plugins) out.emplace_back(each->declared().id);
  return out;
}

TEST(Survey, TellsWhatFilesDeclareAndLoadsNone) {
  // Not one that another test of this process may have loaded.
  const std::vector<fs::path> files{when_opened("nothing"), shared_object("sound")};
  const std::vector<ScannedFile> found = scan_files(files);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(ids(found[0]), (std::vector<std::string>{"nothing"}));
  EXPECT_FALSE(is_loaded(files[0]));
  const SharedObject here = open_shared_object(files[1]);
  ASSERT_EQ(found[1].plugins.size(), here.descriptors.size());
  for (std::size_t i = 0; i < here.descriptors.size(); ++i) {
    EXPECT_STREQ(found[1].plugins[i]->declared().id, here.descriptors[i]->id);
    EXPECT_EQ(found[1].plugins[i]->declared().parameter_count, here.descriptors[i]->parameter_count);
  }
  EXPECT_EQ(found[0].refusal + found[0].remark + found[1].refusal + found[1].remark, "");
}

TEST(Survey, NoFiles) { EXPECT_TRUE(scan_files({}).empty()); }

TEST(Survey, RefusesAsOpeningDoes) {
  const Folder folder;
  std::ofstream(folder / "text.so") << "no plugin\n";
  for (const fs::path& file : {folder / "text.so", folder / "nothing.so", shared_object("wrong_major"),
                               shared_object("no_entry"), shared_object("missing_library")}) {
    const std::vector<fs::path> files{file};
    const ScannedFile found = scan_files(files).front();
    EXPECT_TRUE(found.plugins.empty()) << file;
    EXPECT_FALSE(found.refusal.empty()) << file;
    EXPECT_EQ(found.refusal, open_shared_object(file).refusal) << file;
  }
}

// Each between sound ones, which are found all the same, whatever comes before them.
TEST(Survey, WhoHarmsIsNamedAndNobodyElse) {
  const std::string crash =
      sanitized ? "ended the process when it was opened (exit code 1)" : "died when it was opened: Segmentation fault";
  const std::vector<std::pair<std::string, std::string>> harmful{
      {"crash", crash},
      {"leave", "ended the process when it was opened (exit code 0)"},
      {"start_a_thread", "starts a thread when it is opened"}};
  std::vector<fs::path> files{when_opened("nothing")};
  for (const auto& [does, refusal] : harmful) {
    files.push_back(when_opened(does));
    files.push_back(shared_object("sound"));
  }
  const std::vector<ScannedFile> found = scan_files(files);
  ASSERT_EQ(found.size(), 7u);
  for (std::size_t i = 0; i < harmful.size(); ++i) {
    EXPECT_EQ(found[2 * i + 1].refusal, harmful[i].second) << harmful[i].first;
    EXPECT_TRUE(found[2 * i + 1].plugins.empty());
    EXPECT_EQ(found[2 * i + 2].refusal, "");
    EXPECT_EQ(ids(found[2 * i + 2]).size(), 2u);
  }
  EXPECT_EQ(ids(found[0]).size(), 1u);
}

TEST(Survey, NobodyWaitsTwiceForAFileThatSleeps) {
  const auto began = std::chrono::steady_clock::now();
  const std::vector<fs::path> files{shared_object("sound"), when_opened("sleep_on"), when_opened("nothing")};
  const std::vector<ScannedFile> found = scan_files(files);
  EXPECT_EQ(found[1].refusal, "slept for 2 s when it was opened");
  EXPECT_EQ(ids(found[0]).size(), 2u);
  EXPECT_EQ(ids(found[2]).size(), 1u);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(4));
}

TEST(Survey, RemarksOnArithmeticThatWasChanged) {
  const std::vector<fs::path> files{when_opened("flush_small_numbers"), when_opened("nothing")};
  const std::vector<ScannedFile> found = scan_files(files);
  EXPECT_NE(found[0].remark.find("when it was opened; that was undone"), std::string::npos) << found[0].remark;
  EXPECT_EQ(found[0].refusal, "");
  EXPECT_EQ(ids(found[0]).size(), 1u);
  EXPECT_EQ(found[1].remark, "");
}

}  // namespace
}  // namespace regista::plugin::test
