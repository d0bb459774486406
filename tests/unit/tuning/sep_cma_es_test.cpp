// SPDX-License-Identifier: MIT
#include "study/tuning/stochastic_search.hpp"

#include <gmock/gmock.h>

#include "landscape.hpp"

namespace regista::study {
namespace {

// 4 + 3 ln n, as published: 4, 6, 8, 10, 10, 17 for 1, 2, 4, 8, 10 and 100 dimensions.
TEST(SepCmaEs, LeastPopulationIsThePublishedOne) {
  EXPECT_EQ(least_sep_cma_es_population(1), 4u);
  EXPECT_EQ(least_sep_cma_es_population(2), 6u);
  EXPECT_EQ(least_sep_cma_es_population(4), 8u);
  EXPECT_EQ(least_sep_cma_es_population(8), 10u);
  EXPECT_EQ(least_sep_cma_es_population(10), 10u);
  EXPECT_EQ(least_sep_cma_es_population(100), 17u);
}

TEST(SepCmaEs, PopulationGrowsWithTheBudgetAndUsesItUp) {
  std::uint64_t before = 0;
  for (const std::uint64_t budget : {20u, 100u, 1000u, 4000u, 20000u, 100000u}) {
    const std::uint64_t population = sep_cma_es_population(4, budget);
    EXPECT_GE(population, before);
    EXPECT_GE(budget / population, 2u);
    EXPECT_LT(budget % population, 1 + budget / 20) << budget;
    before = population;
  }
}

// It uses nothing of the values but their order.
TEST(SepCmaEs, OnlyTheOrderOfValuesCounts) {
  const Point optimum = point({0.4, 0.55, 0.6});
  const auto course = [&](auto transform) {
    SearchSettings settings;
    settings.start = point({0.8, 0.1, 0.3});
    settings.evaluations = 1000;
    std::vector<Asked> record;
    search(Algorithm::sep_cma_es, settings,
           recorded(record, [&, noisy = NoisySphere(optimum, 0.05, 3)](const Point& x) mutable {
             return transform(noisy(x));
           }));
    return record;
  };
  const std::vector<Asked> plain = course([](double value) { return value; });
  EXPECT_EQ(plain, course([](double value) { return 8.0 * value; }));
  EXPECT_EQ(plain, course([](double value) { return value * value * value; }));
}

// Axes whose curvatures differ by a million: what the diagonal is adapted for.
TEST(SepCmaEs, LearnsTheScalesOfTheAxes) {
  const Point optimum = point({0.3, 0.62, 0.45, 0.7});
  SearchSettings settings;
  settings.start = uniform_point(4, 0.5);
  settings.evaluations = 10000;
  settings.population = 20;
  std::vector<Asked> record;
  const SearchResult result = search(Algorithm::sep_cma_es, settings, recorded(record, [&](const Point& x) {
                                       double value = 0.0;
                                       for (Eigen::Index i = 0; i < 4; ++i) {
                                         const double distance = x[i] - optimum[i];
                                         value -= std::pow(100.0, static_cast<double>(i)) * distance * distance;
                                       }
                                       return value;
                                     }));
  EXPECT_LT((result.recommended.front() - optimum).cwiseAbs().maxCoeff(), 1e-5);
}

TEST(SepCmaEs, FirstGenerationIsSpreadAroundTheStart) {
  SearchSettings settings;
  settings.start = point({0.5, 0.5});
  settings.evaluations = 40000;
  settings.population = 20000;
  std::vector<Asked> record;
  search(Algorithm::sep_cma_es, settings, recorded(record, [](const Point& x) { return x[0]; }));
  Point mean = Point::Zero(2);
  for (const Point& each : record[0].points) mean += each;
  mean /= 20000.0;
  EXPECT_LT((mean - settings.start).cwiseAbs().maxCoeff(), 0.01) << "symmetric, also where the cube ends";
}

}  // namespace
}  // namespace regista::study
