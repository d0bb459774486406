// SPDX-License-Identifier: MIT
#include "study/tuning/inquiry.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace regista::study {
namespace {

[[maybe_unused]] bool in_cube(const Point& point) {
  return (point.array() >= 0.0).all() && (point.array() <= 1.0).all();
}

bool before(const Point& a, const Point& b) {
  return std::lexicographical_compare(a.data(), a.data() + a.size(), b.data(), b.data() + b.size());
}

}  // namespace

std::span<const double> Inquiry::ask(std::span<const Point> points, std::uint64_t pairs) {
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

double Inquiry::worst() const {
  if (!seen_) return -1e6;  // nothing to compare with yet
  const double range = greatest_ - least_;
  const double below = least_ - (range > 0.0 ? range : 1.0 + std::abs(least_));
  return std::max(below, std::numeric_limits<double>::lowest());
}

std::vector<Point> Inquiry::best(std::size_t most) const {
  std::vector<std::size_t> order(points_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return before(points_[a], points_[b]); });
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

}  // namespace regista::study
