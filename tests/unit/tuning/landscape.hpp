// SPDX-License-Identifier: MIT
// Functions on the unit cube whose optima are known, and a record of what a search asked.
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>
#include <vector>

#include "study/tuning/evaluator.hpp"
#include "study/tuning/search.hpp"

namespace regista::study {

inline void PrintTo(Algorithm algorithm, std::ostream* out) { *out << name(algorithm); }

constexpr Algorithm all_algorithms[] = {Algorithm::sbplx,      Algorithm::bobyqa,       Algorithm::nelder_mead,
                                        Algorithm::cobyla,     Algorithm::crs2_lm,      Algorithm::direct_l,
                                        Algorithm::isres,      Algorithm::esch,         Algorithm::spsa,
                                        Algorithm::sep_cma_es, Algorithm::random_search};

inline Point point(std::initializer_list<double> coordinates) {
  Point out(static_cast<Eigen::Index>(coordinates.size()));
  Eigen::Index i = 0;
  for (const double each : coordinates) out[i++] = each;
  return out;
}

inline Point uniform_point(std::size_t dimensions, double value) {
  return Point::Constant(static_cast<Eigen::Index>(dimensions), value);
}

// -|x - optimum|^2.
inline double sphere(const Point& x, const Point& optimum) { return -(x - optimum).squaredNorm(); }

// The curved valley of Rosenbrock on [-2, 2]^2, optimum at (0.75, 0.75) of the square, value 0.
inline double rosenbrock(const Point& at) {
  const double x = 4.0 * at[0] - 2.0, y = 4.0 * at[1] - 2.0;
  return -(100.0 * (y - x * x) * (y - x * x) + (1.0 - x) * (1.0 - x));
}

struct Asked {
  std::vector<Point> points;
  std::uint64_t pairs;

  bool operator==(const Asked&) const = default;
};

// What was asked, in order; answers by a function of a point.
template <class Value>
Evaluate recorded(std::vector<Asked>& record, Value value) {
  return [&record, value](const Question& question) mutable {
    record.push_back({{question.points.begin(), question.points.end()}, question.pairs});
    std::vector<double> out;
    for (const Point& each : question.points) out.push_back(value(each));
    return out;
  };
}

inline std::uint64_t number_of_points(const std::vector<Asked>& record) {
  std::uint64_t out = 0;
  for (const Asked& each : record) out += each.points.size();
  return out;
}

// A sphere whose every answer has noise of its own.
class NoisySphere {
 public:
  NoisySphere(Point optimum, double deviation, std::uint64_t seed)
      : optimum_(std::move(optimum)), deviation_(deviation), noise_(seed ^ 0x5eed, Rng::Use::random) {}

  double operator()(const Point& x) { return sphere(x, optimum_) + deviation_ * noise_.normal(); }

 private:
  Point optimum_;
  double deviation_;
  Rng noise_;
};

}  // namespace regista::study
