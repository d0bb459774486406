// SPDX-License-Identifier: MIT
// What every search holds to, whatever it does: points in the cube, the budget, the numbers of pairs, the same course
// for the same seed.
#include <gmock/gmock.h>

#include <thread>

#include "landscape.hpp"
#include "study/tuning/search.hpp"

namespace regista::study {
namespace {

class EverySearch : public testing::TestWithParam<Algorithm> {};

INSTANTIATE_TEST_SUITE_P(Algorithms, EverySearch, testing::ValuesIn(all_algorithms),
                         [](const auto& each) { return std::string(name(each.param)); });

bool in_cube(const Point& x) { return (x.array() >= 0.0).all() && (x.array() <= 1.0).all(); }

bool contains(const std::vector<Point>& points, const Point& wanted) {
  return std::find(points.begin(), points.end(), wanted) != points.end();
}

void expect_contract(const std::vector<Asked>& record, const SearchSettings& settings, const SearchResult& result) {
  EXPECT_LE(number_of_points(record), settings.evaluations);
  std::uint64_t largest = 0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    ASSERT_FALSE(record[i].points.empty());
    for (const Point& each : record[i].points) {
      ASSERT_EQ(each.size(), settings.start.size());
      ASSERT_TRUE(in_cube(each)) << each.transpose();
    }
    ASSERT_LE(record[i].pairs, i == 0 ? 0 : largest + 1);
    largest = std::max(largest, record[i].pairs);
  }
  ASSERT_FALSE(result.recommended.empty());
  EXPECT_LE(result.recommended.size(), 8u);
  for (std::size_t i = 0; i < result.recommended.size(); ++i) {
    EXPECT_EQ(result.recommended[i].size(), settings.start.size());
    EXPECT_TRUE(in_cube(result.recommended[i]));
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(result.recommended[i], result.recommended[j]);
  }
  EXPECT_FALSE(result.ended.empty());
}

TEST_P(EverySearch, StaysInTheCubeAndTheBudgetFromAnyStart) {
  for (const std::size_t dimensions : {1u, 2u, 5u}) {
    const std::uint64_t least = least_evaluations(GetParam(), dimensions, 0);
    for (const double start : {0.0, 0.37, 1.0}) {
      for (const std::uint64_t budget : {least, least + 1, std::max<std::uint64_t>(least, 137), least + 500}) {
        SCOPED_TRACE(testing::Message() << dimensions << " dimensions from " << start << ", budget " << budget);
        SearchSettings settings;
        settings.start = uniform_point(dimensions, start);
        settings.evaluations = budget;
        std::vector<Asked> record;
        const SearchResult result =
            search(GetParam(), settings, recorded(record, NoisySphere(uniform_point(dimensions, 0.6), 0.1, budget)));
        expect_contract(record, settings, result);
      }
    }
  }
}

TEST_P(EverySearch, SpendsItsBudgetOnNoise) {
  SearchSettings settings;
  settings.start = uniform_point(3, 0.2);
  settings.evaluations = 1000;
  std::vector<Asked> record;
  const SearchResult result =
      search(GetParam(), settings, recorded(record, NoisySphere(uniform_point(3, 0.6), 0.3, 1)));
  EXPECT_GE(number_of_points(record), 950u) << result.ended;
  EXPECT_EQ(result.ended, "budget used up");
}

TEST_P(EverySearch, AsksTheSameForTheSameSeed) {
  const auto course = [](std::uint64_t seed) {
    SearchSettings settings;
    settings.start = uniform_point(3, 0.2);
    settings.evaluations = 400;
    settings.seed = seed;
    std::vector<Asked> record;
    const SearchResult result =
        search(GetParam(), settings, recorded(record, NoisySphere(uniform_point(3, 0.6), 0.3, 1)));
    record.push_back({result.recommended, 0});
    return record;
  };
  const std::vector<Asked> first = course(1), second = course(2), far = course(1 + (std::uint64_t{1} << 40));
  EXPECT_EQ(course(1), first);
  if (GetParam() != Algorithm::direct_l) {
    EXPECT_NE(first, second);
    EXPECT_NE(first, far) << "all bits of a seed count";
  }

  std::vector<Asked> here, there;
  for (int repeated = 0; repeated < 5; ++repeated) {
    std::thread one([&] { here = course(1); });
    std::thread other([&] { there = course(2); });
    one.join();
    other.join();
    EXPECT_EQ(here, first);
    EXPECT_EQ(there, second);
  }
}

// What each asks on which pairs, with a population of ten where it has one.
TEST_P(EverySearch, NumbersItsPairs) {
  SearchSettings settings;
  settings.start = uniform_point(2, 0.3);
  settings.evaluations = 100;
  settings.population = has_population(GetParam()) ? 10 : 0;
  std::vector<Asked> record;
  search(GetParam(), settings, recorded(record, NoisySphere(uniform_point(2, 0.6), 0.3, 1)));
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    SCOPED_TRACE(i);
    std::uint64_t expected = 0;
    switch (GetParam()) {
      case Algorithm::crs2_lm:
      case Algorithm::isres:
        expected = before / 10;
        break;
      case Algorithm::esch:
        expected = before < 10 ? 0 : 1 + (before - 10) / 15;
        break;
      case Algorithm::spsa:
        EXPECT_EQ(record[i].points.size(), 2u);
        expected = i;
        break;
      case Algorithm::sep_cma_es:
        EXPECT_EQ(record[i].points.size(), 10u);
        expected = i;
        break;
      default:
        break;
    }
    ASSERT_EQ(record[i].pairs, expected);
    before += record[i].points.size();
  }
}

// Those who compare values as they are recommend the best they saw, the start among them.
TEST_P(EverySearch, RecommendsTheStartWhenAllElseIsWorse) {
  if (!wants_replication(GetParam())) return;  // believes no single value
  SearchSettings settings;
  settings.start = point({0.31, 0.77});
  settings.evaluations = 300;
  std::vector<Asked> record;
  const SearchResult result = search(
      GetParam(), settings, recorded(record, [&](const Point& x) { return x == settings.start ? 1.0 : -x.norm(); }));
  EXPECT_EQ(result.recommended.front(), settings.start);
}

TEST_P(EverySearch, RecommendsPointsThatWereAskedUnlessItKeepsAnEstimate) {
  if (GetParam() == Algorithm::spsa || GetParam() == Algorithm::sep_cma_es) return;  // they keep an estimate
  SearchSettings settings;
  settings.start = point({0.31, 0.77});
  settings.evaluations = 300;
  std::vector<Asked> record;
  const SearchResult result = search(GetParam(), settings, recorded(record, NoisySphere(point({0.6, 0.2}), 0.1, 1)));
  std::vector<Point> asked;
  for (const Asked& each : record) asked.insert(asked.end(), each.points.begin(), each.points.end());
  EXPECT_EQ(result.recommended.size(), 8u);
  for (const Point& each : result.recommended) EXPECT_TRUE(contains(asked, each));
}

}  // namespace
}  // namespace regista::study
