// SPDX-License-Identifier: MIT
// Searching the unit cube for the point with the largest value, where values are noisy and dear. Knows nothing of
// matches: whoever plays them is asked for the values of points, and says nothing else.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "study/tuning/algorithm.hpp"

namespace regista::study {

using Point = Eigen::VectorXd;  // of the unit cube, as many numbers as there are free parameters, one or more

// Points that are compared with each other.
struct Question {
  std::span<const Point> points;
  // They, and those of every other question of this number, play the same pairs of matches. From 0 on, each new number
  // one more than the largest so far: points of one generation share theirs, the next one gets fresh ones; who needs a
  // deterministic function asks for 0 throughout.
  std::uint64_t pairs = 0;
};

// As many values as there are points; larger is better; finite. None at all: enough, the search ends with what it has,
// as when its budget is used up. What it throws ends the search and is thrown on.
using Evaluate = std::function<std::vector<double>(const Question& question)>;

struct SearchSettings {
  Point start;
  std::uint64_t evaluations = 0;  // of points, at most: no more are asked for
  std::uint64_t seed = 1;
  std::size_t population = 0;  // 0: the algorithm's own
};

struct SearchResult {
  // What it thinks best, first; all different, one to eight. A fixed rule of the algorithm: of those that want
  // replication, the points of the best mean values (of equal ones the earlier); of crs2_lm, isres and esch, those of
  // the best 200 whose neighbours have the best mean value; of spsa and sep_cma_es, their last estimate, means of late
  // ones, and the start.
  std::vector<Point> recommended;
  std::string ended;  // in a few words: "budget used up", "steps became too small"
};

// A function of its arguments and of the answers of `evaluate` alone, also when several threads search at once. The
// start is in the cube; at least least_evaluations() are allowed. One that ends before its budget starts again from the
// best point. What `evaluate` answers that is not finite counts as worse than all that is.
SearchResult search(Algorithm algorithm, const SearchSettings& settings, const Evaluate& evaluate);

}  // namespace regista::study
