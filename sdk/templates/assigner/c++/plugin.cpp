// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which call it answers.
#include <regista/assigner.hpp>

#include "algorithm.hpp"

namespace {

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0",
                        summary = "The best pair of a free robot and a free task, again and again";

  // Of a frame it reads nothing but what every plugin is shown; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  // An algorithm with a struct of settings: keep the struct here and bind to its members with regista::within().
  double at_least = 0.0;
  static constexpr std::tuple parameters{
      regista::real("at_least", &Plugin::at_least, {0.0, 1.0}, "1", "Pairs of a lower utility are not taken")
          .tunable()};

  BestPairFirst algorithm;

  void assign(const regista::Frame&, regista::UtilityMatrix utilities, regista::Assignment out) {
    algorithm.solve(utilities.rows(), utilities.columns(), utilities, at_least, out);
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::assigner)
