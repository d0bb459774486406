// SPDX-License-Identifier: MIT
// The few probability distributions that this room needs, by Boost.Math, computed in double precision only, so that
// every compiler gives the same digits.
#pragma once

namespace regista::statistics {

double normal_below(double z);  // probability that a standard normal variable is below z; z may be infinite
double normal_quantile(double probability);  // its inverse; probability in (0, 1)

// Student's distribution, degrees of freedom above 0.
double student_t_outside(double t, double degrees);             // probability of a value beyond +-|t|
double student_t_quantile(double probability, double degrees);  // probability in (0, 1)

// Fisher's F: probability of a value above f, 0 or more; both degrees of freedom above 0.
double fisher_f_above(double f, double degrees, double residual_degrees);

// The z of a central interval: 1.959964 for a confidence of 0.95. Confidence in (0, 1).
double central_normal(double confidence);

}  // namespace regista::statistics
