// SPDX-License-Identifier: MIT
// Every option of every command that takes a value is known to name a file that is read, one that is written, or none;
// and none that is written to can be made to write over one that is read, or over another.
#include "output/output_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "cli/command_line.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// Types of values that are no files, as the help calls them.
constexpr std::array plain{"CHECK",   "A,B",        "TEXT",    "NUMBER", "MINUTES",        "NAME=VALUE",  "N",
                           "SECONDS", "TIME",       "MIB",     "RATE",   "ELO0,ELO1",      "NAME",        "PATH=VALUE",
                           "ID",      "COUNTS",     "A,B,...", "H0,H1",  "[home/|away/]N", "[HALF/]M:SS", "MATCH",
                           "X,Y",     "NEW_FOLDER", "COMMAND"};

class OutputFilesTest : public testing::Test {
 protected:
  OutputFilesTest() {
    add_commands(program_, invocation_);
    declared_ = program_.declaration();
    gather(declared_);
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

  // A fresh program, as one keeps what it was given.
  std::string refusal(const std::vector<std::string>& command, std::vector<std::string> words) const {
    Command program("regista", "");
    add_commands(program, invocation_);
    words.insert(words.begin(), command.begin(), command.end());
    const Command::Typed typed = program.read(words, 80);
    try {
      output::OutputFiles(typed.command->given(), "test").check(true);
    } catch (const BadInput& error) {
      return error.what();
    }
    return "";
  }

  // "regista plugin info" as the words that follow the program's name.
  static std::vector<std::string> name_of(const command::CommandDeclaration& command) {
    std::istringstream words(command.full_name);
    return {std::next(std::istream_iterator<std::string>(words)), {}};
  }

  // The words that give an option this value.
  static std::vector<std::string> given(const command::OptionDeclaration& option, const std::string& value) {
    if (option.is_positional()) return {value};
    return {option.name(), value};
  }

  void gather(const command::CommandDeclaration& command) {
    if (command.commands.empty()) commands_.push_back(&command);
    for (const command::CommandDeclaration& each : command.commands) gather(each);
  }

  fs::path folder_;
  Invocation invocation_;
  Command program_{"regista", ""};
  command::CommandDeclaration declared_;
  std::vector<const command::CommandDeclaration*> commands_;  // that do something
};

bool is_read(const command::OptionDeclaration& option) { return std::holds_alternative<Reads>(option.use); }
bool is_written(const command::OptionDeclaration& option) { return std::holds_alternative<Writes>(option.use); }
bool is_written_file(const command::OptionDeclaration& option) {
  return is_written(option) && option.use != output::FileUse(Writes::figures) &&
         option.use != output::FileUse(Writes::sources);
}

TEST_F(OutputFilesTest, EveryOptionSaysWhatItNames) {
  int written = 0, read = 0;
  for (const command::CommandDeclaration* const command : commands_) {
    for (const command::OptionDeclaration& option : command->options) {
      if (option.is_flag()) continue;  // a flag
      const bool reads = is_read(option), writes = is_written(option);
      read += reads;
      written += writes;
      const bool none = !option.choices.empty() || std::ranges::find(plain, option.type) != plain.end();
      EXPECT_EQ(reads + writes + none, 1) << command->full_name << ' ' << option.name() << ' ' << option.type;
    }
  }
  EXPECT_GE(read, 20);
  EXPECT_GE(written, 12);
}

TEST_F(OutputFilesTest, NoOutputOfAnyCommandIsWrittenOverAnInputOrAnotherOutput) {
  int checked = 0;
  for (const command::CommandDeclaration* const command : commands_) {
    for (const command::OptionDeclaration& written : command->options) {
      if (!is_written_file(written)) continue;
      const auto check = [&](const command::OptionDeclaration& other, const char* say) {
        const std::string one = file("one");
        fs::remove(folder_ / "link");
        fs::create_hard_link(one, folder_ / "link");
        for (const std::string& value : {one, (folder_ / "." / "one").string(), (folder_ / "link").string()}) {
          std::vector<std::string> words = given(other, one);
          const std::vector<std::string> more = given(written, value);
          words.insert(words.end(), more.begin(), more.end());
          EXPECT_THAT(refusal(name_of(*command), words), HasSubstr(say))
              << command->full_name << ' ' << written.name() << ' ' << other.name();
          ++checked;
        }
      };
      for (const command::OptionDeclaration& other : command->options) {
        if (is_read(other) && other.use != output::FileUse(Reads::plugins)) {
          check(other, "is a file that this test reads");
        }
        if (other.name() != written.name() && is_written_file(other)) check(other, "both name");
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

TEST_F(OutputFilesTest, WhatSqliteKeepsBesideADatabaseIsNoOutput) {
  const std::string other = file("other.db", "SQLite format 3, and more"), table = file("table.csv");
  for (const char* ending : {"-wal", "-shm", "-journal"}) {
    EXPECT_THAT(refusal({"tune"}, {"t.yaml", "--trace", other + ending}), HasSubstr("would take it for a part of"));
    EXPECT_THAT(refusal({"report"}, {"r.db", "--figures", other + ending}), HasSubstr("would take it for a part of"));
    EXPECT_EQ(refusal({"tune"}, {"t.yaml", "--trace", table + ending}), "");
  }
  EXPECT_EQ(refusal({"report"}, {"r.db", "--figures", other + "-figures"}), "");
}

TEST_F(OutputFilesTest, PluginsAreRead) {
  file("mine.so");
  EXPECT_THAT(refusal({"tune"}, {"t.yaml", "--plugins", folder_, "--trace", folder_ / "mine.so"}),
              HasSubstr("is a file that"));
}

}  // namespace
}  // namespace regista::cli
