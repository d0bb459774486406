// SPDX-License-Identifier: MIT
// The search algorithms that a tuning can use, what each needs, and why others cannot be used. Measured properties of
// NLopt 2.7.1 on noisy objectives: docs/tuning.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace regista::study {

enum class Algorithm {
  sbplx,
  bobyqa,
  nelder_mead,
  cobyla,
  crs2_lm,
  direct_l,
  isres,
  esch,           // these by NLopt
  spsa,           // simultaneous perturbation, as testers of chess engines run it
  sep_cma_es,     // separable covariance matrix adaptation
  random_search,  // uniform: what every other one has to beat
};

// "sep_cma_es"; all of them in the order above.
const char* name(Algorithm algorithm);
std::vector<std::string> algorithm_names();
std::optional<Algorithm> algorithm_named(std::string_view name);

// In a few words, for help and reports.
const char* summary(Algorithm algorithm);

// Why an algorithm of NLopt is not offered ("can hang inside NLopt; bobyqa is its successor"), where there is more to
// say than that; nothing for those that are offered. Names as NLopt writes them in any case, with or without the
// beginning NLOPT_, LN_, GN_, LD_, GD_.
std::optional<std::string> why_unsuitable(std::string_view name);

// Compares points as if their values were exact: needs several pairs of matches for each.
bool wants_replication(Algorithm algorithm);

// Evaluations without which it cannot take a step, with this many free dimensions; population 0: its own.
std::uint64_t least_evaluations(Algorithm algorithm, std::size_t dimensions, std::size_t population);

// Whether `population` means anything to it.
bool has_population(Algorithm algorithm);

}  // namespace regista::study
