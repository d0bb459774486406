// SPDX-License-Identifier: MIT
// What every search asks through: keeps to the budget, answers with finite values only, and remembers what was asked
// and answered, so that no algorithm's own idea of the best point has to be believed.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "study/tuning/search.hpp"

namespace regista::study {

class Inquiry {
 public:
  // Keeps a reference to `evaluate`.
  Inquiry(const Evaluate& evaluate, std::uint64_t evaluations) : evaluate_(&evaluate), left_(evaluations) {}

  // Evaluations that may still be asked for.
  std::uint64_t left() const { return left_; }

  // Values of the points, larger is better, all finite: one that is not becomes worst(). At most left() points, each in
  // the unit cube. None when `evaluate` had enough: then nothing is left. Throws what `evaluate` throws. Valid until
  // the next call.
  std::span<const double> ask(std::span<const Point> points, std::uint64_t pairs);

  // Why nothing is left, in a few words.
  const char* ended() const { return stopped_ ? "told to stop" : "budget used up"; }

  // As far below the least value seen as that is below the greatest: worse than all, and near enough to them for those
  // who fit models.
  double worst() const;

  // All that was asked so far, in order, and what was answered.
  const std::vector<Point>& points() const { return points_; }
  const std::vector<double>& values() const { return values_; }

  // Of the points asked for, the best by the mean of their values, first; all different, at most so many; of equal
  // means the one that was asked for earlier. None when nothing was answered.
  std::vector<Point> best(std::size_t most) const;

 private:
  const Evaluate* evaluate_;
  std::uint64_t left_;
  bool stopped_ = false;
  std::vector<Point> points_;
  std::vector<double> values_;
  bool seen_ = false;  // a finite value
  double least_ = 0.0, greatest_ = 0.0;
};

// The first of each kind of equal points, in their order, at most so many.
std::vector<Point> distinct(std::span<const Point> points, std::size_t most);

// Of the last of them, a half, a quarter and so on, rounded up. One or more.
Point mean_of_last(std::span<const Point> points, std::size_t part);

// How many points a search recommends at most.
constexpr std::size_t most_recommended = 8;

}  // namespace regista::study
