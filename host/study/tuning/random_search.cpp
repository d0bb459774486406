// SPDX-License-Identifier: MIT
#include "study/tuning/random_search.hpp"

#include <algorithm>
#include <utility>

#include "study/tuning/draws.hpp"

namespace regista::study {

SearchResult random_search(const SearchSettings& settings, Inquiry& inquiry) {
  constexpr std::uint64_t block = 64;  // enough for all workers, few enough for a trace that grows
  Draws draws(settings.seed, Draws::Use::random);
  std::vector<Point> points{settings.start};
  while (inquiry.left() > 0) {
    const std::uint64_t number = std::min(block, inquiry.left());
    while (points.size() < number) {
      Point& point = points.emplace_back(settings.start.size());
      for (double& each : point) each = draws.uniform();
    }
    inquiry.ask(points, 0);
    points.clear();
  }
  std::vector<Point> best = inquiry.best(most_recommended);
  if (best.empty()) best.push_back(settings.start);
  return {std::move(best), inquiry.ended()};
}

}  // namespace regista::study
