// SPDX-License-Identifier: MIT
// The standard normal law from uniform numbers: G. E. P. Box and M. E. Muller, "A Note on the Generation of Random
// Normal Deviates", 1958, in the polar form (Marsaglia and Bray, 1964), which needs no sine. Own, as that of <random>
// differs between libraries. Draws come in pairs, both are used.
#pragma once

#include <cmath>

namespace regista::match {

class NormalLaw {
 public:
  // uniform(): the next number of [0, 1).
  template <class Uniform>
  double draw(Uniform uniform) {
    if (spare_) {
      spare_ = false;
      return second_;
    }
    double x, y, squared;
    do {
      x = 2.0 * uniform() - 1.0;
      y = 2.0 * uniform() - 1.0;
      squared = x * x + y * y;
    } while (squared >= 1.0 || squared == 0.0);
    const double scale = std::sqrt(-2.0 * std::log(squared) / squared);
    second_ = scale * y;
    spare_ = true;
    return scale * x;
  }

 private:
  bool spare_ = false;
  double second_ = 0.0;
};

}  // namespace regista::match
