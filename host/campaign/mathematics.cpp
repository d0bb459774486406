// SPDX-License-Identifier: MIT
#include "campaign/mathematics.hpp"

#include <gnu/libc-version.h>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "plugin/content_hash.hpp"

namespace regista::campaign {

std::string mathematics_fingerprint() {
  using Function = double (*)(double);
  constexpr std::array<Function, 10> functions{[](double x) { return std::sin(x); },
                                               [](double x) { return std::cos(x); },
                                               [](double x) { return std::tan(x); },
                                               [](double x) { return std::atan(x); },
                                               [](double x) { return std::exp(x); },
                                               [](double x) { return std::log(1.0 + std::abs(x)); },
                                               [](double x) { return std::asin(x / 8.0); },
                                               [](double x) { return std::tanh(x); },
                                               [](double x) { return std::atan2(x, 1.5 - x); },
                                               [](double x) { return std::pow(1.0 + std::abs(x), 0.37 * x); }};
  std::vector<double> results;
  for (int i = -300; i <= 300; ++i) {
    // Volatile: the compiler must not work it out by itself.
    volatile double x = 0.0257 * i;
    for (const Function function : functions) {
      const double value = function(x);
      results.push_back(std::isnan(value) ? 0.0 : value);
      results.push_back(static_cast<double>(std::sin(static_cast<float>(x))));
    }
  }
  const std::string_view bytes(reinterpret_cast<const char*>(results.data()), results.size() * sizeof(double));
  return std::string(gnu_get_libc_version()) + ' ' + plugin::content_hash(bytes);
}

}  // namespace regista::campaign
