// SPDX-License-Identifier: MIT
#include "report/what_was_played.hpp"

#include <gmock/gmock.h>

#include "config/node.hpp"

namespace regista::report {
namespace {

std::vector<std::string> rows(const std::vector<std::string>& documents) {
  std::vector<std::string> out;
  for (const DifferingValue& row : differing_values(documents)) {
    std::string line = row.path;
    for (const auto& value : row.values) line += " | " + value.value_or("-");
    out.push_back(line);
  }
  return out;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(DifferingValues, EqualDocumentsDoNotDiffer) {
  EXPECT_THAT(rows({"team: a\nx: {y: 1}\n", "x:\n  y: 1\nteam: a\n"}), IsEmpty());
}

TEST(DifferingValues, ByPathAndOnlyOnOneSide) {
  EXPECT_THAT(
      rows({"team: a\nsender: {plugin: p, params: {reserve: 30}}\n", "team: b\nsender: {plugin: q}\nz: [1, 2]\n"}),
      ElementsAre("team | a | b", "sender.plugin | p | q", "sender.params.reserve | 30 | -", "z | - | [1, 2]"));
}

TEST(DifferingValues, ElementsAreCalledByTheirNames) {
  const std::string before = "r:\n  - {name: keeper, at: [0, 1]}\n  - {name: striker, at: ball}\n";
  EXPECT_THAT(
      rows({before, "r:\n  - {name: keeper, at: [0, 1]}\n  - {name: wing, at: x}\n  - {name: striker, at: ball}\n"}),
      ElementsAre("r | keeper, striker | keeper, wing, striker", "r[wing].at | - | x"));
  EXPECT_THAT(rows({before, "r:\n  - {name: striker, at: ball}\n  - {name: keeper, at: [0, 2]}\n"}),
              ElementsAre("r[keeper].at | [0, 1] | [0, 2]", "r | keeper, striker | striker, keeper"));
}

TEST(DifferingValues, ListsWithoutNamesAreOneValue) {
  EXPECT_THAT(rows({"r: [{a: 1}, {b: [x, {c: null}]}]\n", "r: [{a: 1}]\n"}),
              ElementsAre("r | [{a: 1}, {b: [x, {c: null}]}] | [{a: 1}]"));
  // The same name twice is none.
  EXPECT_THAT(rows({"r: [{name: a}, {name: a}]\n", "r: [{name: a}]\n"}), ElementsAre("r | [{name: a}, {name: a}] | a"));
}

TEST(DifferingValues, OfManyDocuments) {
  EXPECT_THAT(rows({"a: 1\nb: 1\n", "a: 1\nb: 2\n", "a: 1\nb: 1\n"}), ElementsAre("b | 1 | 2 | 1"));
  EXPECT_THAT(rows({"a: 1\n"}), IsEmpty());
}

TEST(DifferingValues, NoYaml) {
  EXPECT_THROW(differing_values(std::vector<std::string>{"a: [", "a: 1"}), config::Error);
}

}  // namespace
}  // namespace regista::report
