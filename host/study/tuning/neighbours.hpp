// SPDX-License-Identifier: MIT
// Which of many points with one noisy value each is best. The largest value belongs to the luckiest point; the mean
// over a point and those around it is nearly free of luck: regression by nearest neighbours (N. S. Altman, "An
// Introduction to Kernel and Nearest-Neighbor Nonparametric Regression", The American Statistician 46(3), 1992).
#pragma once

#include <span>
#include <vector>

#include "study/tuning/search.hpp"

namespace regista::study {

// Of the candidates, the best by the mean value of their nearest points (2 sqrt(number of points) of them, rounded up;
// of points as far the earlier), first; of equal means the earlier candidate; at most so many. As many values as
// points, one or more.
std::vector<Point> best_by_neighbours(std::span<const Point> points, std::span<const double> values,
                                      std::span<const Point> candidates, std::size_t most);

}  // namespace regista::study
