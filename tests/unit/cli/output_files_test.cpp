// SPDX-License-Identifier: MIT
// Every option of every command that takes a value is known to name a file that is read, one that is written, or none;
// and none that is written to can be made to write over one that is read, or over another.
#include "cli/output_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/end_of_program.hpp"
#include "cli/file_options.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Types of values that are no files, as the help calls them.
constexpr std::array plain{"N",    "SECONDS", "MIB",    "RATE",   "ELO0,ELO1", "MODEL", "NAME",           "PATH=VALUE",
                           "ID",   "KIND",    "COUNTS", "FORMAT", "A,B,...",   "H0,H1", "[home/|away/]N", "[HALF/]M:SS",
                           "WHEN", "MATCH"};

class OutputFilesTest : public testing::Test {
 protected:
  OutputFilesTest() : commands_(add_commands(root_, invocation_)) {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("regista_output_files_") + test->name());
    fs::remove_all(folder_);
    fs::create_directory(folder_);
  }
  ~OutputFilesTest() override { fs::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& content = "kept") const {
    std::ofstream(folder_ / name) << content;
    return folder_ / name;
  }

  // Fresh, as an App keeps what it was given.
  std::string refusal(const std::vector<std::string>& command, std::vector<std::string> words) const {
    CLI::App root;
    const std::vector<Command> all = add_commands(root, invocation_);
    words.insert(words.begin(), command.begin(), command.end());
    root.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    const CLI::App* app = &root;
    for (const std::string& each : command) app = app->get_subcommand(each);
    try {
      OutputFiles(*app, "test").check(true);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }

  std::vector<std::string> name_of(const CLI::App& app) const {
    std::vector<std::string> out;
    for (const CLI::App* each = &app; each->get_parent() != nullptr; each = each->get_parent()) {
      out.insert(out.begin(), each->get_name());
    }
    return out;
  }

  // The words that give an option this value.
  static std::vector<std::string> given(const CLI::Option& option, const std::string& value) {
    if (option.nonpositional()) return {option.get_name(), value};
    return {value};
  }

  fs::path folder_;
  Invocation invocation_;
  CLI::App root_;
  std::vector<Command> commands_;
};

TEST_F(OutputFilesTest, EveryOptionSaysWhatItNames) {
  int written = 0, read = 0;
  for (const Command& command : commands_) {
    for (const CLI::Option* const option : command.app->get_options()) {
      if (option->get_expected_max() == 0) continue;  // a flag
      const bool reads = read_by(*option).has_value(), writes = written_by(*option).has_value();
      read += reads;
      written += writes;
      const bool none = std::ranges::find(plain, option->get_type_name()) != plain.end();
      EXPECT_EQ(reads + writes + none, 1)
          << command.app->get_name() << ' ' << option->get_name() << ' ' << option->get_type_name();
    }
  }
  EXPECT_GE(read, 20);
  EXPECT_GE(written, 12);
}

TEST_F(OutputFilesTest, NoOutputOfAnyCommandIsWrittenOverAnInputOrAnotherOutput) {
  int checked = 0;
  for (const Command& command : commands_) {
    const std::vector<const CLI::Option*> options = [&] {
      const CLI::App& app = *command.app;
      return app.get_options();
    }();
    for (const CLI::Option* const output : options) {
      if (!written_by(*output) || written_by(*output) == Writes::figures) continue;
      const auto check = [&](const CLI::Option& other, const char* say) {
        const std::string one = file("one");
        fs::remove(folder_ / "link");
        fs::create_hard_link(one, folder_ / "link");
        for (const std::string& value : {one, (folder_ / "." / "one").string(), (folder_ / "link").string()}) {
          std::vector<std::string> words = given(other, one);
          const std::vector<std::string> more = given(*output, value);
          words.insert(words.end(), more.begin(), more.end());
          EXPECT_THAT(refusal(name_of(*command.app), words), HasSubstr(say))
              << command.app->get_name() << ' ' << output->get_name() << ' ' << other.get_name();
          ++checked;
        }
      };
      for (const CLI::Option* const other : options) {
        const auto reads = read_by(*other);
        if (reads && reads != Reads::plugins) check(*other, "is a file that this test reads");
        if (other != output && written_by(*other) && written_by(*other) != Writes::figures) check(*other, "both name");
      }
    }
  }
  EXPECT_GE(checked, 100);
}

TEST_F(OutputFilesTest, DocumentsLeadToFiles) {
  file("parent.yaml", "team: parent\n");
  file("data.txt", "1 2 3");
  fs::create_directory(folder_ / "scenes");
  file("scenes/one.yaml", "opening: one\n");
  const std::string top =
      file("top.yaml", "extends: parent.yaml\nopenings: [scenes]\nsender: {params: {file: data.txt}}\n");
  for (const char* name : {"parent.yaml", "data.txt", "scenes/one.yaml", "top.yaml"}) {
    EXPECT_THAT(refusal({"experiment"}, {top, "--csv", folder_ / name}), HasSubstr("is a file that")) << name;
  }
  const std::string set = "sender.params.file=" + file("of_set.txt");
  EXPECT_THAT(refusal({"experiment"}, {top, "--set", set, "--csv", folder_ / "of_set.txt"}), HasSubstr("is a file"));
  EXPECT_EQ(refusal({"experiment"}, {top, "--csv", file("other.txt")}), "");
}

TEST_F(OutputFilesTest, DocumentsThatLeadToEachOtherEnd) {
  file("b.yaml", "extends: a.yaml\n");
  EXPECT_EQ(refusal({"experiment"}, {file("a.yaml", "extends: b.yaml\n"), "--csv", folder_ / "c.csv"}), "");
}

TEST_F(OutputFilesTest, ResultsHaveALog) {
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
    const std::string results = folder_ / "r.db";
    EXPECT_THAT(refusal({"match"}, {"--from", results, "--record", results + ending}), HasSubstr("is a file that"));
    EXPECT_THAT(refusal({"report"}, {results, "-o", results + ending}), HasSubstr("is a file that"));
  }
}

TEST_F(OutputFilesTest, PluginsAreRead) {
  file("mine.so");
  EXPECT_THAT(refusal({"tune"}, {"t.yaml", "--plugins", folder_, "--trace", folder_ / "mine.so"}),
              HasSubstr("is a file that"));
}

}  // namespace
}  // namespace regista::cli
