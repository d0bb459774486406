// SPDX-License-Identifier: MIT
#include "match/metric_numbers.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace regista::match {
namespace {

using testing::ElementsAre;
using testing::Eq;
using testing::IsEmpty;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::shared_ptr<const MetricNames> names(std::vector<MetricName> of) {
  return std::make_shared<const MetricNames>(std::move(of));
}

MetricName of(Side side, const std::string& name, const std::string& role = "", int place = 0) {
  return {.side = side, .role = role, .name = name, .place = place};
}

TEST(MetricColumns, OfTeamsHomeBeforeAwayThenThoseOfTheMatch) {
  MetricColumns columns({.of_teams = {"packets", "striker.overlap_seconds"}, .of_match = {"ball_rests"}});
  const MetricNumbers numbers(
      names({of(Side::home, "packets"), of(Side::home, "overlap_seconds", "striker"), of(Side::away, "packets"),
             of(Side::away, "overlap_seconds", "striker"), MetricName{.name = "ball_rests"}}),
      {1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_THAT(columns.of(numbers), ElementsAre(1.0, 3.0, 2.0, 4.0, 5.0));
}

TEST(MetricColumns, NothingWhereAMatchHasNone) {
  MetricColumns columns({.of_teams = {"packets", "curve"}, .of_match = {"ball_rests"}});
  const MetricNumbers numbers(names({of(Side::home, "packets"), of(Side::away, "packets"),
                                     of(Side::home, "curve", "", 1), MetricName{.name = "playing_seconds"}}),
                              {none, 7.0, 8.0, 9.0});
  const auto nothing = Eq(std::nullopt);
  EXPECT_THAT(columns.of(numbers), ElementsAre(nothing, 7.0, nothing, nothing, nothing));  // a list has no column
  EXPECT_THAT(columns.of({}), ElementsAre(nothing, nothing, nothing, nothing, nothing));
}

// The same path stands elsewhere in each of more lists than are remembered.
TEST(MetricColumns, MatchesOfManyNames) {
  MetricColumns columns({.of_teams = {"packets"}, .of_match = {}});
  std::vector<std::shared_ptr<const MetricNames>> lists;
  for (std::size_t before = 0; before < 300; ++before) {
    std::vector<MetricName> list;
    for (std::size_t i = 0; i < before; ++i) list.push_back({.name = "x" + std::to_string(i)});
    list.push_back(of(Side::home, "packets"));
    list.push_back(of(Side::away, "packets"));
    lists.push_back(names(std::move(list)));
  }
  for (int again = 0; again < 2; ++again) {
    for (const auto& each : lists) {
      std::vector<double> values(each->size(), 0.0);
      const auto at = static_cast<double>(each->size());
      values[values.size() - 2] = at;
      values.back() = -at;
      EXPECT_THAT(columns.of({each, values}), ElementsAre(at, -at));
    }
  }
}

TEST(MetricColumns, NoneAreAskedFor) { EXPECT_THAT(MetricColumns().of({}), IsEmpty()); }

}  // namespace
}  // namespace regista::match
