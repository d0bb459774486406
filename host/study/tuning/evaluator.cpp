// SPDX-License-Identifier: MIT
#include "study/tuning/evaluator.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace regista::study {
namespace {

[[maybe_unused]] bool in_cube(const Point& point) {
  return (point.array() >= 0.0).all() && (point.array() <= 1.0).all();
}

}  // namespace

std::span<const double> Evaluator::ask(std::span<const Point> points, std::uint64_t pairs) {
  assert(!points.empty() && points.size() <= left_);
  assert(std::all_of(points.begin(), points.end(), in_cube));
  const std::vector<double> answer = (*evaluate_)({points, pairs});
  if (answer.empty()) {
    left_ = 0;
    stopped_ = true;
    return {};
  }
  assert(answer.size() == points.size());
  left_ -= points.size();
  for (const double value : answer) {
    if (!std::isfinite(value)) continue;
    least_ = seen_ ? std::min(least_, value) : value;
    greatest_ = seen_ ? std::max(greatest_, value) : value;
    seen_ = true;
  }
  points_.insert(points_.end(), points.begin(), points.end());
  for (const double value : answer) values_.push_back(std::isfinite(value) ? value : worst());
  return std::span(values_).last(points.size());
}

double Evaluator::worst() const {
  if (!seen_) return -1e6;  // there is no value to compare with yet
  const double range = greatest_ - least_;
  const double below = least_ - (range > 0.0 ? range : 1.0 + std::abs(least_));
  return std::max(below, std::numeric_limits<double>::lowest());
}

std::vector<Point> Evaluator::best(std::size_t most) const {
  std::vector<std::size_t> order(points_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::ranges::lexicographical_compare,
                           [&](std::size_t i) -> const Point& { return points_[i]; });
  struct Place {
    std::size_t first;
    double mean;
  };
  std::vector<Place> places;
  for (std::size_t at = 0; at < order.size();) {
    const std::size_t first = order[at];
    double sum = 0.0, number = 0.0;
    for (; at < order.size() && points_[order[at]] == points_[first]; ++at) {
      sum += values_[order[at]];
      number += 1.0;
    }
    places.push_back({first, sum / number});
  }
  const std::size_t wanted = std::min(most, places.size());
  std::partial_sort(
      places.begin(), places.begin() + static_cast<std::ptrdiff_t>(wanted), places.end(),
      [](const Place& a, const Place& b) { return a.mean != b.mean ? a.mean > b.mean : a.first < b.first; });
  std::vector<Point> out;
  for (std::size_t i = 0; i < wanted; ++i) out.push_back(points_[places[i].first]);
  return out;
}

std::vector<Point> distinct(std::span<const Point> points, std::size_t most) {
  std::vector<Point> out;
  for (const Point& point : points) {
    if (out.size() < most && std::find(out.begin(), out.end(), point) == out.end()) out.push_back(point);
  }
  return out;
}

Point mean_of_last(std::span<const Point> points, std::size_t part) {
  assert(!points.empty() && part > 0);
  const std::span<const Point> last = points.last((points.size() + part - 1) / part);
  Point sum = Point::Zero(last.front().size());
  for (const Point& point : last) sum += point;
  return sum / static_cast<double>(last.size());
}

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
    std::sort(nearest.begin(), end);  // makes the order of summation independent of the library
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
