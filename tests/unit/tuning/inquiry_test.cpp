// SPDX-License-Identifier: MIT
#include "study/tuning/evaluator.hpp"

#include <gmock/gmock.h>

#include <limits>

#include "landscape.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Answers the points in turn with these values.
Evaluate answering(std::vector<double> values) {
  return [values = std::move(values), next = std::size_t{0}](const Question& question) mutable {
    std::vector<double> out;
    for (std::size_t i = 0; i < question.points.size(); ++i) out.push_back(values.at(next++));
    return out;
  };
}

const std::vector<Point> abc{point({0.1, 0.2}), point({0.3, 0.4}), point({0.1, 0.5})};

TEST(Evaluator, KeepsTheBudget) {
  const Evaluate evaluate = answering({1, 2, 3, 4});
  Evaluator inquiry(evaluate, 4);
  inquiry.ask(abc, 0);
  EXPECT_EQ(inquiry.left(), 1u);
  EXPECT_THAT(inquiry.ask({abc.data(), 1}, 1), ElementsAre(4.0));
  EXPECT_EQ(inquiry.left(), 0u);
  EXPECT_THAT(inquiry.values(), ElementsAre(1.0, 2.0, 3.0, 4.0));
}

TEST(Evaluator, WhatIsNotFiniteIsWorseThanAllThatIs) {
  const Evaluate evaluate = answering({nan, 5, 3, -infinity, infinity, nan});
  Evaluator inquiry(evaluate, 6);
  EXPECT_THAT(inquiry.ask(abc, 0), ElementsAre(1.0, 5.0, 3.0)) << "as far below 3 as 3 is below 5";
  EXPECT_THAT(inquiry.ask(abc, 0), ElementsAre(1.0, 1.0, 1.0)) << "what was made up does not count as seen";
}

TEST(Evaluator, NothingFiniteAtAll) {
  const Evaluate evaluate = answering({nan, nan, 2, nan});
  Evaluator inquiry(evaluate, 4);
  const double first = inquiry.ask({abc.data(), 1}, 0)[0];
  EXPECT_TRUE(std::isfinite(first));
  inquiry.ask({abc.data(), 1}, 0);
  inquiry.ask({abc.data() + 1, 1}, 0);
  EXPECT_LT(inquiry.ask({abc.data() + 2, 1}, 0)[0], 2.0) << "also below the only value";
  EXPECT_EQ(inquiry.best(1).front(), abc[1]);
}

TEST(Evaluator, HugeValuesStayFinite) {
  const double huge = std::numeric_limits<double>::max();
  const Evaluate evaluate = answering({huge, -huge, nan});
  Evaluator inquiry(evaluate, 3);
  inquiry.ask(abc, 0);
  EXPECT_TRUE(std::isfinite(inquiry.worst()));
  EXPECT_TRUE(std::isfinite(inquiry.values()[2]));
}

TEST(Evaluator, BestByTheMeanOfAPointsValues) {
  const Evaluate evaluate = answering({9, 4, 5, 0, 5, 5});
  Evaluator inquiry(evaluate, 6);
  inquiry.ask(abc, 0);
  inquiry.ask(abc, 1);  // means 4.5, 4.5, 5
  EXPECT_THAT(inquiry.best(8), ElementsAre(abc[2], abc[0], abc[1])) << "of equal means the earlier first";
  EXPECT_THAT(inquiry.best(1), ElementsAre(abc[2]));
}

TEST(Evaluator, Distinct) {
  const std::vector<Point> points{abc[0], abc[1], abc[0], abc[2]};
  EXPECT_THAT(distinct(points, 8), ElementsAre(abc[0], abc[1], abc[2]));
  EXPECT_THAT(distinct(points, 2), ElementsAre(abc[0], abc[1]));
}

TEST(Evaluator, MeanOfTheLast) {
  EXPECT_EQ(mean_of_last(abc, 3), abc[2]);
  EXPECT_EQ(mean_of_last(abc, 2), (abc[1] + abc[2]) / 2.0) << "the half of three, rounded up";
  EXPECT_EQ(mean_of_last(std::span(abc).first(1), 4), abc[0]);
}

// Bounds of six standard deviations.
TEST(Rng, FollowTheirLaws) {
  constexpr int number = 200000;
  Rng draws(7, Rng::Use::spsa);
  double sum = 0.0, squares = 0.0, fourth = 0.0, uniforms = 0.0, signs = 0.0;
  for (int i = 0; i < number; ++i) {
    const double normal = draws.normal();
    sum += normal;
    squares += normal * normal;
    fourth += normal * normal * normal * normal;
    const double uniform = draws.uniform();
    ASSERT_GE(uniform, 0.0);
    ASSERT_LT(uniform, 1.0);
    uniforms += uniform;
    signs += draws.sign();
  }
  const double deviation = 6.0 / std::sqrt(double{number});
  EXPECT_NEAR(sum / number, 0.0, deviation);
  EXPECT_NEAR(squares / number, 1.0, std::sqrt(2.0) * deviation);
  EXPECT_NEAR(fourth / number, 3.0, std::sqrt(96.0) * deviation);
  EXPECT_NEAR(uniforms / number, 0.5, std::sqrt(1.0 / 12.0) * deviation);
  EXPECT_NEAR(signs / number, 0.0, deviation);
}

TEST(Rng, StreamsDiffer) {
  Rng first(7, Rng::Use::spsa), again(7, Rng::Use::spsa), use(7, Rng::Use::random), seed(8, Rng::Use::spsa);
  const std::uint32_t bits = first.bits();
  EXPECT_EQ(bits, again.bits());
  EXPECT_NE(bits, use.bits());
  EXPECT_NE(bits, seed.bits());
}

}  // namespace
}  // namespace regista::study
