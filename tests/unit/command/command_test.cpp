// SPDX-License-Identifier: MIT
#include "command/command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "config/errors.hpp"

namespace regista::command {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

// "garden water BED... [--litres N] [--at TIME]... [--with can|hose] [--gently]", "garden rest", and a hidden "garden
// dig".
class Garden : public testing::Test {
 protected:
  Garden() {
    Command& water = program_.add("water", "give water");
    water.take("beds", beds_, "BED", "where");
    water.take("-l,--litres", litres_, "N", "how much");
    water.take("--at", times_, "TIME", "when");
    water.choose("--with", tool_, {"can", "hose"}, "by what");
    water.flag("--gently", gently_, "without haste");
    water.run = [] { return 7; };
    program_.add("rest", "do nothing").run = [] { return 8; };
    Command& dig = program_.add("dig", "for the program itself");
    dig.hidden = true;
    dig.run = [] { return 9; };
    program_.answer_version("garden 1");
  }

  Command::Typed read(const std::vector<std::string>& words) { return program_.read(words, 80); }

  // The one line that is said of words that cannot be read.
  std::string refusal(const std::vector<std::string>& words) {
    try {
      read(words);
    } catch (const config::BadInput& error) {
      return error.what();
    }
    return "read";
  }

  std::vector<std::string> beds_, times_;
  std::string litres_ = "1", tool_;
  bool gently_ = false;
  Command program_{"garden", "look after a garden"};
};

TEST_F(Garden, ReadsWhatIsTakenAndNamesTheCommand) {
  const Command::Typed typed = read({"water", "roses", "--at", "6", "peas", "-l", "3", "--at=18", "--gently"});
  ASSERT_NE(typed.command, nullptr);
  EXPECT_EQ(typed.command->run(), 7);
  EXPECT_THAT(beds_, ElementsAre("roses", "peas"));
  EXPECT_THAT(times_, ElementsAre("6", "18"));
  EXPECT_EQ(litres_, "3");
  EXPECT_TRUE(gently_);
}

TEST_F(Garden, WhatIsNotGivenStaysAsItWas) {
  const Command::Typed typed = read({"water"});
  EXPECT_EQ(litres_, "1");
  EXPECT_FALSE(gently_);
  EXPECT_TRUE(typed.command->given().empty());
}

TEST_F(Garden, WhatIsGivenIsToldByTheLongName) {
  const auto given = read({"water", "-l", "3"}).command->given();
  ASSERT_EQ(given.size(), 1U);
  EXPECT_EQ(given.front().name, "--litres");
  EXPECT_THAT(given.front().values, ElementsAre("3"));
}

TEST_F(Garden, HiddenCommandsRunAndAreNotShown) {
  EXPECT_EQ(read({"dig"}).command->run(), 9);
  for (const CommandDeclaration& each : program_.declaration().commands) EXPECT_NE(each.name, "dig");
}

TEST_F(Garden, AnswersQuestionsAboutItself) { EXPECT_EQ(read({"--version"}).answer, "garden 1\n"); }

TEST_F(Garden, HelpIsAnsweredForTheCommandThatWasMeant) {
  EXPECT_THAT(read({"water", "--help"}).answer, StartsWith("garden water: give water\n"));
}

TEST_F(Garden, UnknownCommandsGetTheNearestName) {
  EXPECT_EQ(refusal({"watr"}), "unknown command \"watr\" in garden; nearest: \"water\"; known: water, rest, help");
}

TEST_F(Garden, UnknownOptionsGetTheNearestName) {
  EXPECT_THAT(refusal({"water", "--litre=3"}),
              StartsWith("unknown option \"--litre\" in garden water; nearest: \"--litres\"; known: "));
}

TEST_F(Garden, NoCommandIsAQuestion) {
  EXPECT_EQ(refusal({}), "which command? There are: water, rest, help; see: garden --help");
}

TEST_F(Garden, ValuesThatAreMissingAreNotTakenFromTheNextOption) {
  EXPECT_EQ(refusal({"water", "--at", "--gently"}), "--at needs a value, and \"--gently\" is an option");
}

TEST_F(Garden, EmptyValuesAreRefused) { EXPECT_EQ(refusal({"water", "--at", ""}), "--at needs a value"); }

TEST_F(Garden, WordsThatNothingTakesAreRefused) {
  EXPECT_EQ(refusal({"rest", "long"}), "unexpected argument \"long\"; see: garden rest --help");
}

}  // namespace
}  // namespace regista::command
