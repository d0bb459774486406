// SPDX-License-Identifier: MIT
#include "study/tuning/populations.hpp"

#include <algorithm>
#include <cassert>

#include "study/tuning/sep_cma_es.hpp"

namespace regista::study {

std::uint64_t first_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population) {
  assert(has_population(algorithm));
  const std::uint64_t n = dimensions;
  switch (algorithm) {
    case Algorithm::crs2_lm:
      return std::max(population == 0 ? 10 * (n + 1) : std::uint64_t{population}, n + 1);  // fewer make no simplex
    case Algorithm::isres:
      return population == 0 ? 20 * (n + 1) : std::uint64_t{population};
    case Algorithm::esch:
      return population == 0 ? 40 : std::uint64_t{population};
    case Algorithm::sep_cma_es:
      return population == 0 ? least_sep_cma_es_population(dimensions) : std::max<std::uint64_t>(population, 2);
    default:
      return 1;
  }
}

std::uint64_t later_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population) {
  const std::uint64_t first = first_generation(algorithm, dimensions, population);
  // ESCH keeps its parents and evaluates half as many children again.
  return algorithm == Algorithm::esch ? std::max<std::uint64_t>(first * 3 / 2, 1) : first;
}

}  // namespace regista::study
