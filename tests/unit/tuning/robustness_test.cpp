// SPDX-License-Identifier: MIT
// What an objective may do to a search: throw, answer no number, crash once, be flat or rough.
#include <gmock/gmock.h>

#include <limits>

#include "landscape.hpp"

namespace regista::study {
namespace {

class AgainstObjectives : public testing::TestWithParam<Algorithm> {};

INSTANTIATE_TEST_SUITE_P(Algorithms, AgainstObjectives, testing::ValuesIn(all_algorithms),
                         [](const auto& each) { return std::string(name(each.param)); });

// Nothing that NLopt or the standard library would know.
struct Interrupted {
  int at;
};

TEST_P(AgainstObjectives, ExceptionsPassThroughAsTheyAre) {
  for (const int at : {1, 2, 17, 150}) {
    SCOPED_TRACE(at);
    SearchSettings settings;
    settings.start = uniform_point(3, 0.3);
    settings.evaluations = 1000;
    int asked = 0;
    NoisySphere noisy(uniform_point(3, 0.6), 0.1, 1);
    try {
      search(GetParam(), settings, [&](const Question& question) {
        EXPECT_LT(asked, at) << "asked again after an exception";
        std::vector<double> out;
        for (const Point& each : question.points) {
          if (++asked == at) throw Interrupted{at};
          out.push_back(noisy(each));
        }
        return out;
      });
      ADD_FAILURE() << "nothing was thrown";
    } catch (const Interrupted& thrown) {
      EXPECT_EQ(thrown.at, at);
    }
  }
}

TEST_P(AgainstObjectives, ASearchAfterOneThatFailedIsAsIfThatHadNotBeen) {
  const auto course = [] {
    SearchSettings settings;
    settings.start = uniform_point(2, 0.3);
    settings.evaluations = 200;
    std::vector<Asked> record;
    search(GetParam(), settings, recorded(record, NoisySphere(uniform_point(2, 0.6), 0.1, 1)));
    return record;
  };
  const std::vector<Asked> before = course();
  SearchSettings settings;
  settings.start = uniform_point(2, 0.3);
  settings.evaluations = 200;
  EXPECT_THROW(search(GetParam(), settings, [](const Question&) -> std::vector<double> { throw Interrupted{1}; }),
               Interrupted);
  EXPECT_EQ(course(), before);
}

TEST_P(AgainstObjectives, ThatHaveEnough) {
  for (const int questions : {0, 1, 2, 7}) {
    SCOPED_TRACE(questions);
    SearchSettings settings;
    settings.start = point({0.2, 0.7, 0.4});
    settings.evaluations = 1000;
    NoisySphere noisy(uniform_point(3, 0.6), 0.1, 1);
    int asked = 0;
    const SearchResult result = search(GetParam(), settings, [&](const Question& question) {
      EXPECT_LE(asked, questions) << "asked again";
      std::vector<double> out;
      if (asked++ == questions) return out;
      for (const Point& each : question.points) out.push_back(noisy(each));
      return out;
    });
    EXPECT_EQ(asked, questions + 1);
    EXPECT_EQ(result.ended, "told to stop");
    ASSERT_FALSE(result.recommended.empty());
    if (questions == 0) {
      EXPECT_EQ(result.recommended, std::vector<Point>{settings.start});
    }
  }
}

// Now and then anywhere, and always in a part of the cube beside the optimum.
TEST_P(AgainstObjectives, WhatIsNoNumberIsSurvived) {
  constexpr double none[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};
  const Point optimum = point({0.6, 0.4});
  SearchSettings settings;
  settings.start = uniform_point(2, 0.3);
  settings.evaluations = 1000;
  int number = 0;
  std::vector<Asked> record;
  const SearchResult result = search(GetParam(), settings, recorded(record, [&](const Point& x) {
                                       ++number;
                                       const bool fails = number % 50 == 7 || x[0] > 0.8;
                                       return fails ? none[number % 3] : sphere(x, optimum);
                                     }));
  EXPECT_LE(number_of_points(record), 1000u);
  // ESCH draws whole coordinates anew and has no small steps.
  EXPECT_LT((result.recommended.front() - optimum).norm(), GetParam() == Algorithm::esch ? 0.15 : 0.1);
}

TEST_P(AgainstObjectives, NothingButNoNumbers) {
  SearchSettings settings;
  settings.start = point({0.2, 1.0, 0.0});
  settings.evaluations = 300;
  std::vector<Asked> record;
  const SearchResult result = search(GetParam(), settings, recorded(record, [](const Point&) { return std::nan(""); }));
  EXPECT_LE(number_of_points(record), 300u);
  ASSERT_FALSE(result.recommended.empty());
  for (const Point& each : result.recommended) EXPECT_TRUE(each.allFinite());
}

TEST_P(AgainstObjectives, FlatObjective) {
  SearchSettings settings;
  settings.start = point({0.2, 1.0, 0.0});
  settings.evaluations = 300;
  std::vector<Asked> record;
  const SearchResult result = search(GetParam(), settings, recorded(record, [](const Point&) { return 3.0; }));
  EXPECT_LE(number_of_points(record), 300u);
  ASSERT_FALSE(result.recommended.empty());
}

// Models and simplices that collapse on noise are no failure, and not the end.
TEST_P(AgainstObjectives, NothingButNoise) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SearchSettings settings;
    settings.start = uniform_point(4, 0.5);
    settings.evaluations = 500;
    settings.seed = seed;
    Rng noise(seed, Rng::Use::random);
    std::vector<Asked> record;
    EXPECT_NO_THROW(search(GetParam(), settings, recorded(record, [&](const Point&) { return noise.normal(); })));
    EXPECT_GE(number_of_points(record), 450u);
  }
}

TEST_P(AgainstObjectives, ScalesOfAllSizes) {
  for (const double scale : {1e-9, 1e9}) {
    SCOPED_TRACE(scale);
    const Point optimum = point({0.6, 0.4});
    SearchSettings settings;
    settings.start = uniform_point(2, 0.3);
    settings.evaluations = 1000;
    std::vector<Asked> record;
    const SearchResult result =
        search(GetParam(), settings,
               recorded(record, [&](const Point& x) { return 1e3 * scale + scale * sphere(x, optimum); }));
    EXPECT_LT((result.recommended.front() - optimum).norm(), 0.1);
  }
}

}  // namespace
}  // namespace regista::study
