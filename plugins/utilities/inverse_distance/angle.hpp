// SPDX-License-Identifier: MIT
// The angle between two directions from their products, without a branch or a call, so that compilers compute several
// at once, and with the same bits on every processor, which atan2 of the C library does not promise.
//
// With u = |cross| / (length + |dot|), the tangent of half the acute angle, the angle is 2 atan(u) or pi less it. u is
// in [0, 1], where atan(u) / u is a smooth function of u^2: the polynomial is the one that meets it in the 12 Chebyshev
// nodes of [0, 1]. Relative error at most 1e-10 below a right angle, absolute error above it at most 2e-10 rad.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

namespace inverse_distance {

// rad, in [0, pi]; 0 for a vector of no length. dot and cross: products of a unit vector with a vector of `length`.
inline double angle_between(double dot, double cross, double length) {
  constexpr std::array<double, 12> terms{0.9999999999293036,    -0.3333333129089007,  0.19999901102199252,
                                         -0.142838132563088,    0.11091922968521399,  -0.08974171980832546,
                                         0.0722827840836332,    -0.05395668168787729, 0.03382622021506982,
                                         -0.015828323632867135, 0.004732484542946271, -0.0006633955168694083};
  constexpr double least = 1e-300;  // keeps 0 / 0 away
  const double along = dot < 0.0 ? -dot : dot, across = cross < 0.0 ? -cross : cross;
  const double u = across / (length + along + least);
  const double z = u * u;
  double sum = terms[11];
  for (std::size_t k = 11; k-- > 0;) sum = sum * z + terms[k];
  const double acute = 2.0 * u * sum;
  return dot < 0.0 ? std::numbers::pi - acute : acute;
}

}  // namespace inverse_distance
