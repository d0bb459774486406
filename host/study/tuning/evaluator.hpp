// SPDX-License-Identifier: MIT
// Every search algorithm evaluates its points through an Evaluator. The Evaluator keeps to the budget, answers only
// with finite values, and stores all points and values. So the program can choose the best points itself, and does not
// use the point that an algorithm reports as the best.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "match/chance.hpp"
#include "study/tuning/search.hpp"

namespace regista::study {

// --- The random numbers of a search: a stream of Philox4x32-10 (J. K. Salmon et al., "Parallel Random Numbers: As Easy
// as 1, 2, 3", 2011), chosen by the search's seed and by the use of the numbers. The class has its own distributions,
// because the distributions of <random> differ between libraries. Do not put two draws into one argument list, because
// C++ does not define their order.
class Rng {
 public:
  // What the numbers are for. Each use has its own stream for the same seed.
  enum class Use : std::uint32_t {
    spsa = 0x73707361,
    sep_cma_es = 0x636d6165,
    random = 0x72616e64,
    nlopt = 0x6e6c6f70
  };

  Rng(std::uint64_t seed, Use use) : words_(seed, {0, 0, static_cast<std::uint32_t>(use), 0}) {}

  std::uint32_t bits() { return words_.next(); }

  // Uniform in [0, 1), in steps of 2^-53.
  double uniform() {
    const std::uint64_t high = bits() >> 5;
    const std::uint64_t low = bits() >> 6;
    return static_cast<double>(high << 26 | low) * 0x1p-53;
  }

  // -1 or 1, with equal probability.
  double sign() { return bits() >> 31 == 0 ? -1.0 : 1.0; }

  double normal() {
    return normal_.draw([this] { return uniform(); });
  }

 private:
  match::RandomWords words_;
  match::NormalLaw normal_;
};

class Evaluator {
 public:
  // `evaluate` must outlive this object.
  Evaluator(const Evaluate& evaluate, std::uint64_t evaluations) : evaluate_(&evaluate), left_(evaluations) {}

  std::uint64_t left() const { return left_; }

  // Evaluates one to left() points of the unit cube. pairs: Question::pairs. A larger value is better. A value that is
  // not finite becomes worst(). If `evaluate` returns no values, ask() returns no values and sets left() to 0. Throws
  // what `evaluate` throws. The result is valid until the next call.
  std::span<const double> ask(std::span<const Point> points, std::uint64_t pairs);

  // Why no evaluation is left, in a few words.
  const char* ended() const { return stopped_ ? "told to stop" : "budget used up"; }

  // A value for a point without a finite value: the least value so far minus (greatest value - least value). worst() is
  // below all values so far, but so near to them that algorithms can still fit models.
  double worst() const;

  // All points so far, in order, and their values.
  const std::vector<Point>& points() const { return points_; }
  const std::vector<double>& values() const { return values_; }

  // At most `most` different points with the best mean values, best first. Of equal means, the earlier point is first.
  std::vector<Point> best(std::size_t most) const;

 private:
  const Evaluate* evaluate_;
  std::uint64_t left_;
  bool stopped_ = false;
  std::vector<Point> points_;
  std::vector<double> values_;
  bool seen_ = false;  // true after the first finite value
  double least_ = 0.0, greatest_ = 0.0;
};

// The first `most` different points, in the order of their first occurrence.
std::vector<Point> distinct(std::span<const Point> points, std::size_t most);

// The mean of the last 1/part of the points: for part 2, of the last half. The number of these points is rounded up.
Point mean_of_last(std::span<const Point> points, std::size_t part);

// The largest number of points that a search recommends.
constexpr std::size_t most_recommended = 8;

// --- The choice of the best among many points with one noisy value each. The largest value is usually due to luck. The
// mean over a point and its neighbours depends much less on luck: regression by nearest neighbours (N. S. Altman, "An
// Introduction to Kernel and Nearest-Neighbor Nonparametric Regression", The American Statistician 46(3), 1992).

// At most `most` of the candidates, best first. A candidate's rank is the mean value of its neighbours: the 2
// sqrt(number of points) points (rounded up) that are nearest to it. Of two equally near points, the earlier point
// counts. Of two equal means, the earlier candidate is first. Precondition: one or more points, with one value each.
std::vector<Point> best_by_neighbours(std::span<const Point> points, std::span<const double> values,
                                      std::span<const Point> candidates, std::size_t most);

}  // namespace regista::study
