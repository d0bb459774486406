// SPDX-License-Identifier: MIT
#include "study/tuning/search.hpp"

#include <cassert>

#include "study/tuning/inquiry.hpp"
#include "study/tuning/nlopt_search.hpp"
#include "study/tuning/random_search.hpp"
#include "study/tuning/sep_cma_es.hpp"
#include "study/tuning/spsa.hpp"

namespace regista::study {

SearchResult search(Algorithm algorithm, const SearchSettings& settings, const Evaluate& evaluate) {
  assert(settings.start.size() > 0);
  assert(settings.evaluations >= least_evaluations(algorithm, static_cast<std::size_t>(settings.start.size()),
                                                   has_population(algorithm) ? settings.population : 0));
  Inquiry inquiry(evaluate, settings.evaluations);
  switch (algorithm) {
    case Algorithm::spsa:
      return spsa(settings, inquiry, spsa_gains(settings.evaluations / 2));
    case Algorithm::sep_cma_es:
      return sep_cma_es(settings, inquiry);
    case Algorithm::random_search:
      return random_search(settings, inquiry);
    default:
      return nlopt_search(algorithm, settings, inquiry);
  }
}

}  // namespace regista::study
