// SPDX-License-Identifier: MIT
// Two metrics of one name.
#include <array>

#include <regista/context.hpp>
#include <regista/metric.hpp>

namespace {

struct DeclaresTwice {
  static constexpr auto id = "declares_twice", version = "1.0.0", summary = "Declares a metric twice";
  static constexpr std::array metrics{regista::metric("hits", "1", "How often", REGISTA_METRIC_SUM),
                                      regista::metric("hits", "1", "How often again", REGISTA_METRIC_MEAN)};
  bool holds(const regista::Frame&) { return true; }
};

}  // namespace

REGISTA_PLUGIN(DeclaresTwice, regista::context)
