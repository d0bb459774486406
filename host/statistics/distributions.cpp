// SPDX-License-Identifier: MIT
#include "statistics/distributions.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>

namespace regista::statistics {
namespace {

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using FisherF = boost::math::fisher_f_distribution<double, Policy>;
using Normal = boost::math::normal_distribution<double, Policy>;
using StudentT = boost::math::students_t_distribution<double, Policy>;

[[maybe_unused]] bool is_probability(double value) { return value > 0.0 && value < 1.0; }

}  // namespace

double normal_below(double z) { return boost::math::cdf(Normal(), z); }

double normal_quantile(double probability) {
  assert(is_probability(probability));
  return boost::math::quantile(Normal(), probability);
}

double student_t_outside(double t, double degrees) {
  assert(degrees > 0.0);
  return 2.0 * boost::math::cdf(boost::math::complement(StudentT(degrees), std::abs(t)));
}

double student_t_quantile(double probability, double degrees) {
  assert(is_probability(probability) && degrees > 0.0);
  return boost::math::quantile(StudentT(degrees), probability);
}

double fisher_f_above(double f, double degrees, double residual_degrees) {
  assert(degrees > 0.0 && residual_degrees > 0.0);
  return boost::math::cdf(boost::math::complement(FisherF(degrees, residual_degrees), f));
}

double central_normal(double confidence) { return normal_quantile(0.5 + confidence / 2.0); }

}  // namespace regista::statistics
