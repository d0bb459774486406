// SPDX-License-Identifier: MIT
#include "study/tuning/neighbours.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace regista::study {

std::vector<Point> best_by_neighbours(std::span<const Point> points, std::span<const double> values,
                                      std::span<const Point> candidates, std::size_t most) {
  assert(!points.empty() && points.size() == values.size());
  const std::size_t wanted =
      std::min(points.size(), static_cast<std::size_t>(std::ceil(2.0 * std::sqrt(static_cast<double>(points.size())))));
  Eigen::MatrixXd columns(points.front().size(), static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = points[i];

  std::vector<std::pair<double, std::size_t>> nearest(points.size());
  Eigen::RowVectorXd distances;
  std::vector<double> means;
  for (const Point& candidate : candidates) {
    distances = (columns.colwise() - candidate).colwise().squaredNorm();
    for (std::size_t i = 0; i < nearest.size(); ++i) nearest[i] = {distances[static_cast<Eigen::Index>(i)], i};
    const auto end = nearest.begin() + static_cast<std::ptrdiff_t>(wanted);
    std::nth_element(nearest.begin(), end - 1, nearest.end());
    std::sort(nearest.begin(), end);  // an order of summation that does not depend on the library
    double sum = 0.0;
    for (std::size_t i = 0; i < wanted; ++i) sum += values[nearest[i].second];
    means.push_back(sum / static_cast<double>(wanted));
  }
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return means[a] > means[b]; });
  std::vector<Point> out;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i) out.push_back(candidates[order[i]]);
  return out;
}

}  // namespace regista::study
