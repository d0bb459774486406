// SPDX-License-Identifier: MIT
// Names of new plugins, and the filling-in of their templates.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "cli/command_line.hpp"
#include "output/new_plugin.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(NewName, MayBeWhatAnIdMayBe) {
  for (const char* name : {"a", "my_ball", "x2", "a__b_", "null", "int", "tests"})
    EXPECT_EQ(output::wrong_with_new_name(name), "") << name;
  EXPECT_EQ(output::wrong_with_new_name(std::string(64, 'a')), "");
}

TEST(NewName, IsRefusedWithTheReason) {
  EXPECT_THAT(output::wrong_with_new_name(""), HasSubstr("needs a name"));
  EXPECT_THAT(output::wrong_with_new_name(std::string(65, 'a')),
              HasSubstr("is 65 characters long; at most 64 are taken"));
  for (const char* name : {"2x", "_x", "Ball", "a-b", "-x", "a b", "../x", "a/b", "a.b", ".", "é", "a\n"})
    EXPECT_THAT(output::wrong_with_new_name(name), HasSubstr("is not lower_snake_case")) << name;
  EXPECT_THAT(output::wrong_with_new_name("a\nb"), testing::Not(HasSubstr("\n")));
}

TEST(NewName, IsNoTargetOfTheBuild) {
  for (const char* name : {"all", "clean", "help", "install", "package", "test"})
    EXPECT_THAT(output::wrong_with_new_name(name), HasSubstr("CMake has a target")) << name;
  EXPECT_THAT(output::wrong_with_new_name("m"), HasSubstr("system library"));
  EXPECT_THAT(output::wrong_with_new_name("regista_testkit"), HasSubstr("Regista's CMake package"));
}

TEST(FilledIn, PutsValuesInThePlaceOfPlaceholders) {
  const output::PlaceholderValues values{{"NAME", "x"}, {"A_B", "@NAME@ and @"}};
  EXPECT_EQ(output::filled_in("", values), "");
  EXPECT_EQ(output::filled_in("@NAME@", values), "x");
  EXPECT_EQ(output::filled_in("a @NAME@@NAME@\n", values), "a xx\n");
  EXPECT_EQ(output::filled_in("@A_B@", values), "@NAME@ and @") << "a value is left as it is";
}

TEST(FilledIn, LeavesWhatIsNoPlaceholder) {
  const output::PlaceholderValues values{{"NAME", "x"}};
  for (const char* text : {"@", "@@", "me@here", "@name@", "@NAME", "NAME@", "@NA ME@"})
    EXPECT_EQ(output::filled_in(text, values), text);
  EXPECT_EQ(output::filled_in("@@NAME@@", values), "@x@");
}

TEST(FilledIn, RefusesAPlaceholderThatNobodyKnows) {
  try {
    output::filled_in("@NAMES@", {{"KIND", ""}, {"NAME", ""}});
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_STREQ(error.what(), "template: unknown placeholder \"NAMES\"; nearest: \"NAME\"; known: KIND, NAME");
  }
}

class Templates : public testing::Test {
 protected:
  Templates() { fs::remove_all(folder_); }
  ~Templates() override { fs::remove_all(folder_); }
  void write(const fs::path& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  const fs::path folder_ = fs::path(testing::TempDir()) / "regista_templates";
};

TEST_F(Templates, AreFilesOfFourFolders) {
  write("shared/README.md", "@NAME@");
  write("shared/c++/CMakeLists.txt", "");
  write("shared/c/other", "");
  write("sender/team.yaml", "sender: @NAME@");
  write("sender/c++/plugin.cpp", "");
  write("utility/team.yaml", "");
  const auto files = output::files_from_template(folder_, "sender", "c++", {{"NAME", "x"}});
  ASSERT_EQ(files.size(), 4u);
  EXPECT_EQ(files[0].name, "CMakeLists.txt");
  EXPECT_EQ(files[1].name, "README.md");
  EXPECT_EQ(files[1].bytes, "x");
  EXPECT_EQ(files[2].name, "plugin.cpp");
  EXPECT_EQ(files[3].name, "team.yaml");
  EXPECT_EQ(files[3].bytes, "sender: x");
}

TEST_F(Templates, AreMissedByName) {
  write("shared/README.md", "");
  try {
    output::files_from_template(folder_, "sender", "c++", {});
    FAIL();
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("shared/c++: No such file or directory"));
  }
}

TEST_F(Templates, MakeAFolderOnce) {
  fs::create_directories(folder_);
  const std::vector<output::NewFile> files{{"a", "1"}, {"b", ""}};
  output::write_new_folder(folder_ / "new", files);
  EXPECT_EQ(fs::file_size(folder_ / "new/a"), 1u);
  EXPECT_TRUE(fs::exists(folder_ / "new/b"));
  const auto only_new = [&] { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()) == 1; };
  EXPECT_TRUE(only_new());
  EXPECT_THROW(output::write_new_folder(folder_ / "new", files), BadInput);
  EXPECT_THROW(output::write_new_folder(folder_ / "none/new", files), BadInput);
  EXPECT_THROW(output::write_new_folder(folder_ / "new/a/new", files), BadInput);
  EXPECT_TRUE(only_new()) << "something half-made is left";
}

}  // namespace
}  // namespace regista::cli
